// The passes: what a renderer answers with, each by a program of its own, which is compiled when it is first asked for.
#pragma once

#include <cstddef>

namespace relievo::vulkan {

enum class Pass {
    beauty,
    aov,
    pick,
    counts,  // aov, counting what each pixel's ray costs
    notes,   // pick of one ray, logged
};
constexpr std::size_t kPassCount = 5;

}  // namespace relievo::vulkan
