// NaN, infinity and what is beyond the range of numbers, in meshes, maps and scene files: refused with the
// file and the place in one sentence, or mended with a warning; never rendered as they are.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "editor/session/reference_scene.h"
#include "editor/session/scene_input.h"
#include "renderer/methods/registry.h"
#include "renderer/renderer.h"
#include "renderer/vulkan/context.h"
#include "tests/session/test_scene.h"

namespace relievo::bad_input_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

// A square whose first position, texture coordinate and normal are as given; empty: a good one.
std::string square_obj(const std::string& position, const std::string& uv, const std::string& normal) {
    const auto or_else = [](const std::string& text, const char* good) { return text.empty() ? good : text; };
    return "v " + or_else(position, "0 0 0") + "\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt " + or_else(uv, "0 0") +
           "\nvt 1 0\nvt 1 1\nvt 0 1\nvn " + or_else(normal, "0 0 1") +
           "\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1/1/1 2/2/2 3/3/3\nf 1/1/1 3/3/3 4/4/4\n";
}

std::string square_ply(const std::string& first) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n"
           "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
           first + "\n1 0 0 0 0 1 1 0\n1 1 0 0 0 1 1 1\n0 1 0 0 0 1 0 1\n3 0 1 2\n3 0 2 3\n";
}

class BadInput : public testing::Test {
  protected:
    BadInput() { good(); }

    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    void good() {
        test::write_text(path("a.obj"), square_obj("", "", ""));
        write_map(0.5f);
        write_scene("a.obj", "");
    }

    void write_map(float value) const {
        std::vector<float> values(16, 0.5f);
        values[6] = value;
        const auto out = OIIO::ImageOutput::create(path("m.exr"));
        ASSERT_TRUE(out && out->open(path("m.exr"), OIIO::ImageSpec(4, 4, 1, OIIO::TypeDesc::FLOAT)));
        ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, values.data()) && out->close());
    }

    // `keys`: of the object's displacement and the scene, each with a comma before it.
    void write_scene(const std::string& mesh, const std::string& displacement_keys,
                     const std::string& keys = "") const {
        test::write_text(path("scene.json"), R"({"relievo": 1, "objects": [{"mesh": ")" + mesh +
                                                 R"(", "displacement": {"map": "m.exr")" + displacement_keys +
                                                 "}}]" + keys + "}");
    }

    ReferenceScene load() const { return ReferenceScene(open_scene(path("scene.json"))); }

    void expect_refused(const std::string& file, const std::string& words) const {
        try {
            load();
            ADD_FAILURE() << "was read; expected: " << words;
        } catch (const std::invalid_argument& error) {
            const std::string text = error.what();
            EXPECT_NE(text.find(file), std::string::npos) << text;
            EXPECT_NE(text.find(words), std::string::npos) << text;
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        }
    }

    // By the reference and by every method, every pixel a number.
    void expect_sound_picture() const {
        const ReferenceScene loaded = load();
        const Scene& scene = loaded.scene();
        const ReferenceImage image = trace_image(loaded.surface(), scene.camera, scene.origin, 24, 24);
        for (const double z : image.depth) ASSERT_GT(z, 0);
        const HeightMap& map = loaded.map(0);
        const HeightView view{map.width(), map.height(), map.texels().data()};
        static vulkan::Context device{vulkan::ContextOptions{}};
        for (const Method* method : methods()) {
            RenderSettings settings;
            settings.width = settings.height = 24;
            settings.method = method->name;
            Renderer renderer(device, scene, std::span(&view, 1), settings);
            renderer.render();
            for (const Layer layer : {Layer::beauty, Layer::normal, Layer::shading_normal, Layer::uv})
                for (const float v : renderer.read_back(layer)) ASSERT_TRUE(std::isfinite(v)) << method->name;
            int hits = 0;
            for (const float z : renderer.read_back(Layer::depth)) hits += std::isfinite(z) ? 1 : 0;
            EXPECT_GT(hits, 50) << method->name;
        }
    }

    test::TemporaryFolder folder_;
};

TEST_F(BadInput, GoodFilesGiveASoundPicture) {
    expect_sound_picture();
}

TEST_F(BadInput, ObjNumbersThatAreNoneAreRefusedByLine) {
    for (const char* word : {"nan", "NaN", "inf", "-inf", "Infinity"}) {
        test::write_text(path("a.obj"), square_obj(std::string("0 ") + word + " 0", "", ""));
        expect_refused("a.obj", "line 1: v: ");
        test::write_text(path("a.obj"), square_obj("", std::string(word) + " 0", ""));
        expect_refused("a.obj", "line 5: vt: ");
        test::write_text(path("a.obj"), square_obj("", "", std::string("0 0 ") + word));
        expect_refused("a.obj", "line 9: vn: ");
    }
    test::write_text(path("a.obj"), square_obj("1e999 0 0", "", ""));
    expect_refused("a.obj", "line 1");
}

