// See contraction.h.
#include "renderer/vulkan/contraction.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_set>

#include <spirv/unified1/spirv.hpp>

namespace relievo::vulkan {
namespace {

constexpr std::size_t kHeaderWords = 5;

// Of those that SPIR-V calls arithmetic; extended instructions (sqrt, fma) round as they say.
bool may_be_contracted(spv::Op op) {
    switch (op) {
        case spv::OpFNegate:
        case spv::OpFAdd:
        case spv::OpFSub:
        case spv::OpFMul:
        case spv::OpFDiv:
        case spv::OpFRem:
        case spv::OpFMod:
        case spv::OpVectorTimesScalar:
        case spv::OpMatrixTimesScalar:
        case spv::OpVectorTimesMatrix:
        case spv::OpMatrixTimesVector:
        case spv::OpMatrixTimesMatrix:
        case spv::OpOuterProduct:
        case spv::OpDot: return true;
        default: return false;
    }
}

// Decorations end where types begin; every module that computes has types.
bool begins_types(spv::Op op) { return op >= spv::OpTypeVoid && op <= spv::OpTypePipe; }

}  // namespace

std::vector<std::uint32_t> without_contraction(std::span<const std::uint32_t> module) {
    if (module.size() < kHeaderWords || module[0] != spv::MagicNumber)
        throw std::runtime_error("a shader is no SPIR-V module");
    std::vector<std::uint32_t> operations;
    std::unordered_set<std::uint32_t> decorated;
    std::size_t types = module.size();
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const std::size_t words = module[at] >> spv::WordCountShift;
        if (words == 0 || at + words > module.size()) throw std::runtime_error("a shader's SPIR-V module is cut off");
        const auto op = static_cast<spv::Op>(module[at] & spv::OpCodeMask);
        if (op == spv::OpDecorate && words == 3 && module[at + 2] == spv::DecorationNoContraction)
            decorated.insert(module[at + 1]);
        if (begins_types(op)) types = std::min(types, at);
        if (may_be_contracted(op)) operations.push_back(module[at + 2]);  // type, result, operands
        at += words;
    }
    std::vector<std::uint32_t> result(module.begin(), module.begin() + static_cast<std::ptrdiff_t>(types));
    for (const std::uint32_t id : operations)
        if (!decorated.contains(id))
            result.insert(result.end(), {(3u << spv::WordCountShift) | std::uint32_t{spv::OpDecorate}, id,
                                         std::uint32_t{spv::DecorationNoContraction}});
    result.insert(result.end(), module.begin() + static_cast<std::ptrdiff_t>(types), module.end());
    return result;
}

}  // namespace relievo::vulkan
