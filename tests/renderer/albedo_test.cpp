// Albedo maps: the colour at a hit, whatever the way of tracing, the size of the map, its bits and its wrap.
#include <OpenImageIO/imageio.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>

#include "renderer/albedo_file.h"
#include "renderer/features.h"
#include "tests/renderer/device.h"

namespace relievo::test::albedo_test {
namespace {

struct TestColours {
    int width = 0, height = 0, bits = 8;
    std::array<std::vector<std::uint16_t>, 3> planes;
    ColourView view() const {
        return {width, height, bits, {planes[0].data(), planes[1].data(), planes[2].data()}};
    }

    glm::dvec3 linear(int x, int y) const {
        glm::dvec3 colour;
        for (int k = 0; k < 3; ++k) {
            const double c =
                planes[static_cast<std::size_t>(k)][static_cast<std::size_t>(y * width + x)] / 65535.0;
            colour[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        }
        return colour;
    }
    // Bilinear, of decoded values.
    glm::dvec3 at(glm::dvec2 uv, bool clamp) const {
        const glm::dvec2 texel = uv * glm::dvec2(width, height) - 0.5, cell = glm::floor(texel),
                         f = texel - cell;
        const auto corner = [&](int dx, int dy) {
            const auto wrapped = [&](double v, int size) {
                return clamp ? std::clamp(static_cast<int>(v), 0, size - 1)
                             : static_cast<int>(v - size * std::floor(v / size));
            };
            return linear(wrapped(cell.x + dx, width), wrapped(cell.y + dy, height));
        };
        return glm::mix(glm::mix(corner(0, 0), corner(1, 0), f.x), glm::mix(corner(0, 1), corner(1, 1), f.x),
                        f.y);
    }
};

// Columns of orange and deep blue by turns; 8-bit values, so that both sorts of map can hold them.
TestColours two_colours(int width, int height, int bits) {
    TestColours c{width, height, bits, {}};
    const std::array<std::array<std::uint16_t, 3>, 2> kColours{{{240, 130, 20}, {10, 35, 128}}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t k = 0; k < 3; ++k)
                c.planes[k].push_back(
                    static_cast<std::uint16_t>(257 * kColours[static_cast<std::size_t>((x + y) % 2)][k]));
    return c;
}

// Matte, so that radiance is albedo times what it is on white.
Scene matte(const MeshFile& mesh, Wrap wrap = Wrap::repeat) {
    Scene scene = make_scene(mesh, 0.1, 0.5, wrap);
    scene.objects[0].material.specular = 0;
    scene.objects[0].material.albedo = {1, 1, 1};
    return scene;
}

Renderer painted(const Scene& scene, const TestMap& map, const TestColours& colours,
                 const RenderSettings& settings) {
    const HeightView view = map.view();
    const ColourView c = colours.view();
    return Renderer(device(), scene, std::span(&view, 1), settings, std::span(&c, 1));
}

std::vector<float> beauty(Renderer& renderer) {
    renderer.render();
    return renderer.read_back(Layer::beauty);
}

// Compares each pixel with the map at the pixel's uv. Filter weights have at least 8 bits; a GPU cuts them off there,
// along both axes, where the colours are up to 0.9 apart (0.0082 on an NVIDIA H100).
void expect_colours(const std::vector<float>& image, const std::vector<float>& white,
                    const std::vector<float>& uv, const TestColours& colours, bool clamp) {
    int seen = 0;
    const double filter = device().info().is_cpu ? 0.006 : 0.009;
    for (std::size_t i = 0; i < uv.size() / 2; ++i) {
        if (white[4 * i + 3] == 0 || white[4 * i] < 0.05f) continue;
        const glm::dvec3 expected = colours.at({double{uv[2 * i]}, double{uv[2 * i + 1]}}, clamp);
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_NEAR(image[4 * i + k] / white[4 * i + k], expected[static_cast<int>(k)], filter)
                << "uv " << uv[2 * i] << ", " << uv[2 * i + 1];
        ++seen;
    }
    EXPECT_GT(seen, 500);
}

RELIEVO_EVERY_METHOD(Albedo);

TEST_P(Albedo, TwoColoursShowWhereTheirTexelsLie) {
    const TestMap map = make_map(32, 32, [](double, double) { return 0.5; });
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const Scene scene = matte(plane_mesh(), wrap);
        Renderer r = make_renderer(scene, map, settings_of(scene));
        const auto white = beauty(r), uv = r.read_back(Layer::uv);
        for (const int bits : {8, 16})
            for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {3, 5}, {64, 32}}) {
                SCOPED_TRACE(testing::Message() << width << " x " << height << ", " << bits << " bits");
                const TestColours colours = two_colours(width, height, bits);
                r.set_colours(0, colours.view());
                expect_colours(beauty(r), white, uv, colours, wrap == Wrap::clamp);
            }
    }
}

