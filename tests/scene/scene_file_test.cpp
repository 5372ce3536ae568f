// Scene files: defaults, paths, every kind of bad input with its message.
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/scene/scene.h"
#include "tests/scene/scene_documents.h"
#include "tests/scene/test_files.h"

namespace relievo::scene_file_test {
namespace {

class SceneFiles : public TestFiles {
  protected:
    SceneFiles() { write("quad.obj", kQuadObj); }
    Scene load(std::string_view json) const { return load_scene(write("scene.json", whole_document(json))); }
    std::string refused(std::string_view json) const {
        const std::filesystem::path path = write("scene.json", std::string(json));
        const std::string message = refusal([&] { load_scene(path); });
        EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
        return message.substr(std::min(message.size(), path.string().size() + 2));
    }
};

TEST_F(SceneFiles, good_documents_load_and_bad_ones_say_where) {
    for (const SceneDocument& document : kSceneDocuments) {
        SCOPED_TRACE(document.json);
        if (document.verdict == Verdict::good) {
            EXPECT_NO_THROW(load(document.json));
        } else {
            const std::string message = refused(whole_document(document.json));
            EXPECT_TRUE(document.message.empty() || message == document.message) << message;
        }
    }
}

TEST_F(SceneFiles, defaults_show_the_object) {
    const Scene scene = load(R"("image": {"width": 300, "height": 200})");
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].name, "quad");
    EXPECT_EQ(scene.objects[0].mesh.faces.size(), 2u);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.origin, glm::dvec3(0));
    EXPECT_TRUE(scene.path.is_absolute());
    // Every displaced corner is inside the frame.
    const glm::dvec3 forward = glm::normalize(scene.camera.look_at - scene.camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, scene.camera.up)),
                     up = glm::cross(right, forward);
    const double tangent = std::tan(scene.camera.fov_deg * M_PI / 360);
    for (const glm::vec3& p : scene.objects[0].mesh.positions) {
        for (const double lift : {-0.05, 0.05}) {
            const glm::dvec3 to = glm::dvec3(p) + glm::dvec3(0, 0, lift) - scene.camera.eye;
            EXPECT_LT(std::abs(glm::dot(to, up)), tangent * glm::dot(to, forward));
            EXPECT_LT(std::abs(glm::dot(to, right)), tangent * 1.5 * glm::dot(to, forward));
        }
    }
}

TEST_F(SceneFiles, camera_keys_mix_with_the_framing) {
    EXPECT_EQ(load(R"("camera": {"fov_deg": 10})").camera.fov_deg, 10);
    const Scene wide = load(R"("camera": {"fov_deg": 90})"), narrow = load(R"("camera": {"fov_deg": 5})");
    EXPECT_LT(glm::length(wide.camera.eye), glm::length(narrow.camera.eye) / 5);
    const Scene from_above = load(R"("camera": {"eye": [0.5, 9, 0], "look_at": [0.5, 0, 0]})");
    EXPECT_EQ(from_above.camera.up, glm::dvec3(0, 0, -1));
    const Scene moved = load(R"("camera": {"look_at": [7, 0, 0]})");
    EXPECT_GT(moved.camera.eye.x, 7);
}

TEST_F(SceneFiles, transform_scales_then_rotates_then_moves) {
    const Scene scene = load(
        R"(object "transform": {"translate": [10, 0, 0], "rotate_deg": [90, 0, 90], "scale": [2, 3, 4]})");
    // (1, 1, 0) to (2, 3, 0); about X to (2, 0, 3); about Z to (0, 2, 3); moved to (10, 2, 3).
    const glm::dvec3 p(scene.objects[0].transform * glm::dvec4(1, 1, 0, 1));
    EXPECT_NEAR(glm::length(p - glm::dvec3(10, 2, 3)), 0, 1e-12);
    const Scene rows = load(R"(object "transform": [1,2,3,4, 0,1,0,5, 0,0,1,6, 0,0,0,1])");
    EXPECT_EQ(glm::dvec3(rows.objects[0].transform * glm::dvec4(1, 1, 1, 1)), glm::dvec3(10, 6, 7));
}

