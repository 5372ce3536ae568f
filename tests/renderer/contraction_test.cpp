// Every shader of the build rounds each operation by itself, and nothing else of its module changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <spirv/unified1/spirv.hpp>
#include <stdexcept>

#include "renderer/vulkan/contraction.h"
#include "renderer/vulkan/programs.h"
#include "tests/renderer/device.h"

namespace relievo::test::contraction_test {
namespace {

using Words = std::vector<std::uint32_t>;

std::uint32_t head(std::size_t words, std::uint32_t op) { return static_cast<std::uint32_t>(words) << 16 | op; }

// float f(a) { return a + a; } in the least of words, its sum decorated or not.
Words module_of_one_sum(bool decorated) {
    Words words{spv::MagicNumber, 0x10500, 0, 20, 0, head(3, spv::OpMemoryModel), 0, 1};
    if (decorated) words.insert(words.end(), {head(3, spv::OpDecorate), 9, spv::DecorationNoContraction});
    words.insert(words.end(), {head(3, spv::OpTypeFloat), 1, 32, head(5, spv::OpFAdd), 1, 9, 8, 8});
    return words;
}

TEST(Contraction, IsForbiddenOnceForEachOperation) {
    EXPECT_EQ(vulkan::without_contraction(module_of_one_sum(false)), module_of_one_sum(true));
    EXPECT_EQ(vulkan::without_contraction(module_of_one_sum(true)), module_of_one_sum(true));
}

TEST(Contraction, OfWhatIsNoModuleIsRefused) {
    const Words whole = module_of_one_sum(false);
    EXPECT_THROW(vulkan::without_contraction({}), std::runtime_error);
    EXPECT_THROW(vulkan::without_contraction(Words(20, 7u)), std::runtime_error);
    EXPECT_THROW(vulkan::without_contraction(Words(whole.begin(), whole.end() - 1)), std::runtime_error);
    Words no_length = whole;
    no_length[5] = spv::OpMemoryModel;
    EXPECT_THROW(vulkan::without_contraction(no_length), std::runtime_error);
}

TEST(Contraction, IsForbiddenInEveryShader) {
    for (const std::string& method : method_names())
        for (const char* file : {"beauty.comp", "aov_bvh.comp", "pick.comp", "hit.rint", "beauty.rgen"}) {
            SCOPED_TRACE(method + " " + file);
            const auto given = vulkan::shader_code(method, file);
            ASSERT_FALSE(given.empty());
            const Words changed = vulkan::without_contraction(given);
            EXPECT_GT(changed.size(), given.size() + 3 * 10);
            EXPECT_EQ((changed.size() - given.size()) % 3, 0u);
            EXPECT_EQ(vulkan::without_contraction(changed), changed);
        }
}

}  // namespace
}  // namespace relievo::test::contraction_test
