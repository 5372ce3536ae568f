// The clone tool: relief copied over a plane, whole and cut into islands, and over a ball.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "chart_surface.h"

namespace relievo::clone_test {
namespace {

constexpr float kAmplitude = 0.2f;

// Counts at a place of the unit square: relief with features of a tenth, on the left only.
double relief(double x, double y) {
    const double fade = std::exp(-std::pow((x - 0.25) / 0.12, 4)),
                 wave = std::sin(30 * x) * std::cos(27 * y + 1);
    return 30000 + fade * (7000 * wave + 4000 * std::sin(55 * (x + y)));
}

Brush clone_brush(float radius = 0.1f, float strength = 1.0f) {
    Brush brush;
    brush.tool = Tool::clone;
    brush.falloff = Falloff::constant;
    brush.radius = radius;
    brush.strength = strength;
    return brush;
}

FacePoint point(const ChartSurface& surface, glm::dvec2 at) {
    const Dab dab = surface.dab(at.x, at.y);
    return {dab.face, dab.b1, dab.b2};
}

// A straight stroke whose source moves along.
void clone_along(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 from,
                 glm::dvec2 to, glm::dvec2 to_source) {
    const double step = double{brush.radius} * double{brush.spacing};
    const int count = static_cast<int>(std::ceil(glm::length(to - from) / step));
    sculptor.begin(brush);
    for (int i = 0; i <= count; ++i) {
        const glm::dvec2 at = from + (to - from) * (i / std::max(1.0, double(count)));
        const FacePoint source = point(surface, at + to_source);
        sculptor.dab(surface.dab(at.x, at.y), {}, std::span(&source, 1));
    }
    sculptor.end();
}

struct Plane {
    explicit Plane(int size = 256)
        : map(size, size), surface(map, {unit_chart(map)}, kAmplitude), sculptor(map, surface) {
        fill(map, [&](int x, int y) { return relief((x + 0.5) / size, (y + 0.5) / size); });
    }
    HeightMap map;
    ChartSurface surface;
    Sculptor sculptor;
};

TEST(Clone, whole_texels_away_the_copy_equals_the_original) {
    Plane plane;
    clone_along(plane.sculptor, plane.surface, clone_brush(), {0.75, 0.4}, {0.75, 0.6}, {-0.5, 0});
    int largest = 0;
    for (int y = 103; y < 153; ++y)
        for (int x = 180; x < 204; ++x)
            largest = std::max(largest, std::abs(plane.map.at(x, y) - plane.map.at(x - 128, y)));
    EXPECT_LE(largest, 2);
}

TEST(Clone, between_texels_the_copy_is_the_relief_moved) {
    Plane plane;
    const glm::dvec2 way(-0.5 + 0.37 / 256, 0.02 + 0.61 / 256);
    clone_along(plane.sculptor, plane.surface, clone_brush(), {0.75, 0.4}, {0.75, 0.6}, way);
    double largest = 0;
    for (int y = 103; y < 153; ++y)
        for (int x = 180; x < 204; ++x)
            largest = std::max(largest, std::abs(plane.map.at(x, y) -
                                                 relief((x + 0.5) / 256 + way.x, (y + 0.5) / 256 + way.y)));
    EXPECT_LE(largest, 70) << "counts of 22,000: linear between texels";
}

TEST(Clone, strength_is_a_part_of_the_way_however_often_the_stroke_passes) {
    Plane once, often;
    const int before = once.map.at(192, 128), source = once.map.at(64, 128);
    ASSERT_GT(std::abs(source - before), 1000);
    for (Plane* plane : {&once, &often}) {
        plane->sculptor.begin(clone_brush(0.1f, 0.5f));
        for (int i = 0; i < (plane == &once ? 1 : 8); ++i) {
            const FacePoint from = point(plane->surface, {0.25, 0.5});
            plane->sculptor.dab(plane->surface.dab(0.75, 0.5), {}, std::span(&from, 1));
        }
        plane->sculptor.end();
        EXPECT_NEAR(plane->map.at(192, 128), (before + source) / 2.0, 2);
    }
}

TEST(Clone, over_its_own_source_it_takes_what_was_there_before_the_stroke) {
    Plane plane;
    const HeightMap before = plane.map;
    clone_along(plane.sculptor, plane.surface, clone_brush(), {0.2, 0.5}, {0.4, 0.5}, {-0.0625, 0});
    int largest = 0;
    for (int x = 56; x < 100; ++x)
        largest = std::max(largest, std::abs(plane.map.at(x, 128) - before.at(x - 16, 128)));
    EXPECT_LE(largest, 2);
}

TEST(Clone, a_turn_is_followed) {
    Plane plane;
    Dab dab = plane.surface.dab(0.75, 0.5);
    dab.drag = {0, 0,
                static_cast<std::int32_t>(std::lround(std::sqrt(0.5) * Dab::kDragOne))};  // a quarter about z
    const FacePoint from = point(plane.surface, {0.25, 0.5});
    plane.sculptor.begin(clone_brush());
    plane.sculptor.dab(dab, {}, std::span(&from, 1));
    plane.sculptor.end();
    double largest = 0;
    for (int y = 116; y < 140; ++y)
        for (int x = 180; x < 204; ++x) {
            const double u = (x + 0.5) / 256 - 0.75, v = (y + 0.5) / 256 - 0.5;
            largest = std::max(largest, std::abs(plane.map.at(x, y) - relief(0.25 - v, 0.5 + u)));
        }
    EXPECT_LE(largest, 20);
}

TEST(Clone, from_one_island_to_another_of_other_turn_and_scale) {
    HeightMap map(256, 256);
    const ChartSurface surface(
        map,
        {{{0, 0}, {0.5, 1}, {2, 0}, {96, 0}, {0, 96}}, {{0.5, 0}, {1, 1}, {230, 20}, {0, 144}, {-144, 0}}},
        kAmplitude);
    const auto broad = [](double x, double y) { return 30000 + 6000 * std::sin(12 * x) * std::cos(11 * y); };
    std::vector<SurfaceTexel> texels;
    surface.texels_in_ball({0.25f, 0.5f, 0.0f}, 0.6f, texels);
    for (const SurfaceTexel& t : texels)
        if (t.position.x < 0.5f)
            map.set(
                t.x, t.y,
                static_cast<std::uint16_t>(std::lround(broad(double{t.position.x}, double{t.position.y}))));
    Sculptor sculptor(map, surface);
    clone_along(sculptor, surface, clone_brush(), {0.75, 0.45}, {0.75, 0.55}, {-0.5, 0.01});
    surface.texels_in_ball({0.75f, 0.5f, surface.at(point(surface, {0.75, 0.5}).face, 0, 0).position.z}, 0.2f,
                           texels);
    double largest = 0;
    std::size_t count = 0;
    for (const SurfaceTexel& t : texels) {
        const double x = double{t.position.x}, y = double{t.position.y};
        if (std::hypot(x - 0.75, y - 0.5) > 0.09) continue;
        largest = std::max(largest, std::abs(map.at(t.x, t.y) - broad(x - 0.5, y + 0.01)));
        ++count;
    }
    EXPECT_GT(count, 300u);
    EXPECT_LE(largest, 30) << "counts of 12,000, linear between 96 texels a unit";
}

TEST(Clone, high_and_thin_relief_is_found_though_it_stands_out_of_the_ball) {
    Plane plane;
    const HeightMap flat(256, 256, 5000);
    fill(plane.map, [](int x, int y) {
        return 5000 + 60000 * std::exp(-(std::pow(x - 68.0, 2) + std::pow(y - 128.0, 2)) / 18.0);
    });
    clone_along(plane.sculptor, plane.surface, clone_brush(0.05f), {0.75, 0.5}, {0.75, 0.5}, {-0.5, 0});
    for (int x = 62; x < 75; ++x) EXPECT_NEAR(plane.map.at(x + 128, 128), plane.map.at(x, 128), 3) << x;
}

TEST(Clone, needs_a_source_for_every_dab_and_no_other_tool_takes_one) {
    Plane plane(32);
    const FacePoint from = point(plane.surface, {0.25, 0.5}), nowhere{999, 0, 0};
    const std::uint64_t hash = plane.map.hash();
    plane.sculptor.begin(clone_brush());
    EXPECT_THROW(plane.sculptor.dab(plane.surface.dab(0.75, 0.5)), std::out_of_range);
    EXPECT_THROW(plane.sculptor.dab(plane.surface.dab(0.75, 0.5), {}, std::span(&nowhere, 1)),
                 std::out_of_range);
    plane.sculptor.cancel();
    plane.sculptor.begin(Brush{});
    EXPECT_THROW(plane.sculptor.dab(plane.surface.dab(0.75, 0.5), {}, std::span(&from, 1)),
                 std::out_of_range);
    plane.sculptor.cancel();
    EXPECT_EQ(plane.map.hash(), hash);
}

}  // namespace
}  // namespace relievo::clone_test
