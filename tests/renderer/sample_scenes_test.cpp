// Every sample scene by every method: the bytes of what is built, what is built once it is asked for, and the
// specialised image against the everything-on one, bit for bit.
#include <gtest/gtest.h>

#include <map>

#include "brushes/map_file.h"
#include "renderer/features.h"
#include "tests/renderer/device.h"

namespace relievo::test::sample_scenes_test {
namespace {

constexpr int kSize = 40;

struct Sample {
    explicit Sample(const std::string& name)
        : scene(load_scene(std::string(RELIEVO_SAMPLE_SCENES) + "/" + name + ".json")) {
        for (const SceneObject& object : scene.objects) maps.push_back(load_map(object.displacement.map).map);
        for (const HeightMap& map : maps) views.push_back({map.width(), map.height(), map.texels().data()});
    }

    Renderer renderer(const Method& method, bool everything) const {
        RenderSettings settings;
        settings.width = settings.height = kSize;
        settings.method = method.name;
        settings.everything = everything;
        return Renderer(device(), scene, views, settings);
    }

    Scene scene;
    std::vector<HeightMap> maps;
    std::vector<HeightView> views;
};

std::map<std::string, Feature> features_of(const Renderer& renderer) {
    std::map<std::string, Feature> features;
    std::uint64_t sum = 0;
    for (const Feature& f : renderer.features().features) {
        features[f.name] = f;
        sum += f.bytes;
        if (!f.built) EXPECT_EQ(f.bytes, 0u) << f.name << " is left out";
    }
    EXPECT_EQ(renderer.features().bytes_total, sum);
    return features;
}

class SampleScenes : public testing::TestWithParam<const char*> {};

TEST_P(SampleScenes, BytesAreThoseOfWhatIsBuilt) {
    const Sample sample(GetParam());
    std::uint64_t texels = 0;
    for (const HeightView& map : sample.views)
        texels += static_cast<std::uint64_t>(map.width) * static_cast<std::uint64_t>(map.height);
    for (const Method* method : methods()) {
        SCOPED_TRACE(method->name);
        Renderer renderer = sample.renderer(*method, false);
        auto features = features_of(renderer);
        EXPECT_GE(features["displacement maps"].bytes, 2 * texels);
        EXPECT_GT(features["base mesh prisms"].bytes, 100 * sample.scene.objects[0].mesh.faces.size());
        EXPECT_GE(features["image"].bytes, 24u * kSize * kSize);
        for (const char* bounds : {"min-max pyramid", "bounds about planes"})
            EXPECT_EQ(features[bounds].bytes > 0, features[bounds].built) << bounds;
        EXPECT_EQ(features["opacity maps"].bytes > 0, features["opacity maps"].built);
        const char* const late[] = {"layers", "counters", "picking", "ray log", "upload staging"};
        for (const char* name : late) EXPECT_FALSE(features[name].built) << name;
        renderer.read_back(Layer::depth);
        renderer.read_back(Layer::counts);
        renderer.pick(std::vector{renderer.camera_ray(kSize / 2.0, kSize / 2.0)});
        renderer.trace_notes(renderer.camera_ray(kSize / 2.0, kSize / 2.0));
        renderer.upload(0, sample.views[0], std::vector<TexelRegion>{{0, 0, 16, 16}});
        features = features_of(renderer);
        for (const char* name : late) {
            EXPECT_TRUE(features[name].built) << name;
            EXPECT_GT(features[name].bytes, 0u) << name;
        }
        EXPECT_LT(features["upload staging"].bytes, 2 * texels) << "of the edit, not of the map";
    }
}

TEST_P(SampleScenes, SpecialisedImageEqualsEverythingOn) {
    const Sample sample(GetParam());
    for (const Method* method : methods()) {
        SCOPED_TRACE(method->name);
        std::vector<std::vector<float>> images[2];
        for (const bool everything : {false, true}) {
            Renderer renderer = sample.renderer(*method, everything);
            renderer.render();
            renderer.render();
            for (const Layer layer :
                 {Layer::beauty, Layer::depth, Layer::normal, Layer::shading_normal, Layer::uv})
                images[everything ? 1 : 0].push_back(renderer.read_back(layer));
        }
        for (std::size_t i = 0; i < images[0].size(); ++i)
            EXPECT_TRUE(same_image(images[0][i], images[1][i])) << "layer " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(All, SampleScenes,
                         testing::Values("plane", "asteroid", "chainmail", "leather", "orb", "stump", "knot",
                                         "fur"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace relievo::test::sample_scenes_test