TEST_F(BadInput, PlyAndOffNumbersThatAreNoneAreRefused) {
    write_scene("a.ply", "");
    for (const char* word : {"nan", "inf", "-inf"}) {
        test::write_text(path("a.ply"), square_ply(std::string(word) + " 0 0 0 0 1 0 0"));
        expect_refused("a.ply", "finite");
        test::write_text(path("a.ply"), square_ply(std::string("0 0 0 0 0 1 ") + word + " 0"));
        expect_refused("a.ply", "finite");
    }
    write_scene("a.off", "");
    test::write_text(path("a.off"), "STOFF\n3 1 0\n0 0 inf 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n");
    expect_refused("a.off", "line 3: 'inf' is not finite");
}

TEST_F(BadInput, NumbersBeyondFloatAreRefused) {
    test::write_text(path("a.obj"), square_obj("1e39 0 0", "", ""));
    expect_refused("a.obj", "beyond the range of numbers");
    test::write_text(path("a.obj"), square_obj("", "1e39 0", ""));
    expect_refused("a.obj", "beyond the range of numbers");
}

TEST_F(BadInput, MapsOfNanAndInfinityNameTheirTexel) {
    write_map(kNan);
    expect_refused("m.exr", "NaN at texel (2, ");
    for (const float value : {kInf, -kInf}) {
        write_map(value);
        expect_refused("m.exr", "infinity at texel (2, ");
    }
}

TEST_F(BadInput, MapValuesBeyondTheirRangeAreHeldToIt) {
    for (const float value : {3e38f, -3e38f, 1e-45f}) {
        write_map(value);
        expect_sound_picture();
    }
    EXPECT_EQ(load().map(0).at(2, 2), 0);
}

TEST_F(BadInput, SceneNumbersThatAreNoneAreRefusedByKey) {
    write_scene("a.obj", R"(, "amplitude": 1e999)");
    expect_refused("scene.json", "1e999");
    write_scene("a.obj", R"(, "amplitude": NaN)");
    expect_refused("scene.json", "line 1");
    write_scene("a.obj", R"(, "amplitude": 1e31)");
    expect_refused("scene.json", "objects[0].displacement.amplitude");
    write_scene("a.obj", R"(, "midlevel": 1.5)");
    expect_refused("scene.json", "objects[0].displacement.midlevel");
    write_scene("a.obj", R"(, "range": [1, 1])");
    expect_refused("scene.json", "objects[0].displacement.range");
    write_scene("a.obj", "", R"(, "camera": {"eye": [0, 0, 3], "look_at": [0, 0, 3]})");
    expect_refused("scene.json", "camera");
    write_scene("a.obj", "", R"(, "camera": {"fov_deg": 180})");
    expect_refused("scene.json", "camera.fov_deg");
}

TEST_F(BadInput, NormalsWithoutLengthAreSmoothedWithAWarning) {
    write_scene("a.ply", "");
    test::write_text(path("a.ply"), square_ply("0 0 0 0 0 0 0 0"));
    ASSERT_FALSE(load().scene().warnings.empty());
    EXPECT_NE(load().scene().warnings[0].find("smoothed"), std::string::npos) << load().scene().warnings[0];
    expect_sound_picture();
    for (const char* normal : {"nan 0 0", "inf 0 0"}) {
        test::write_text(path("a.ply"), square_ply(std::string("0 0 0 ") + normal + " 0 0"));
        expect_refused("a.ply", "line 15");
    }
}

TEST_F(BadInput, MeshesWithoutAnyAreaAreRefusedByTheRenderer) {
    test::write_text(path("a.obj"), "v 0 0 0\nv 1 0 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
    const ReferenceScene loaded = load();
    EXPECT_NE(loaded.scene().warnings.at(0).find("no area"), std::string::npos);
    EXPECT_FALSE(loaded.surface().first_hit({1, 0, 5}, {0, 0, -1}, 0, 1e30));
    const HeightMap& map = loaded.map(0);
    const HeightView view{map.width(), map.height(), map.texels().data()};
    vulkan::Context device{vulkan::ContextOptions{}};
    EXPECT_THROW(Renderer(device, loaded.scene(), std::span(&view, 1), RenderSettings{}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace relievo::bad_input_test
