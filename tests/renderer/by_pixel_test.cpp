// dbvh's target level of detail by a pixel's footprint: true to a pixel, and cheaper than the map's own texels.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/renderer/device.h"

namespace relievo::test::by_pixel_test {
namespace {

TEST(DbvhByPixel, StaysWithinAPixelOfTheSurfaceAndTakesFewerSteps) {
    const Scene scene = make_scene(ball_mesh(), 0.2);
    const TestMap map = bumps(512);  // its texels are smaller than the image's pixels
    RenderSettings settings = settings_of(scene);
    settings.method = "dbvh";
    Renderer renderer = make_renderer(scene, map, settings);
    const std::vector<float> exact = renderer.read_back(Layer::depth), all = renderer.read_back(Layer::counts);
    renderer.set_method("dbvh", {{"by_pixel", 1}});
    const std::vector<float> depth = renderer.read_back(Layer::depth), fewer = renderer.read_back(Layer::counts);

    const double spread = 2 * std::tan(scene.camera.fov_deg * std::acos(-1.0) / 360) / settings.height;
    std::vector<double> errors;  // in pixels, as wide as they are where the ray ends
    int missed = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        missed += std::isfinite(exact[i]) && !std::isfinite(depth[i]);
        if (std::isfinite(exact[i]) && std::isfinite(depth[i]))
            errors.push_back(std::abs(double{depth[i]} - double{exact[i]}) / (spread * double{exact[i]}));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_GT(errors.size(), 1000u);
    EXPECT_EQ(missed, 0);
    EXPECT_LT(errors[errors.size() / 2], 1);
    EXPECT_LT(errors[errors.size() * 9 / 10], 1.5);  // a box's diagonal is longer than its sides
    const auto cost = [](const std::vector<float>& counts) { return std::accumulate(counts.begin(), counts.end(), 0.0); };
    EXPECT_LT(cost(fewer), 0.9 * cost(all));
}

}  // namespace
}  // namespace relievo::test::by_pixel_test
