// Two renderers over one session, and the report of a ray; on a device.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>

#include "editor/session/ray_report.h"
#include "editor/session/render_output.h"
#include "renderer/methods/registry.h"
#include "tests/session/on_device.h"

namespace relievo::comparing_test {
namespace {

class Comparing : public test::OnDevice {
  protected:
    static SessionOptions on_device() { return OnDevice::on_device(96, 72); }
};

TEST_F(Comparing, TheSecondRendererFollowsEveryCommandButTheMethods) {
    Session session(test::write_scene(folder_.path()), on_device());
    const std::string first = methods()[0]->name.data(), second = methods()[1]->name.data();
    session.set("method", first);
    Renderer& other = session.compare_with({second, {}});
    session.brush().strength = 1;
    test::sculpt(session, 4, 20);
    session.set("amplitude", 0.3);
    Camera camera = session.scene().camera;
    camera.eye.x += 0.2;
    session.set_camera(camera);
    const auto depth = other.read_back(Layer::depth), of_first = session.renderer().read_back(Layer::depth);
    EXPECT_NE(depth, of_first);
    session.set("method", second);
    EXPECT_EQ(session.renderer().read_back(Layer::depth), depth);
    session.compare_with({first, {}});
    EXPECT_EQ(other.read_back(Layer::depth), of_first);
    session.stop_comparing();
    test::sculpt(session, 2);
}

TEST_F(Comparing, APictureOfBothHoldsEachOnItsSide) {
    Session session(test::write_scene(folder_.path()), on_device());
    session.set("method", "exact");
    Renderer &first = session.renderer(), &second = session.compare_with({"pdm", {{"dt", 0.1}}});
    first.render(), second.render();
    const RenderPart parts[] = {{&first, 0, 40}, {&second, 40, 96}};
    const auto path = folder_.path() / "both.png";
    write_render(parts, path, {});
    const DisplayPicture both = read_display_picture(path);
    const auto left = first.read_back_display(), right = second.read_back_display();
    ASSERT_NE(left, right);
    ASSERT_EQ(both.width, 96);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < both.rgba.size(); ++i) wrong += both.rgba[i] != (i / 4 % 96 < 40 ? left : right)[i];
    EXPECT_EQ(wrong, 0u);

    const auto layers = folder_.path() / "both.exr";
    write_render(parts, layers, {Layer::depth});
    const auto input = OIIO::ImageInput::open(layers.string());
    ASSERT_TRUE(input);
    std::vector<float> values(96 * 72 * 5);
    ASSERT_TRUE(input->read_image(0, 0, 0, 5, OIIO::TypeDesc::FLOAT, values.data()));
    const auto z = static_cast<std::size_t>(input->spec().channelindex("Z"));
    const auto red = static_cast<std::size_t>(input->spec().channelindex("R"));
    const auto left_z = first.read_back(Layer::depth), right_z = second.read_back(Layer::depth);
    const auto left_light = first.read_back(Layer::beauty), right_light = second.read_back(Layer::beauty);
    ASSERT_NE(left_z, right_z);
    for (std::size_t i = 0; i < 96 * 72; ++i) {
        wrong += values[i * 5 + z] != (i % 96 < 40 ? left_z : right_z)[i];
        wrong += values[i * 5 + red] != (i % 96 < 40 ? left_light : right_light)[i * 4];
    }
    EXPECT_EQ(wrong, 0u);

    test::sculpt(session, 4, 20);
    render_afresh(parts);
    const auto fresh = first.read_back(Layer::beauty);
    EXPECT_NE(fresh, left_light);
    first.restart();
    first.render();
    const auto whole = first.read_back(Layer::beauty);
    for (std::size_t i = 0; i < fresh.size(); ++i)
        if (i / 4 % 96 < 40) wrong += fresh[i] != whole[i];
    EXPECT_EQ(wrong, 0u);

    second.resize(48, 36);
    EXPECT_THROW(write_render(parts, path, {}), std::invalid_argument);
}

TEST_F(Comparing, MapsOfObjectsThatAreNotEditedAreThereForAnotherMethod) {
    test::write_scene(folder_.path());
    test::write_text(folder_.path() / "two.json", R"({"relievo": 1, "objects": [
 {"mesh": "sheet.obj", "displacement": {"map": "map.tif", "amplitude": 0.2}},
 {"mesh": "sheet.obj", "displacement": {"map": "map.tif", "amplitude": -0.4}, "transform": {"translate": [0, 0, -1]}}]})");
    Session session(folder_.path() / "two.json", on_device());
    EXPECT_EQ(session.map_of(1).hash(), session.map_of(0).hash());
    for (const Method* method : methods()) {
        session.set("method", std::string(method->name));
        session.compare_with({std::string(method->name), {}});
        EXPECT_FALSE(session.renderer().read_back(Layer::depth).empty());
    }
}

TEST_F(Comparing, ARaysReportEndsWhereThePixelShows) {
    Session session(test::write_scene(folder_.path()), on_device());
    const Scene& scene = session.scene();
    for (const Method* method : methods()) {
        session.set("method", std::string(method->name));
        const auto depth = session.renderer().read_back(Layer::depth);
        const RayReport report = report_ray(session.renderer(), std::string(method->name), {48, 36});
        ASSERT_TRUE(report.hit) << method->name;
        EXPECT_FLOAT_EQ(static_cast<float>(report.distance), depth[36 * 96 + 48]);
        ASSERT_TRUE(report.hit_visit);
        const RayReport::Visit& visit = report.visits[*report.hit_visit];
        EXPECT_GT(visit.steps + visit.cells, 0u);
        const std::string text = full_text(report, std::nullopt, scene);
        EXPECT_NE(text.find("triangle " + std::to_string(visit.face)), std::string::npos) << text;
        EXPECT_NE(text.find("by method " + std::string(method->name)), std::string::npos) << text;

        ReferenceVerdict verdict;
        verdict.hit = ReferenceHit{};
        verdict.hit->t = report.distance + 0.02;
        const std::string beside = describe(report, verdict, scene).back();
        EXPECT_NE(beside.find("depth error 0.1 of the amplitude"), std::string::npos) << beside;

        const RayReport corner = report_ray(session.renderer(), std::string(method->name), {0, 0});
        EXPECT_FALSE(corner.hit);
        EXPECT_EQ(summary(corner, scene).back(), "hits nothing");
        EXPECT_EQ(describe(corner, verdict, scene).back(), "the method misses it");
    }
}

}  // namespace
}  // namespace relievo::comparing_test
