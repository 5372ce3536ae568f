// A scene file rendered by the double-precision reference, without a device: several objects, holes, far from
// 0.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "brushes/map_file.h"
#include "editor/session/reference_output.h"
#include "editor/session/reference_scene.h"
#include "editor/session/scene_input.h"
#include "tests/session/test_scene.h"

namespace relievo::reference_render_test {
namespace {

constexpr double kFar = 1e5;  // of the scene from the world's zero, on each axis
constexpr int kSize = 32;

std::string square_obj(double z) {
    std::ostringstream obj;
    obj.precision(17);
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
        obj << "v " << kFar + x << " " << kFar + y << " " << kFar + z << "\nvt " << x << " " << y << "\n";
    obj << "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    return obj.str();
}

class ReferenceRender : public testing::Test {
  protected:
    // A square at height 1, raised by 0.25 over its map of ones and open where v < 1/2, over one at height 0.
    ReferenceRender() {
        test::write_text(path("upper.obj"), square_obj(1));
        test::write_text(path("lower.obj"), square_obj(0));
        save_map(HeightMap(3, 2, 65535), path("ones.tif"), MapFormat::tiff16);
        DisplayPicture holes{8, 8, {}};
        for (int i = 0; i < 8 * 8 * 4; ++i) holes.rgba.push_back(i < 8 * 4 * 4 ? 255 : 0);
        write_png(path("holes.png"), holes);
        test::write_text(path("scene.json"), R"({"relievo": 1, "objects": [
            {"mesh": "upper.obj", "opacity_map": "holes.png",
             "displacement": {"map": "ones.tif", "amplitude": 0.25, "midlevel": 0, "wrap": "clamp"}},
            {"mesh": "lower.obj", "displacement": {"size": 4, "amplitude": 0.5}}],
            "camera": {"eye": [100000.5, 100000.5, 100004], "look_at": [100000.5, 100000.5, 100000],
                       "up": [0, 1, 0], "fov_deg": 12}})");
    }

    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

    ReferenceImage trace() const {
        const ReferenceScene reference(open_scene(path("scene.json")));
        const Scene& scene = reference.scene();
        return trace_image(reference.surface(), scene.camera, scene.origin, kSize, kSize);
    }

    test::TemporaryFolder folder_;
};

TEST_F(ReferenceRender, SeveralObjectsWithHolesFarAwayLieWhereTheyShould) {
    const ReferenceImage image = trace();
    EXPECT_EQ(image.undecided, 0u);
    const std::vector<float> depth = reference_layer(image, Layer::depth),
                             id = reference_layer(image, Layer::id), uv = reference_layer(image, Layer::uv),
                             normal = reference_layer(image, Layer::normal);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const auto i = static_cast<std::size_t>(y * kSize + x);
            // The picture's upper half sees v > 1/2, where the upper square is solid.
            const double drop = y < kSize / 2 ? 2.75 : 4;
            const double half = std::tan(std::acos(-1.0) / 30);
            const double dx = ((x + 0.5) / kSize * 2 - 1) * half, dy = (1 - (y + 0.5) / kSize * 2) * half;
            ASSERT_EQ(id[i], y < kSize / 2 ? 1.0f : 2.0f) << x << " " << y;
            EXPECT_NEAR(static_cast<double>(depth[i]), drop * std::sqrt(1 + dx * dx + dy * dy), 1e-5);
            EXPECT_NEAR(static_cast<double>(uv[2 * i]), 0.5 + dx * drop, 1e-6);
            EXPECT_NEAR(static_cast<double>(uv[2 * i + 1]), 0.5 + dy * drop, 1e-6);
            EXPECT_NEAR(static_cast<double>(normal[3 * i + 2]), 1, 1e-6);
        }
    }
}

TEST_F(ReferenceRender, TheHeadLightIsGreyByTheCosineAndEmptyWhereNothingIsHit) {
    ReferenceImage image = trace();
    image.object[5] = 0;
    image.normal[5] = glm::dvec3(0);
    const std::vector<float> light = head_light(image, open_scene(path("scene.json")).camera);
    EXPECT_EQ(light[5 * 4], 0.0f);
    EXPECT_EQ(light[5 * 4 + 3], 0.0f);
    const std::size_t middle = (kSize / 2 * kSize + kSize / 2) * 4;
    EXPECT_GT(light[middle], 0.999f);
    EXPECT_LT(light[0], 0.995f);
    EXPECT_EQ(light[middle + 3], 1.0f);
}

TEST_F(ReferenceRender, PicturesHoldTheLayersThatTheReferenceHas) {
    const ReferenceImage image = trace();
    const Camera camera = open_scene(path("scene.json")).camera;
    write_reference(image, camera, path("a.exr"), parse_aovs("Z,N,uv,id"));
    write_reference(image, camera, path("a.png"), {});
    EXPECT_EQ(read_display_picture(path("a.png")).width, kSize);
    EXPECT_THROW(check_reference_output(path("a.exr"), parse_aovs("Z,Ns")), std::invalid_argument);
    EXPECT_THROW(check_reference_output(path("a.png"), parse_aovs("Z")), std::invalid_argument);
}

TEST_F(ReferenceRender, MapsThatCannotBeReadAreNamed) {
    test::write_text(path("holes.png"), "no picture");
    try {
        const ReferenceScene reference(open_scene(path("scene.json")));
        FAIL() << "a damaged opacity map was read";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("holes.png"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace relievo::reference_render_test
