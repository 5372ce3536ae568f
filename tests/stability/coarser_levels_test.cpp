// `dbvh` with `level` is the surface of a coarser map: of every 2^level-th texel and what lies bilinearly between. Judged by
// the reference over the map filled in so, on irregular surfaces drawn at random.
#include <gtest/gtest.h>

#include "renderer/judge/judge.h"
#include "renderer/stability/float_floor.h"
#include "tests/stability/irregular_surfaces.h"
#include "tests/support/device.h"

namespace relievo::stability::coarser_levels_test {
namespace {

constexpr unsigned kSeeds = 24;
constexpr int kSize = 40;  // pixels a side

int whole_cells(int texels, int cell) { return (texels + cell - 1) / cell * cell; }

// Sides that `cell` divides, repeating, and heights that it divides between two of them without a rest.
void make_divisible(SampleSurface& surface, int cell) {
    const SampleSurface old = surface;
    surface.wrap = Wrap::repeat;
    surface.width = whole_cells(old.width, cell);
    surface.height = whole_cells(old.height, cell);
    surface.texels.clear();
    for (int y = 0; y < surface.height; ++y)
        for (int x = 0; x < surface.width; ++x) {
            const int from = y % old.height * old.width + x % old.width;
            const int count = old.texels[static_cast<std::size_t>(from)];
            surface.texels.push_back(static_cast<std::uint16_t>(count / (cell * cell) * (cell * cell)));
        }
}

// The texels between every cell-th one, filled in.
SampleSurface coarser(const SampleSurface& fine, int cell) {
    SampleSurface surface = fine;
    const auto corner = [&](int x, int y) {
        return int(fine.texels[static_cast<std::size_t>(y % fine.height * fine.width + x % fine.width)]);
    };
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x) {
            const int i = x % cell, j = y % cell, x0 = x - i, y0 = y - j;
            const int low = (cell - i) * corner(x0, y0) + i * corner(x0 + cell, y0);
            const int high = (cell - i) * corner(x0, y0 + cell) + i * corner(x0 + cell, y0 + cell);
            surface.texels[static_cast<std::size_t>(y * fine.width + x)] =
                static_cast<std::uint16_t>(((cell - j) * low + j * high) / (cell * cell));
        }
    return surface;
}

class CoarserLevels : public testing::TestWithParam<unsigned> {};

TEST_P(CoarserLevels, AreTheSurfaceOfACoarserMap) {
    const int level = 1 + static_cast<int>(GetParam() % 3), cell = 1 << level;
    IrregularCase drawn = irregular_case(GetParam(), false);
    Case& fine = drawn.surface;
    make_divisible(fine.objects[0], cell);
    Case coarse = fine;
    coarse.objects[0] = coarser(fine.objects[0], cell);
    const ReferenceSurface surface = coarse.reference();
    const std::vector<HeightView> maps = fine.maps();
    RenderSettings settings;
    settings.width = settings.height = kSize;
    settings.method = "dbvh";
    settings.parameters = {{"level", level}};
    Renderer renderer(test::device(), fine.scene(fine.views[0]), maps, settings);
    for (const NamedView& view : fine.views) {
        const Scene scene = fine.scene(view);
        ReferenceImage image = trace_image(surface, scene.camera, scene.origin, kSize, kSize);
        double reach = 0;
        for (const double z : image.depth)
            if (std::isfinite(z)) reach = std::max(reach, z);
        const Judge judge(std::move(image), scene.camera, scene.origin, float_units(coarse, view.eye, reach));
        renderer.set_camera(scene.camera);
        const std::vector<float> depth = renderer.read_back(Layer::depth);
        ImageComparison errors = judge.compare(depth, renderer.read_back(Layer::normal));
        SCOPED_TRACE(drawn.what + ", view " + view.name + ", level " + std::to_string(level) + ": " + errors.text());
        EXPECT_EQ(errors.missed + errors.invented, 0);
        EXPECT_LE(errors.depth.median, 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CoarserLevels, testing::Range(0u, kSeeds));

}  // namespace
}  // namespace relievo::stability::coarser_levels_test
