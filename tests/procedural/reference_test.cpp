// The reference meets procedural heights: it is as true as on a map that holds the same texels.
#include "renderer/reference/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "renderer/stability/sample_surfaces.h"
#include "tests/procedural/exemplars.h"

namespace relievo::reference_test {
namespace {

using glm::dvec3;
using stability::SampleSurface;

SampleSurface procedural_surface(Mesh mesh, const Exemplar& exemplar, const Procedural& settings) {
    SampleSurface surface;
    surface.mesh = std::move(mesh);
    surface.width = exemplar.width;
    surface.height = exemplar.height;
    surface.texels = exemplar.texels;
    surface.procedural = settings;
    return surface;
}

TEST(ProceduralReference, vertical_rays_meet_a_plane_at_the_sources_height) {
    const Exemplar exemplar = rough_exemplar(64, 48);
    const Procedural settings{{}, 3, {0.25, 8}, 6, 0.25};
    const SampleSurface surface = procedural_surface(stability::plane_mesh(), exemplar, settings);
    const ReferenceSurface reference = surface.reference();
    const ProceduralSource source = exemplar.source(settings);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.01, 0.99);
    for (int i = 0; i < 500; ++i) {
        const double x = unit(random), y = unit(random);
        const auto hit = reference.first_hit({x, y, 3}, {0, 0, -1}, 0, 10);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->position.z, source.value(source.texel_at({x, y})), 1e-12);
        const ReferencePoint at = reference.evaluate(0, hit->face, hit->b1, hit->b2);
        EXPECT_NEAR(at.uv.x, x, 1e-12);
        EXPECT_NEAR(at.uv.y, y, 1e-12);
    }
}

// A map of the virtual texels themselves is the same surface, but for their rounding to counts.
TEST(ProceduralReference, all_rays_meet_what_they_meet_on_a_bake_of_the_same_texels) {
    const Exemplar exemplar = rough_exemplar(32, 32);
    const Procedural settings{{}, 4, {2, 2}, 6, 0.25};  // texture coordinates 0 to 1: 128 virtual texels
    const ProceduralSource source = exemplar.source(settings);
    const SampleSurface procedural = procedural_surface(stability::ball_mesh(24, 16), exemplar, settings);
    SampleSurface baked = procedural;
    baked.procedural.reset();
    baked.wrap = Wrap::clamp;
    baked.paint(128, 128, [&](int x, int y) {
        return source.texel(glm::ivec2(source.texel_at({(x + 0.5) / 128, (y + 0.5) / 128}) + 0.5));
    });
    const ReferenceSurface a = procedural.reference(), b = baked.reference();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    int hits = 0, differ = 0;
    for (int i = 0; i < 2000; ++i) {
        const dvec3 origin = 4.0 * glm::normalize(dvec3(unit(random), unit(random), unit(random)));
        const dvec3 target = 1.4 * dvec3(unit(random), unit(random), unit(random));
        const auto one = a.trace(origin, target - origin, 0, 10),
                   other = b.trace(origin, target - origin, 0, 10);
        ASSERT_FALSE(one.undecided);
        if (one.hit.has_value() != other.hit.has_value()) ++differ;
        if (!one.hit || !other.hit) continue;
        ++hits;
        // Half a count moves grazing hits by more, and the outermost half texels are clamped on the bake.
        if (std::abs(one.hit->t - other.hit->t) > 1e-3) ++differ;
    }
    EXPECT_GT(hits, 500);
    EXPECT_LT(differ, 25);
}

}  // namespace
}  // namespace relievo::reference_test
