// The layers that a method's renderer gives for one object, on a device that all tests of a program share.
#pragma once

#include <vector>

#include "renderer/renderer.h"

namespace relievo::test {

struct MethodImages {
    std::vector<float> depth, normal;
};

// `pdm` at dt 0.001 without jitter, `size` pixels a side. The scene has one object.
MethodImages pdm_images(const Scene& scene, const HeightView& map, int size);

}  // namespace relievo::test
