// The verb `render` by its two ways: a method on the device, or the reference on the processor.
#pragma once

#include <string>

#include "editor/cli/verbs.h"

namespace relievo {

inline constexpr const char* kReferenceMethod = "reference";

struct RenderOptions {
    std::string scene, out, aov;
    CommonOptions common;
    MethodOptions method;
    PictureOptions picture;
};

// Needs no device. Throws std::invalid_argument.
int run_reference_render(const RenderOptions& options);

}  // namespace relievo
