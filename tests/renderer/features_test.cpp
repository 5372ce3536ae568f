// What scenes build and leave out.
#include "renderer/features.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/scenes.h"

namespace relievo::test {
namespace {

FeatureRequest request_of(bool everything = false) { return {&find_method("pdm"), everything, false, false}; }

TEST(Features, AnOpaqueMatteSceneLeavesOutOpacityAndGloss) {
    Scene scene = make_scene(plane_mesh(), 0.2);
    scene.objects[0].material.specular = 0;
    const Features f = derive_features(scene, request_of());
    EXPECT_TRUE(f.shadows);
    EXPECT_TRUE(f.sky);
    EXPECT_FALSE(f.opacity);
    EXPECT_FALSE(f.gloss);
    EXPECT_FALSE(f.pyramid);
    EXPECT_FALSE(f.mended_creases);
}

TEST(Features, ADarkSceneTracesNoShadows) {
    Scene scene = make_scene(plane_mesh(), 0.2);
    scene.lights.clear();
    scene.environment.intensity = 0;
    const Features f = derive_features(scene, request_of());
    EXPECT_FALSE(f.shadows);
    EXPECT_FALSE(f.sky);
    EXPECT_TRUE(derive_features(scene, request_of(true)).shadows);
}

// What each sample scene builds, by name; all else is left out.
TEST(Features, SampleScenesBuildWhatTheyNeed) {
    const std::vector<std::string> usual{"base mesh prisms", "displacement maps", "height bounds", "shadows",
                                         "sky light",        "gloss",             "ray query",     "image"};
    for (const char* name : {"plane", "asteroid", "chainmail", "leather", "orb", "stump", "knot", "fur"}) {
        for (const char* method : {"pdm", "exact"}) {
            const Scene scene = load_scene(std::string(RELIEVO_SAMPLE_SCENES) + "/" + name + ".json");
            std::set<std::string> expected(usual.begin(), usual.end());
            if (std::string(name) == "chainmail") expected.insert("opacity maps");
            if (std::string(method) == "exact") expected.insert("min-max pyramid");
            const FeatureRequest request{&find_method(method), false, false, false};
            std::set<std::string> built;
            for (const Feature& f : describe_features(scene, request, derive_features(scene, request)).features)
                if (f.built) built.insert(f.name);
            EXPECT_EQ(built, expected) << name << " by " << method;
        }
    }
}

TEST(Features, EachFeatureHasAReason) {
    const Scene scene = make_scene(plane_mesh(), 0.2);
    for (const bool everything : {false, true}) {
        const FeatureRequest request = request_of(everything);
        const auto report = describe_features(scene, request, derive_features(scene, request));
        EXPECT_GE(report.features.size(), 12u);
        for (const Feature& f : report.features) EXPECT_FALSE(f.reason.empty()) << f.name;
    }
}

}  // namespace
}  // namespace relievo::test
