// One validated context for all tests of the program: what it compiled for one of them serves the others.
#pragma once

#include "renderer/vulkan/context.h"

namespace relievo::test {

inline vulkan::Context& device() {
    static vulkan::Context context({.device = "", .validation = true, .for_window = false});
    return context;
}

}  // namespace relievo::test
