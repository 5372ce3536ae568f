// The known flaw of the sampled method shows as a gap along edges, the same at every step; the exact method
// has none.
#include "renderer/judge/edge_gap.h"

#include <gtest/gtest.h>

#include "renderer/renderer.h"
#include "renderer/vulkan/context.h"
#include "tests/reference/sample_surfaces.h"

namespace relievo::test::edge_gap_test {
namespace {

Scene scene_of(const SampleSurface& surface) {
    Scene scene;
    scene.objects.push_back(surface.scene_object());
    return scene;
}

SampleSurface lump(double amplitude, bool flat) {
    SampleSurface s;
    s.mesh = lump_mesh();
    s.amplitude = amplitude;
    s.midlevel = 0.5;
    s.paint(128, 128,
            [=](int x, int y) { return flat ? 1.0 : ball_dunes((x + 0.5) / 128, (y + 0.5) / 128); });
    return s;
}

class EdgeGaps : public testing::Test {
  protected:
    explicit EdgeGaps(SampleSurface sample = lump(0.1, false))
        : sample_(std::move(sample)),
          scene_(scene_of(sample_)),
          surface_(sample_.reference()),
          probe_(surface_, scene_) {}

    EdgeGap of(const std::string& method, const std::map<std::string, double>& parameters = {}) const {
        static vulkan::Context context{vulkan::ContextOptions{}};
        RenderSettings settings;
        settings.width = settings.height = 16;
        settings.method = method;
        settings.parameters = parameters;
        const HeightView map{sample_.width, sample_.height, sample_.texels.data()};
        Renderer renderer(context, scene_, std::span(&map, 1), settings);
        const EdgeGap gap = probe_.measure([&](std::span<const ReferenceRay> rays) {
            std::vector<Ray> asked;
            for (const ReferenceRay& ray : rays)
                asked.push_back({glm::vec3(ray.origin), glm::vec3(ray.direction)});
            std::vector<MethodHit> hits;
            for (const PickHit& hit : renderer.pick(asked))
                hits.push_back({hit.hit, hit.object, hit.face, static_cast<double>(hit.b1),
                                static_cast<double>(hit.b2), static_cast<double>(hit.distance)});
            return hits;
        });
        std::printf(
            "%s: %d points, %d unreached, gap median %.2e p99 %.2e max %.2e, %.0f%% wide, %d of %d leak\n",
            method.c_str(), gap.points, gap.unreached, gap.gap.median, gap.gap.p99, gap.gap.most,
            100 * gap.wide, gap.leaks, gap.rays);
        return gap;
    }

    SampleSurface sample_;
    Scene scene_;
    ReferenceSurface surface_;
    EdgeProbe probe_;
};

TEST_F(EdgeGaps, OfSamplingAreTheSameAtEveryStep) {
    const EdgeGap finest = of("pdm", {{"dt", 0.00025}});
    EXPECT_GT(finest.points, 350);
    EXPECT_GT(finest.gap.median, 1e-3);
    EXPECT_GT(finest.gap.p99, 1e-2);
    EXPECT_GT(finest.wide, 0.4);
    EXPECT_GT(finest.leaks, finest.rays / 20);
    for (const double dt : {0.01, 0.005, 0.002, 0.001}) {
        const EdgeGap gap = of("pdm", {{"dt", dt}});
        EXPECT_NEAR(gap.gap.median, finest.gap.median, 0.05 * finest.gap.median) << dt;
        EXPECT_NEAR(gap.gap.p99, finest.gap.p99, 0.05 * finest.gap.p99) << dt;
    }
}

TEST_F(EdgeGaps, OfTheExactMethodAreNone) {
    const EdgeGap gap = of("exact");
    EXPECT_GT(gap.points, 350);
    EXPECT_LT(gap.gap.most, 1e-4);
    EXPECT_EQ(gap.wide, 0);
    EXPECT_EQ(gap.leaks, 0);
}

class EdgeGapsOfAFlatMap : public EdgeGaps {
  protected:
    EdgeGapsOfAFlatMap() : EdgeGaps(lump(0.4, true)) {}
};

TEST_F(EdgeGapsOfAFlatMap, ShowTheFlawOfTheProjectionAlone) {
    EXPECT_GT(of("pdm", {{"dt", 0.001}}).gap.median, 1e-3);
    EXPECT_LT(of("exact").gap.most, 1e-4);
}

class EdgeGapsOfAPlane : public EdgeGaps {
  protected:
    static SampleSurface plane() {
        SampleSurface s;
        s.mesh = plane_mesh();
        s.amplitude = 0.1;
        s.midlevel = 0.5;
        s.paint(128, 128, [](int x, int y) { return dunes((x + 0.5) / 128, (y + 0.5) / 128); });
        return s;
    }
    EdgeGapsOfAPlane() : EdgeGaps(plane()) {}
};

TEST_F(EdgeGapsOfAPlane, AreNoneWhereNeighboursShareTheirNormals) {
    EXPECT_LT(of("pdm", {{"dt", 0.001}}).gap.p99, 1e-4);
    EXPECT_LT(of("exact").gap.most, 1e-4);
}

}  // namespace
}  // namespace relievo::test::edge_gap_test