TEST_P(Albedo, AllWaysOfTracingGiveEqualImages) {
    const Scene scene = matte(ball_mesh());
    const TestMap map = bumps(128);
    const TestColours colours = two_colours(48, 20, 16);
    RenderSettings settings = settings_of(scene);
    settings.path = TracePath::bvh;
    Renderer own = painted(scene, map, colours, settings);
    const auto expected = beauty(own);
    for (const TracePath path : other_paths()) {
        settings.path = path;
        Renderer other = painted(scene, map, colours, settings);
        EXPECT_TRUE(same_image(beauty(other), expected)) << trace_path_words(path);
    }
}

TEST_P(Albedo, SpecialisedImageEqualsEverythingOn) {
    const Scene scene = matte(ball_mesh());
    const TestMap map = bumps(128);
    const TestColours colours = two_colours(48, 20, 8);
    RenderSettings lean = settings_of(scene), all = lean;
    all.everything = true;
    Renderer a = painted(scene, map, colours, lean), b = painted(scene, map, colours, all);
    EXPECT_TRUE(same_image(beauty(a), beauty(b))) << "with a map";
    Renderer c = make_renderer(scene, map, lean), d = make_renderer(scene, map, all);
    EXPECT_TRUE(same_image(beauty(c), beauty(d))) << "without one";
}

TEST(AlbedoUpload, IsWhatAFreshRendererShows) {
    const Scene scene = matte(plane_mesh());
    const TestMap map = bumps(64);
    for (const int bits : {8, 16}) {
        TestColours before = two_colours(30, 40, bits), after = before;
        const TexelRegion regions[] = {{3, 4, 20, 9}, {21, 30, 30, 40}};
        for (const TexelRegion& r : regions)
            for (int y = r.y0; y < r.y1; ++y)
                for (int x = r.x0; x < r.x1; ++x)
                    after.planes[1][static_cast<std::size_t>(y * 30 + x)] = 65535;
        Renderer edited = painted(scene, map, before, settings_of(scene)),
                 fresh = painted(scene, map, after, settings_of(scene));
        const auto start = beauty(edited), expected = beauty(fresh);
        EXPECT_FALSE(start == expected);
        edited.upload_colours(0, after.view(), regions);
        edited.restart();
        EXPECT_TRUE(beauty(edited) == expected);
        edited.set_method("march", {});  // makes the device's scene anew
        edited.set_method("exact", {});
        EXPECT_TRUE(beauty(edited) == expected) << "the last upload is kept";
        Renderer bare = make_renderer(scene, map, settings_of(scene));
        EXPECT_THROW(bare.upload_colours(0, after.view(), regions), std::logic_error)
            << "there is no map yet";
        bare.set_colours(0, after.view());
        EXPECT_TRUE(beauty(bare) == expected) << "a map that came later";
        EXPECT_THROW(bare.upload_colours(0, two_colours(31, 40, bits).view(), regions), std::logic_error);
    }
}

TEST(AlbedoFeature, IsBuiltWithItsReasonAndBytesOnlyWhereThereIsAMap) {
    const Scene scene = matte(plane_mesh());
    const TestMap map = bumps(64);
    const auto feature = [](const Renderer& renderer) {
        for (const Feature& f : renderer.features().features)
            if (f.name == "albedo maps") return f;
        return Feature{};
    };
    Renderer bare = make_renderer(scene, map, settings_of(scene));
    EXPECT_FALSE(feature(bare).built);
    EXPECT_EQ(feature(bare).bytes, 0u);
    EXPECT_EQ(feature(bare).reason, "no material's albedo is a map");
    const Renderer eight = painted(scene, map, two_colours(64, 32, 8), settings_of(scene)),
                   sixteen = painted(scene, map, two_colours(64, 32, 16), settings_of(scene));
    EXPECT_TRUE(feature(eight).built);
    EXPECT_EQ(feature(eight).reason, "a material's albedo is a map");
    EXPECT_GE(feature(eight).bytes, 64u * 32 * 4);
    EXPECT_GE(feature(sixteen).bytes, 64u * 32 * 8);
    bare.set_colours(0, two_colours(8, 8, 8).view());
    EXPECT_TRUE(feature(bare).built);
}