TEST_F(SceneFiles, far_away_scene_is_rebased_and_keeps_digits) {
    const Scene scene = load(R"(object "transform": {"translate": [1e5, -1e5, 1e5], "scale": 1e-4})");
    EXPECT_NEAR(glm::length(scene.origin - glm::dvec3(1e5 + 0.5e-4, -1e5 + 0.5e-4, 1e5)), 0, 1e-9);
    const Mesh& mesh = scene.objects[0].mesh;
    EXPECT_NEAR(static_cast<double>(mesh.positions[1].x - mesh.positions[0].x), 1e-4, 1e-9);
    EXPECT_NEAR(glm::length(scene.camera.look_at - scene.origin), 0, 1e-9);
    EXPECT_EQ(load(R"(object "transform": {"translate": [5, 0, 0]})").origin, glm::dvec3(0));
}

TEST_F(SceneFiles, paths_are_relative_to_the_scene_file) {
    std::filesystem::create_directory(folder() / "sub");
    const auto path = write("sub/scene.json", R"({"relievo": 1, "objects": [{"mesh": "../quad.obj"}]})");
    EXPECT_EQ(load_scene(path).objects[0].mesh_path, folder() / "quad.obj");
}

TEST_F(SceneFiles, files_that_do_not_exist_are_named_with_their_key) {
    EXPECT_EQ(refused(R"({"relievo": 1, "objects": [{"mesh": "none.obj"}]})"),
              "objects[0].mesh: no such file: " + (folder() / "none.obj").string());
    EXPECT_EQ(refused(whole_document(R"(object "displacement": {"map": "none.tif"})")),
              "objects[0].displacement.map: no such file: " + (folder() / "none.tif").string());
    EXPECT_EQ(refused(whole_document(R"(object "opacity_map": "none.png")")),
              "objects[0].opacity_map: no such file: " + (folder() / "none.png").string());
    EXPECT_EQ(refused(whole_document(R"(object "opacity_map": ".")")),
              "objects[0].opacity_map: " + (folder() / "").string() + " is a folder, must be a file");
    write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string message = refused(R"({"relievo": 1, "objects": [{"mesh": "bare.obj"}]})");
    EXPECT_TRUE(
        message.starts_with("objects[0].mesh: " + (folder() / "bare.obj").string() + ": no texture coord"))
        << message;
}

TEST_F(SceneFiles, syntax_errors_have_line_and_column) {
    EXPECT_TRUE(refused("{\"relievo\": 1,\n  \"objects\" [}").starts_with("line 2, column 13: syntax error"));
    EXPECT_TRUE(refused("{\"relievo\": 1").starts_with("line 1, column 14: syntax error"));
    EXPECT_TRUE(refused("\xff\xfe").starts_with("line 1, column 1: "));
    EXPECT_NE(refused(R"({"relievo": 1, "relievo": 1})").find("the key 'relievo' is given twice"),
              std::string::npos);
    EXPECT_NE(refused(R"({"relievo": 1e999})").find("number overflow"), std::string::npos);
    EXPECT_EQ(refused(""), "is empty");
    EXPECT_EQ(refusal([] { load_scene("/nowhere/scene.json"); }), "/nowhere/scene.json: no such file");
}

TEST_F(SceneFiles, method_parameters_are_numbers_and_switches) {
    const Scene scene =
        load(R"("method": {"name": "pdm", "dt": 0.25, "jitter": false, "correct_normals": true})");
    EXPECT_EQ(scene.method.name, "pdm");
    EXPECT_EQ(scene.method.parameters,
              (std::map<std::string, double>{{"dt", 0.25}, {"jitter", 0}, {"correct_normals", 1}}));
}

TEST_F(SceneFiles, method_parameters_by_word_wait_for_the_registry) {
    const Scene scene = load(R"("method": {"name": "dbvh", "leaf": "triangles", "level": 1})");
    EXPECT_EQ(scene.method.words, (std::map<std::string, std::string>{{"leaf", "triangles"}}));
    EXPECT_EQ(scene.method.parameters, (std::map<std::string, double>{{"level", 1}}));
}

TEST_F(SceneFiles, warnings_name_the_mesh) {
    write("flat.obj", kQuadObj + "f 1/1 1/2 2/3\n");
    const Scene scene = load_scene(write("s.json", R"({"relievo": 1, "objects": [{"mesh": "flat.obj"}]})"));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(
        scene.warnings[0].starts_with((folder() / "flat.obj").string() + ": 1 of 3 triangles have no area"));
}

}  // namespace
}  // namespace relievo::scene_file_test
