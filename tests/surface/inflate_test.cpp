// Inflate over thin objects: its rise follows the slope of the side that the texel is on.
#include <gtest/gtest.h>

#include <vector>

#include "brushes/sculptor.h"
#include "editor/session/surface/mesh_surface.h"
#include "test_meshes.h"

namespace relievo::inflate_test {
namespace {

using namespace test;

constexpr float kAmplitude = 0.3f;

Dab dab_near(const MeshSurface& surface, const glm::dvec3& place) {
    const FacePoint at = surface.nearest_on_base(place);
    Dab dab;
    dab.face = at.face, dab.b1 = at.b1, dab.b2 = at.b2;
    return dab;
}

// Two sheets back to back, nearer than a texel.
TEST(Inflate, what_lies_on_the_far_side_of_a_thin_object_does_not_count) {
    MeshBuilder builder;
    const auto corner = [](float x, float y, float z) {
        return MeshBuilder::Corner{{x, y, z}, {z < 0 ? 0.9f - 0.3f * x : 0.1f + 0.3f * x, 0.1f + 0.3f * y}};
    };
    constexpr float kThin = 0.002f;
    builder.quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0));
    builder.quad(corner(0, 1, -kThin), corner(1, 1, -kThin), corner(1, 0, -kThin), corner(0, 0, -kThin));
    const Mesh mesh = builder.build();
    const auto inflated = [&](double behind) {
        HeightMap map(256, 256);
        const MeshSurface surface(mesh, displacement(double{kAmplitude}), map);
        set_owned(map, surface, [&](const glm::dvec3& p) {
            return p.z < -0.5 * double{kThin} ? 32768 + behind * p.y : 32768 + 40000 * (p.x - 0.5);
        });
        Sculptor sculptor(map, surface);
        Brush brush;
        brush.tool = Tool::inflate;
        brush.radius = 0.2f;
        sculptor.begin(brush);
        for (int i = 0; i < 4; ++i) sculptor.dab(dab_near(surface, {0.5, 0.5, 0.01}));
        sculptor.end();
        std::vector<std::uint16_t> front;
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) front.push_back(map.at(x, y));
        return front;
    };
    const auto even = inflated(0);
    EXPECT_EQ(even, inflated(2000));
    EXPECT_EQ(even, inflated(-1000));
}

}  // namespace
}  // namespace relievo::inflate_test
