// The methods against the reference on the sample scenes, as their own cameras see them.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "brushes/map_file.h"
#include "renderer/judge/judge.h"
#include "renderer/opacity.h"
#include "renderer/stability/promises.h"
#include "tests/accuracy/method_images.h"

namespace relievo::test::sample_scenes_test {
namespace {

constexpr int kSize = 128;

// Whoever reads the map and the reference's image once can judge all methods.
std::array<ImageComparison, 3> compare_scene(const std::string& name) {
    const Scene scene = load_scene(std::filesystem::path(RELIEVO_SAMPLE_SCENES) / (name + ".json"));
    const SceneObject& object = scene.objects.at(0);
    const auto& procedural = object.displacement.procedural;
    const LoadedMap map = load_map(procedural ? procedural->exemplar : object.displacement.map);
    const int width = map.map.width(), height = map.map.height();
    const HeightView view{width, height, map.map.texels().data()};
    OpacityMap opacity;
    ReferenceObject judged = reference_object(object, {width, height, view.texels});
    if (!object.opacity_map.empty()) {
        opacity = load_opacity_map(object.opacity_map);
        judged.opacity = {opacity.width, opacity.height, opacity.texels.data()};
    }
    const ReferenceSurface surface({&judged, 1});
    const Judge judge(trace_image(surface, scene.camera, scene.origin, kSize, kSize), scene);
    EXPECT_EQ(judge.image().undecided, 0u) << name;
    std::array<ImageComparison, 3> results;
    const std::array<MethodUnderTest, 3> methods{pdm_method(), exact_method(), {"dbvh", {}}};
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const MethodImages images = method_images(scene, view, kSize, methods[i]);
        results[i] = judge.compare(images.depth, images.normal);
        if (i > 0) judge.count_unexplained(surface, images.depth, results[i]);
        std::printf("%s, %s: %s\n", methods[i].name.c_str(), name.c_str(), results[i].text().c_str());
    }
    return results;
}

class SampleScenes : public testing::TestWithParam<const char*> {};

TEST_P(SampleScenes, MethodsKeepTheirPromises) {
    const auto [pdm, exact, dbvh] = compare_scene(GetParam());
    EXPECT_GT(pdm.both, 1000);
    EXPECT_LE(pdm.depth.median, 1e-3);
    EXPECT_GT(exact.both, 1000);
    for (const std::string& failure : stability::right_failures(exact)) ADD_FAILURE() << "exact: " << failure;
    for (const std::string& failure : stability::right_failures(dbvh)) ADD_FAILURE() << "dbvh: " << failure;
}

INSTANTIATE_TEST_SUITE_P(All, SampleScenes,
                         testing::Values("plane", "asteroid", "chainmail", "leather", "orb", "stump", "knot",
                                         "fur", "scree", "procedural_plane", "procedural_sphere"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace relievo::test::sample_scenes_test
