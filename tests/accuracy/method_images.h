// The layers that a method's renderer gives for one object, on a device that all tests of a program share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "renderer/renderer.h"

namespace relievo::test {

struct MethodUnderTest {
    std::string name;  // in the registry
    std::map<std::string, double> parameters;
};

inline MethodUnderTest exact_method() {
    return {"exact", {}};
}
inline MethodUnderTest pdm_method() {
    return {"pdm", {{"dt", 0.001}, {"jitter", 0}}};
}

struct MethodImages {
    std::vector<float> depth, normal;
};

// `size` pixels a side. The scene has one object.
MethodImages method_images(const Scene& scene, const HeightView& map, int size,
                           const MethodUnderTest& method);

}  // namespace relievo::test