TEST(AlbedoObjects, EachHasItsOwnMapOrItsOwnAlbedo) {
    Scene scene = matte(plane_mesh());
    scene.objects.push_back(scene.objects[0]);
    MeshFile moved = plane_mesh();
    for (glm::dvec3& p : moved.positions) p.x += 2.2;
    scene.objects[1].mesh = make_mesh(moved, scene.objects[1].transform, scene.origin, true);
    scene.objects[1].material.albedo = {0.25f, 0.5f, 0.75f};
    scene.camera.eye = {1.1, 3, 3};
    scene.camera.look_at = {1.1, 0, 0};
    const TestMap map = make_map(8, 8, [](double, double) { return 0.5; });
    const std::vector<HeightView> maps(2, map.view());
    const TestColours colours = two_colours(1, 1, 8);
    const std::vector<ColourView> views{colours.view(), {}};
    Scene all_white = scene;
    all_white.objects[1].material.albedo = {1, 1, 1};
    Renderer white(device(), all_white, maps, settings_of(scene)),
        r(device(), scene, maps, settings_of(scene), views);
    const auto lit = beauty(white), image = beauty(r), id = white.read_back(Layer::id);
    int seen[3]{};
    for (std::size_t i = 0; i < id.size(); ++i) {
        if (lit[4 * i] < 0.05f || id[i] == 0) continue;
        const glm::dvec3 expected = id[i] == 1 ? colours.linear(0, 0) : glm::dvec3(0.25, 0.5, 0.75);
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_NEAR(image[4 * i + k] / lit[4 * i + k], expected[static_cast<int>(k)], 0.003);
        ++seen[static_cast<int>(id[i])];
    }
    EXPECT_GT(std::min(seen[1], seen[2]), 300);
}

class AlbedoFiles : public testing::Test {
  protected:
    AlbedoFiles() {
        std::string name = (std::filesystem::temp_directory_path() / "relievo-albedo-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~AlbedoFiles() override { std::filesystem::remove_all(folder_); }

    template <typename Value>
    std::filesystem::path write(const char* name, int width, int height, int channels,
                                std::vector<Value> values) const {
        const std::filesystem::path path = folder_ / name;
        const auto out = OIIO::ImageOutput::create(path.string());
        const OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<Value>::value);
        values.resize(static_cast<std::size_t>(width * height * channels));
        EXPECT_TRUE(out->open(path.string(), spec) && out->write_image(spec.format, values.data()) &&
                    out->close());
        return path;
    }
    static std::string refusal(const std::filesystem::path& path) {
        try {
            load_albedo_file(path);
        } catch (const std::invalid_argument& e) {
            return e.what();
        }
        return "";
    }
    std::filesystem::path folder_;
};

TEST_F(AlbedoFiles, AreReadWithTheirBitsTheLowestRowFirst) {
    const AlbedoFile eight = load_albedo_file(write<std::uint8_t>("a.png", 1, 2, 3, {1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(eight.bits, 8);
    EXPECT_EQ(eight.planes[0], (std::vector<std::uint16_t>{4 * 257, 1 * 257}));
    EXPECT_EQ(eight.planes[2], (std::vector<std::uint16_t>{6 * 257, 3 * 257}));
    const AlbedoFile sixteen =
        load_albedo_file(write<std::uint16_t>("b.tif", 1, 1, 4, {1000, 65535, 7, 100}));
    EXPECT_EQ(sixteen.bits, 16);
    EXPECT_EQ(sixteen.planes[0][0], 1000) << "not multiplied by alpha";
    EXPECT_EQ(sixteen.planes[1][0], 65535);
}

TEST_F(AlbedoFiles, ThatCannotServeAreRefusedByNameAndReason) {
    const auto has = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(refusal(write<std::uint8_t>("grey.png", 2, 2, 1, {})),
        "grey.png': it has 1 channel, must have three");
    has(refusal(write<std::uint16_t>("two.png", 2, 2, 2, {})), "it has 2 channels");
    has(refusal(write<float>("float.exr", 2, 2, 3, {})), "it holds float values");
    has(refusal(folder_ / "none.png"), "none.png': cannot be opened");
    const auto cut = write<std::uint16_t>("cut.tif", 64, 64, 3, {});
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
    EXPECT_NE(refusal(cut), "");
}

TEST_F(AlbedoFiles, TheOneOfASceneIsShownWithoutBeingHandedOver) {
    Scene scene = matte(plane_mesh());
    const TestMap map = bumps(64);
    const TestColours colours = two_colours(2, 2, 8);
    scene.objects[0].material.albedo_map =
        write<std::uint8_t>("c.png", 2, 2, 3, {10, 35, 128, 240, 130, 20, 240, 130, 20, 10, 35, 128});
    Renderer from_file = make_renderer(scene, map, settings_of(scene)),
             handed_over = painted(scene, map, colours, settings_of(scene));
    const auto expected = beauty(handed_over);
    EXPECT_TRUE(beauty(from_file) == expected);
    std::filesystem::remove(scene.objects[0].material.albedo_map);
    from_file.set_method("march", {});  // makes the device's scene anew
    from_file.set_method("exact", {});
    EXPECT_TRUE(beauty(from_file) == expected) << "the file was read once";
}

}  // namespace
}  // namespace relievo::test::albedo_test
