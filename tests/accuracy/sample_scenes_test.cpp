// `pdm` at dt 0.001 without jitter against the reference on the sample scenes, as their own cameras see them.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "brushes/map_file.h"
#include "renderer/opacity.h"
#include "tests/accuracy/comparison.h"
#include "tests/accuracy/method_images.h"

namespace relievo::test {
namespace {

constexpr int kSize = 128;

ImageComparison compare_scene(const std::string& name) {
    const Scene scene = load_scene(std::filesystem::path(RELIEVO_SAMPLE_SCENES) / (name + ".json"));
    const SceneObject& object = scene.objects.at(0);
    const LoadedMap map = load_map(object.displacement.map);
    const int width = map.map.width(), height = map.map.height();
    const HeightView view{width, height, map.map.texels().data()};
    OpacityMap opacity;
    ReferenceObject judged = reference_object(object, {width, height, view.texels});
    if (!object.opacity_map.empty()) {
        opacity = load_opacity_map(object.opacity_map);
        judged.opacity = {opacity.width, opacity.height, opacity.texels.data()};
    }
    const MethodImages images = pdm_images(scene, view, kSize);
    const ReferenceSurface surface({&judged, 1});
    const ReferenceImage image = trace_image(surface, scene.camera, scene.origin, kSize, kSize);
    EXPECT_EQ(image.undecided, 0u) << name;
    const ImageComparison result = compare_images(image, scene.camera, scene.origin,
                                                  object.displacement.amplitude, images.depth, images.normal);
    std::printf("%s: %s\n", name.c_str(), result.text().c_str());
    return result;
}

TEST(PdmOnSampleScenes, MedianDepthErrorIsUnderAThousandthOfTheAmplitude) {
    for (const char* name : {"plane", "asteroid", "chainmail", "leather", "orb", "stump", "knot", "fur"}) {
        const ImageComparison result = compare_scene(name);
        EXPECT_GT(result.both, 1000) << name;
        EXPECT_LE(result.depth.median, 1e-3) << name;
    }
}

}  // namespace
}  // namespace relievo::test
