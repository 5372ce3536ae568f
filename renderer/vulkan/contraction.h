// Rounding that does not depend on how a shader was compiled. A compiler may contract a * b + c into one operation that
// rounds once, wherever it likes: then two programs that trace the same ray, one specialised and one not, answer a little
// apart, and what was proved of an expression that rounds twice (a ray on the border of two texels belongs to one of
// them) does not hold. GLSL can forbid it variable by variable (`precise`); we forbid it in whole modules.
// Source: SPIR-V specification, decoration NoContraction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace relievo::vulkan {

// The SPIR-V module with NoContraction on every floating-point operation that has none. Throws std::runtime_error
// where the words are no module.
std::vector<std::uint32_t> without_contraction(std::span<const std::uint32_t> module);

}  // namespace relievo::vulkan
