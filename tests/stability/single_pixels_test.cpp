// Pixels on which `exact` was wrong once, in images larger than the suite's own. Each stands for a kind of mistake.
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/stability/case_parts.h"
#include "renderer/stability/ray_judge.h"
#include "tests/support/device.h"

namespace relievo::stability::single_pixels_test {
namespace {

struct SinglePixel {
    const char *name, *view;  // of a stability case
    int size, x, y;           // image and pixel
};

constexpr SinglePixel kPixels[] = {
    // Newton's steps lead from where a grazing ray enters a ridge to where it leaves.
    {"cliffs_on_ball", "from outside", 130, 37, 73},
    {"ten_edges_on_ball", "grazing", 192, 95, 49},
    // A root near a patch's border strays by what evaluating S rounds away: over the border, and nobody takes it.
    {"folded_shell_cliffs", "grazing", 130, 31, 25},
    {"folded_shell_cliffs", "grazing", 130, 29, 42},
    {"folded_shell_cliffs", "grazing", 130, 29, 54},
    {"folded_shell_cliffs", "from below", 130, 67, 56},
};

void expect_right(const Case& extreme, const SinglePixel& pixel) {
    SCOPED_TRACE(std::string(pixel.name) + ", " + pixel.view);
    const auto view = std::find_if(extreme.views.begin(), extreme.views.end(),
                                   [&](const NamedView& v) { return v.name == pixel.view; });
    ASSERT_NE(view, extreme.views.end());
    const std::vector<HeightView> maps = extreme.maps();
    RenderSettings settings;
    settings.width = settings.height = pixel.size;
    settings.method = "exact";
    Renderer renderer(test::device(), extreme.scene(*view), maps, settings);
    const Ray ray = renderer.camera_ray(pixel.x + 0.5, pixel.y + 0.5);
    const ReferenceSurface reference = extreme.reference();
    const RayJudge judge(extreme, reference, {"pixel", {ray}});
    const ImageComparison errors = judge.compare(renderer.pick(std::span(&ray, 1)));
    EXPECT_EQ(errors.missed + errors.invented + errors.unexplained, 0);
}

TEST(SinglePixels, ExactIsRight) {
    for (const SinglePixel& pixel : kPixels) expect_right(find_case(pixel.name).make(), pixel);
}

// Too slow to see from everywhere: 35,000 texels of noise in each of 30 triangles, several times as high as they are wide.
TEST(SinglePixels, ExactIsRightWhereARayMeetsHundredsOfThousandsOfPatches) {
    expect_right(on_lump(3, 0.5, noise_map(1024, 1024)), {"noise of amplitude 3 on a lump", "from inside", 48, 18, 5});
}

}  // namespace
}  // namespace relievo::stability::single_pixels_test
