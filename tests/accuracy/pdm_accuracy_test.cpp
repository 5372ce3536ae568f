// `pdm` at dt 0.001 without jitter against the reference: on a 960-triangle ball and on planes, from above,
// grazing, from inside and from below.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/accuracy/comparison.h"
#include "tests/accuracy/method_images.h"
#include "tests/reference/sample_surfaces.h"

namespace relievo::test {
namespace {

using glm::dvec3;

constexpr int kSize = 160;

struct NamedView {
    const char* name;
    dvec3 eye, look_at;
};

Scene scene_of(const SampleSurface& sample, const NamedView& view) {
    Scene scene;
    SceneObject object;
    object.displacement.amplitude = sample.amplitude;
    object.displacement.midlevel = sample.midlevel;
    object.displacement.wrap = sample.wrap;
    object.mesh = sample.mesh;
    scene.objects.push_back(object);
    scene.camera.eye = view.eye;
    scene.camera.look_at = view.look_at;
    scene.camera.up = {0, 0, 1};
    scene.camera.fov_deg = 50;
    return scene;
}

ImageComparison compare_pdm(const SampleSurface& sample, const NamedView& view, const char* surface_name) {
    const Scene scene = scene_of(sample, view);
    const MethodImages images = pdm_images(scene, {sample.width, sample.height, sample.texels.data()}, kSize);
    const ReferenceSurface surface = sample.reference();
    const ReferenceImage image = trace_image(surface, scene.camera, scene.origin, kSize, kSize);
    EXPECT_EQ(image.undecided, 0u);
    ImageComparison result =
        compare_images(image, scene.camera, scene.origin, sample.amplitude, images.depth, images.normal);
    std::printf("%s, %s: %s\n", surface_name, view.name, result.text().c_str());
    return result;
}

// What users are promised of pdm at this step.
void expect_within_limits(const ImageComparison& result, const char* view) {
    EXPECT_GT(result.both, 100) << view;
    EXPECT_LE(result.depth.median, 1e-3) << view;
    EXPECT_LE(result.missed, 3) << view;
    EXPECT_LE(result.invented, 3) << view;
}

const NamedView kPlaneViews[] = {{"from above", {0.5, 0.1, 1.6}, {0.5, 0.5, 0}},
                                 {"grazing", {-0.4, -0.3, 0.16}, {0.6, 0.6, 0}},
                                 {"along the ground", {0.5, 0.5, 0.12}, {0.9, 0.8, 0.08}},
                                 {"from below", {0.4, 0.2, -1.3}, {0.5, 0.5, 0}}};
const NamedView kBallViews[] = {{"from outside", {2.0, 1.4, 1.1}, {0, 0, 0}},
                                {"grazing", {1.25, 0.5, 0.0}, {0.0, 1.0, 0.1}},
                                {"from inside", {0.1, 0.2, 0.0}, {1, 0.3, 0.2}},
                                {"from far", {9, 20, 7}, {0, 0, 0}}};

SampleSurface plane(double amplitude, double midlevel, int size, const std::function<double(int, int)>& value,
                    Wrap wrap = Wrap::repeat) {
    SampleSurface sample;
    sample.mesh = plane_mesh();
    sample.amplitude = amplitude;
    sample.midlevel = midlevel;
    sample.wrap = wrap;
    sample.paint(size, size, value);
    return sample;
}

SampleSurface ball(double amplitude, double midlevel) {
    SampleSurface sample;
    sample.mesh = ball_mesh(32, 16);
    sample.amplitude = amplitude;
    sample.midlevel = midlevel;
    sample.paint(256, 128, [](int x, int y) { return ball_dunes((x + 0.5) / 256, (y + 0.5) / 128); });
    return sample;
}

TEST(PdmAgainstReference, BallOf960Triangles) {
    for (const NamedView& view : kBallViews) {
        expect_within_limits(compare_pdm(ball(0.2, 0.5), view, "ball"), view.name);
        expect_within_limits(compare_pdm(ball(-0.1, 0.0), view, "ball, carved"), view.name);
    }
}

// The known flaw (DESIGN.md section 1): the prisms of irregular neighbours disagree, whatever the step. No
// limits here but that the picture is one; the figures are printed for reports.
TEST(PdmAgainstReference, IrregularLumpShowsTheKnownFlaw) {
    SampleSurface sample;
    sample.mesh = lump_mesh();
    sample.midlevel = 0.5;
    sample.paint(128, 128, [](int x, int y) { return ball_dunes((x + 0.5) / 128, (y + 0.5) / 128); });
    for (const double amplitude : {0.1, 0.4}) {
        sample.amplitude = amplitude;
        for (const NamedView& view : kBallViews) {
            const ImageComparison result = compare_pdm(sample, view, "lump");
            EXPECT_GT(result.both, 100) << view.name;
            EXPECT_LE(result.depth.median, 0.1) << view.name;
        }
    }
}

TEST(PdmAgainstReference, PlaneOfDunes) {
    const SampleSurface sample =
        plane(0.15, 0.5, 256, [](int x, int y) { return dunes((x + 0.5) / 256, (y + 0.5) / 256); });
    for (const NamedView& view : kPlaneViews)
        expect_within_limits(compare_pdm(sample, view, "dunes"), view.name);
}

TEST(PdmAgainstReference, PlaneOfOneRamp) {
    const SampleSurface sample = plane(
        0.3, 0.5, 64, [](int x, int) { return x / 63.0; }, Wrap::clamp);
    for (const NamedView& view : kPlaneViews)
        expect_within_limits(compare_pdm(sample, view, "ramp"), view.name);
}

TEST(PdmAgainstReference, PlaneOfRampsWithCliffsAtTheirEnds) {
    const SampleSurface sample = plane(0.1, 0.0, 128, [](int x, int) { return x % 32 / 31.0; });
    for (const NamedView& view : kPlaneViews)
        expect_within_limits(compare_pdm(sample, view, "ramps"), view.name);
}

TEST(PdmAgainstReference, PlaneOfTerracesWithCliffs) {
    const SampleSurface sample = plane(0.1, 0.0, 64, [](int x, int y) { return (x / 8 + y / 8) % 2; });
    for (const NamedView& view : kPlaneViews)
        expect_within_limits(compare_pdm(sample, view, "terraces"), view.name);
}

TEST(PdmAgainstReference, ConstantMaps) {
    for (const double height : {0.0, 0.5, 1.0}) {
        const SampleSurface sample = plane(0.2, 0.5, 4, [&](int, int) { return height; });
        for (const NamedView& view : kPlaneViews)
            expect_within_limits(compare_pdm(sample, view, "constant"), view.name);
    }
}

}  // namespace
}  // namespace relievo::test
