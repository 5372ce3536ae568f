// The method dbvh's shader code as C++ in float.
#pragma once

#include "tests/support/shader_in_float.h"

namespace relievo::dbvh {

using namespace shader_in_float;

#include "shaders/methods/dbvh/intersect.glsl"

}  // namespace relievo::dbvh
