// `dbvh` over procedural heights with thousands of tiles across one triangle: a ray that would need more boxes than it may
// take ends at a coarser one. None passes through.
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/methods/registry.h"
#include "renderer/stability/case_parts.h"
#include "tests/support/device.h"

namespace relievo::stability::extreme_tilings_test {
namespace {

constexpr int kSize = 10;  // pixels a side
constexpr double kAmplitude = 0.05;

Case tiled_plane(double tiles) {
    Case c = on_mesh(plane_mesh(tiles / Procedural::kMostScale), {}, kAmplitude, 0.5, dunes_map(32, 32));
    c.views = {{"grazing", {-0.4, -0.3, 0.16}, {0.6, 0.6, 0}},
               {"along the ground", {0.5, 0.5, 0.12}, {0.9, 0.8, 0.08}},
               {"within the relief", {-0.05, 0.5, 0.55 * kAmplitude}, {1, 0.52, 0.3 * kAmplitude}}};
    Procedural& tiling = c.objects[0].procedural.emplace();
    tiling.scale = Procedural::kMostScale;
    tiling.triangle_size = 1;
    tiling.seed = 3;
    tiling.offset = {0.3, -7.6};
    return c;
}

struct Tiling {
    const char* name;
    double tiles, range;
};

class ExtremeTilings : public testing::TestWithParam<Tiling> {};

TEST_P(ExtremeTilings, NoRayPassesForWantOfBoxes) {
    const Tiling& tiling = GetParam();
    const Case surface = tiled_plane(tiling.tiles);
    const ReferenceSurface reference = surface.reference();
    const std::vector<HeightView> maps = surface.maps();
    RenderSettings settings;
    settings.width = settings.height = kSize;
    settings.method = "dbvh";
    settings.parameters = {{"range", tiling.range}};
    Renderer renderer(test::device(), surface.scene(surface.views[0]), maps, settings);
    float most_steps = 0;
    for (const NamedView& view : surface.views) {
        SCOPED_TRACE(view.name);
        const Scene scene = surface.scene(view);
        const ReferenceImage image = trace_image(reference, scene.camera, scene.origin, kSize, kSize);
        renderer.set_camera(scene.camera);
        const std::vector<float> depth = renderer.read_back(Layer::depth), counts = renderer.read_back(Layer::counts);
        int missed = 0, outside = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const Ray ray = renderer.camera_ray(double(i % kSize) + 0.5, double(i / kSize) + 0.5);
            missed += std::isfinite(image.depth[i]) && !std::isfinite(depth[i]);
            const double height = double(ray.origin.z) + double(ray.direction.z) * double(depth[i]);
            outside += std::isfinite(depth[i]) && std::abs(height) > 0.501 * kAmplitude;
            EXPECT_LE(counts[4 * i + 1], counts[4 * i] * float(find_method("dbvh").most_steps));
            most_steps = std::max(most_steps, counts[4 * i + 1]);
        }
        EXPECT_EQ(missed, 0);
        EXPECT_EQ(outside, 0);
    }
    EXPECT_GT(most_steps, 120000) << "the case no longer asks for more boxes than there are";
}

INSTANTIATE_TEST_SUITE_P(Tilings, ExtremeTilings,
                         testing::Values(Tiling{"range_256", 12000, 256}, Tiling{"range_512", 6000, 512},
                                         Tiling{"texels", 100000, 0}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace relievo::stability::extreme_tilings_test
