// The tests' small meshes and maps are those of the stability suite.
#pragma once

#include "renderer/stability/sample_surfaces.h"

namespace relievo::test {
using namespace relievo::stability;
}  // namespace relievo::test
