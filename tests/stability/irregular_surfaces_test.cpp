// `dbvh` against the reference on irregular surfaces drawn at random: bilinear leaves miss nothing away from silhouettes and
// agree to 1e-4 of the amplitude at the median; the walk of a procedural source's lattice, which is coarser, misses nothing.
#include <gtest/gtest.h>

#include "renderer/judge/judge.h"
#include "renderer/stability/float_floor.h"
#include "tests/stability/irregular_surfaces.h"
#include "tests/support/device.h"

namespace relievo::stability::irregular_surfaces_test {
namespace {

constexpr unsigned kSeeds = 60;
constexpr int kSize = 40;  // pixels a side

ImageComparison compare(const Case& c, std::size_t view, double range) {
    const Scene scene = c.scene(c.views[view]);
    const ReferenceSurface surface = c.reference();
    ReferenceImage image = trace_image(surface, scene.camera, scene.origin, kSize, kSize);
    double reach = 0;
    for (const double z : image.depth)
        if (std::isfinite(z)) reach = std::max(reach, z);
    const Judge judge(std::move(image), scene.camera, scene.origin, float_units(c, c.views[view].eye, reach));
    RenderSettings settings;
    settings.width = settings.height = kSize;
    settings.method = "dbvh";
    settings.parameters = {{"range", range}};
    const std::vector<HeightView> maps = c.maps();
    Renderer renderer(test::device(), scene, maps, settings);
    return judge.compare(renderer.read_back(Layer::depth), renderer.read_back(Layer::normal));
}

// Parts of a texel or more make a surface of their own, whose outline lies elsewhere; and a part is solved as a whole, where
// high relief on slivers wants it divided.
bool fine_enough(const SampleSurface& surface, double range) {
    if (!surface.procedural || std::abs(surface.amplitude) > 0.1) return false;
    return surface.procedural->triangle_size * std::max(surface.width, surface.height) / range <= 0.5;
}

class IrregularSurfaces : public testing::TestWithParam<unsigned> {};

TEST_P(IrregularSurfaces, DbvhMissesNothing) {
    for (const bool procedural : {false, true}) {
        const IrregularCase drawn = irregular_case(GetParam(), procedural);
        for (const double range : {0.0, 64.0}) {
            if (range > 0 && !fine_enough(drawn.surface.objects[0], range)) continue;
            for (std::size_t view = 0; view < drawn.surface.views.size(); ++view) {
                const ImageComparison errors = compare(drawn.surface, view, range);
                SCOPED_TRACE(drawn.what + ", view " + drawn.surface.views[view].name + ", range " + std::to_string(range) +
                             ": " + errors.text());
                EXPECT_EQ(errors.missed, 0);
                EXPECT_EQ(errors.not_finite, 0);
                if (range > 0) continue;
                EXPECT_EQ(errors.invented, 0);
                EXPECT_LE(errors.depth.median, 1e-4);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, IrregularSurfaces, testing::Range(0u, kSeeds));

}  // namespace
}  // namespace relievo::stability::irregular_surfaces_test
