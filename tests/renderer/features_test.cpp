// What scenes build and leave out.
#include "renderer/features.h"

#include <gtest/gtest.h>

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
