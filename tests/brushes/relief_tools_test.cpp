// The tools that shape and carry relief, on flat surfaces whose right answer is known, whole and cut.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/dab_tools.h"
#include "relief_plane.h"

namespace relievo::relief_tools_test {
namespace {

void fill_bump(HeightMap& map, double x, double y, double width, double counts) {
    fill(map, [&](int i, int j) {
        return 32768 + counts * bump((i + 0.5) / map.width() - x, (j + 0.5) / map.height() - y, width);
    });
}

// The mean place of what rises above 32768.
glm::dvec2 centroid(const HeightMap& map) {
    glm::dvec2 sum(0);
    double total = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            const double rise = std::max(0, map.at(x, y) - 32768);
            sum += rise * glm::dvec2((x + 0.5) / map.width(), (y + 0.5) / map.height());
            total += rise;
        }
    return sum / total;
}

// A grab at `at`, drawn away in `steps` dabs. Drags are in world units.
void pull(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 at, glm::dvec3 drag,
          int steps) {
    sculptor.begin(brush);
    for (int i = 0; i <= steps; ++i) {
        Dab dab = surface.dab(at.x, at.y);
        for (int k = 0; k < 3; ++k)
            dab.drag[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(
                std::lround(drag[k] * i / steps / double{brush.radius} * Dab::kDragOne));
        sculptor.dab(dab);
    }
    sculptor.end();
}

TEST(Draw, without_accumulate_a_stroke_has_one_height) {
    Plane plane;
    Brush brush = brush_of(Tool::draw);
    brush.accumulate = false;
    plane.sculptor.begin(brush);
    for (int i = 0; i < 30; ++i) plane.sculptor.dab(plane.surface.dab(0.5, 0.5));
    plane.sculptor.end();
    EXPECT_NEAR((plane.at(0.5, 0.5) - 32768) / 65535.0 * 0.2, double{kDrawRise} * 0.1, 0.002);
}

TEST(Dab, half_the_size_reaches_half_as_far_and_rises_half_as_high) {
    Plane whole, half;
    const Brush brush = brush_of(Tool::draw);
    Dab dab = whole.surface.dab(0.5, 0.5);
    whole.sculptor.begin(brush);
    whole.sculptor.dab(dab);
    whole.sculptor.end();
    dab.size = Dab::kSizeOne / 2;
    half.sculptor.begin(brush);
    half.sculptor.dab(dab);
    half.sculptor.end();
    EXPECT_NEAR(half.at(0.5, 0.5) - 32768, (whole.at(0.5, 0.5) - 32768) / 2.0, 20);
    EXPECT_GT(whole.at(0.56, 0.5), 32768);
    EXPECT_EQ(half.at(0.56, 0.5), 32768);
}

TEST(Clay, pits_fill_first_and_peaks_stay) {
    Plane plane;
    fill(plane.map, [](int x, int y) {
        return 32768 + 6000 * bump((x - 118) / 256.0, (y - 128) / 256.0, 0.012) -
               6000 * bump((x - 138) / 256.0, (y - 128) / 256.0, 0.012);
    });
    const HeightMap before = plane.map;
    tap(plane.sculptor, plane.surface, brush_of(Tool::clay, 0.15f), {0.5, 0.5});
    EXPECT_EQ(plane.map.at(118, 128), before.at(118, 128)) << "the peak";
    const int pit = plane.map.at(138, 128) - before.at(138, 128),
              ground = plane.map.at(128, 140) - before.at(128, 140);
    EXPECT_GT(ground, 0);
    EXPECT_GT(pit, 1.5 * ground);
}

TEST(Clay, inverted_scrapes_the_peak_only) {
    Plane plane;
    fill_bump(plane.map, 0.5, 0.5, 0.02, 6000);
    Brush brush = brush_of(Tool::clay, 0.15f);
    brush.invert = true;
    const HeightMap before = plane.map;
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    EXPECT_LT(plane.at(0.5, 0.5), before.at(128, 128) - 100);
}

TEST(Clay, negative_amplitude_still_adds) {
    Plane plane(128, 32768, -kAmplitude);
    tap(plane.sculptor, plane.surface, brush_of(Tool::clay), {0.5, 0.5});
    EXPECT_LT(plane.at(0.5, 0.5), 32768);
}

TEST(Crease, groove_is_narrower_than_a_drawn_one_and_inverted_a_ridge) {
    Plane crease, drawn, ridge;
    stroke(crease.sculptor, crease.surface, brush_of(Tool::crease), {0.2, 0.5}, {0.8, 0.5});
    Brush brush = brush_of(Tool::draw);
    brush.invert = true;
    stroke(drawn.sculptor, drawn.surface, brush, {0.2, 0.5}, {0.8, 0.5});
    brush = brush_of(Tool::crease);
    brush.invert = true;
    stroke(ridge.sculptor, ridge.surface, brush, {0.2, 0.5}, {0.8, 0.5});
    const auto half_width = [](const Plane& plane) {  // texels to half the depth
        const int depth = 32768 - plane.map.at(128, 128);
        int y = 128;
        while (32768 - plane.map.at(128, y) > depth / 2) ++y;
        return y - 128;
    };
    EXPECT_LT(crease.at(0.5, 0.5), 32768 - 2000);
    EXPECT_LT(half_width(crease), 0.75 * half_width(drawn));
    EXPECT_GT(ridge.at(0.5, 0.5), 32768 + 2000);
}

TEST(Pinch, bumps_come_closer_and_spread_inverted_and_flat_ground_stays) {
    const auto spread_of = [](bool invert) {
        Plane plane;
        fill(plane.map, [](int x, int y) {
            return 32768 + 8000 * bump((x - 115) / 256.0, (y - 128) / 256.0, 0.015) +
                   8000 * bump((x - 141) / 256.0, (y - 128) / 256.0, 0.015);
        });
        Brush brush = brush_of(Tool::pinch, 0.15f);
        brush.invert = invert;
        for (int i = 0; i < 4; ++i) tap(plane.sculptor, plane.surface, brush, {128.5 / 256, 128.5 / 256});
        double sum = 0, total = 0;
        for (int x = 90; x < 166; ++x)
            sum += std::abs(x - 128.0) * (plane.map.at(x, 128) - 32768),
                total += plane.map.at(x, 128) - 32768;
        return sum / total;
    };
    EXPECT_LT(spread_of(false), 10.0);  // 13 before
    EXPECT_GT(spread_of(true), 15.0);
    Plane flat;
    tap(flat.sculptor, flat.surface, brush_of(Tool::pinch), {0.5, 0.5});
    EXPECT_FALSE(flat.sculptor.can_undo());
}

TEST(Smear, a_bump_goes_with_the_hand) {
    Plane plane;
    fill_bump(plane.map, 0.4, 0.5, 0.02, 8000);
    Brush brush = brush_of(Tool::smear, 0.12f);
    brush.hardness = 0.6f;
    stroke(plane.sculptor, plane.surface, brush, {0.4, 0.5}, {0.5, 0.5});
    EXPECT_NEAR(centroid(plane.map).x, 0.5, 0.015);
    EXPECT_NEAR(centroid(plane.map).y, 0.5, 0.005);
    EXPECT_GT(plane.at(0.5, 0.5), 32768 + 5000);
}

TEST(Smear, half_strength_carries_half_as_much_a_dab) {
    Plane full, half;
    for (Plane* plane : {&full, &half}) {
        fill(plane->map, [](int x, int) { return 20000 + 100.0 * x; });
        Brush brush = brush_of(Tool::smear, 0.12f, plane == &full ? 1.0f : 0.5f);
        brush.hardness = 0.9f;
        plane->sculptor.begin(brush);
        plane->sculptor.dab(plane->surface.dab(0.5, 0.5));
        plane->sculptor.dab(plane->surface.dab(0.52, 0.5));
        plane->sculptor.end();
    }
    EXPECT_NEAR(full.map.at(128, 128) - (20000 + 12800), -512, 12);
    EXPECT_NEAR(half.map.at(128, 128) - (20000 + 12800), -256, 6);
}

TEST(Smear, a_jump_to_elsewhere_carries_nothing) {
    Plane plane;
    fill_bump(plane.map, 0.2, 0.2, 0.03, 8000);
    plane.sculptor.begin(brush_of(Tool::smear, 0.1f));
    plane.sculptor.dab(plane.surface.dab(0.2, 0.2));
    plane.sculptor.dab(plane.surface.dab(0.8, 0.8));
    plane.sculptor.end();
    EXPECT_FALSE(plane.sculptor.can_undo());
}

TEST(Grab, what_is_held_follows_the_hand_near_and_far) {
    for (const double way : {0.05, 0.2}) {  // a third of the radius, and more than it
        Plane plane;
        fill_bump(plane.map, 0.4, 0.5, 0.02, 8000);
        Brush brush = brush_of(Tool::grab, 0.15f);
        brush.hardness = 0.3f;
        pull(plane.sculptor, plane.surface, brush, {0.4, 0.5}, {way, 0, 0}, 10);
        int best = 0;
        for (int x = 0; x < 256; ++x)
            if (plane.map.at(x, 128) > plane.map.at(best, 128)) best = x;
        EXPECT_NEAR((best + 0.5) / 256, 0.4 + way, 0.012) << way;
        EXPECT_GT(plane.map.at(best, 128), 32768 + 6500) << way;
        EXPECT_NEAR(plane.at(0.4 - 0.05, 0.5), 32768, 1500) << "nothing is left behind";
    }
}

TEST(Grab, lifting_raises_the_middle_by_the_drag_and_a_flat_surface_slides_unseen) {
    Plane lifted, slid;
    pull(lifted.sculptor, lifted.surface, brush_of(Tool::grab, 0.15f), {0.5, 0.5}, {0, 0, 0.05}, 7);
    EXPECT_NEAR((lifted.at(0.5, 0.5) - 32768) / 65535.0 * 0.2, 0.05, 0.001);
    pull(slid.sculptor, slid.surface, brush_of(Tool::grab, 0.15f), {0.5, 0.5}, {0.1, 0.02, 0}, 7);
    EXPECT_FALSE(slid.sculptor.can_undo());
}

TEST(Grab, coming_back_leaves_what_was) {
    Plane plane;
    fill_bump(plane.map, 0.5, 0.5, 0.03, 8000);
    const HeightMap before = plane.map;
    const Brush brush = brush_of(Tool::grab, 0.15f);
    plane.sculptor.begin(brush);
    for (const std::int32_t x : {0, 10000, 20000, 8000, 0}) {
        Dab dab = plane.surface.dab(0.5, 0.5);
        dab.drag = {x, 0, x / 4};
        plane.sculptor.dab(dab);
    }
    plane.sculptor.end();
    EXPECT_EQ(plane.map.hash(), before.hash());
}

TEST(Grab, one_long_leap_is_taken_in_steps) {
    Plane leap, walk;
    for (Plane* plane : {&leap, &walk}) {
        fill_bump(plane->map, 0.4, 0.5, 0.02, 8000);
        pull(plane->sculptor, plane->surface, brush_of(Tool::grab, 0.1f), {0.4, 0.5}, {0.2, 0, 0},
             plane == &leap ? 1 : 40);
    }
    EXPECT_NEAR(centroid(leap.map).x, centroid(walk.map).x, 0.02);
    EXPECT_GT(centroid(leap.map).x, 0.5);
}

TEST(Grab, absurd_drags_stay_in_range) {
    for (const std::int32_t drag : {Dab::kLargestDrag, -Dab::kLargestDrag}) {
        Plane plane(64);
        fill_bump(plane.map, 0.5, 0.5, 0.1, 8000);
        plane.sculptor.begin(brush_of(Tool::grab, 0.2f));
        Dab dab = plane.surface.dab(0.5, 0.5);
        dab.drag = {drag, drag, drag};
        plane.sculptor.dab(dab);
        plane.sculptor.end();
        plane.sculptor.undo();
        EXPECT_FALSE(plane.sculptor.can_undo());
    }
    Plane plane(64);
    plane.sculptor.begin(brush_of(Tool::grab));
    Dab dab = plane.surface.dab(0.5, 0.5);
    dab.drag[1] = Dab::kLargestDrag + 1;
    EXPECT_THROW(plane.sculptor.dab(dab), std::out_of_range);
    dab = plane.surface.dab(0.5, 0.5);
    dab.size = 0;
    EXPECT_THROW(plane.sculptor.dab(dab), std::out_of_range);
    plane.sculptor.cancel();
}

TEST(Noise, is_rough_at_its_grain_and_the_seed_chooses_it) {
    Plane first, again, other;
    const auto roughen = [](Plane& plane, float seed) {
        Brush brush = brush_of(Tool::noise, 0.3f);
        brush.seed = seed;
        brush.hardness = 0.9f;
        tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    };
    roughen(first, 1), roughen(again, 1), roughen(other, 2);
    EXPECT_EQ(first.map.hash(), again.map.hash());
    EXPECT_NE(first.map.hash(), other.map.hash());
    int low = 65535, high = 0;
    double mean = 0;
    for (int y = 100; y < 156; ++y)
        for (int x = 100; x < 156; ++x) {
            low = std::min<int>(low, first.map.at(x, y)), high = std::max<int>(high, first.map.at(x, y));
            mean += (first.map.at(x, y) - 32768) / (56.0 * 56.0);
        }
    const double most = double{kDrawRise} * 0.3 * 0.15 / 0.2 * 65535;
    EXPECT_LT(low, 32768 - 0.2 * most);
    EXPECT_GT(high, 32768 + 0.2 * most);
    EXPECT_LT(std::abs(mean), 0.25 * most);
    EXPECT_EQ(first.at(0.1, 0.1), 32768);
    Brush brush = brush_of(Tool::noise);
    brush.seed = 0.5f;
    EXPECT_THROW(first.sculptor.begin(brush), std::invalid_argument);
}

// The unit square cut at x = 0.5 into two islands with gutters, 96 texels a unit, both along texel columns.
struct Cut {
    Cut()
        : map(128, 96),
          surface(
              map,
              {{{0, 0}, {0.5, 1}, {2, 0}, {96, 0}, {0, 96}}, {{0.5, 0}, {1, 1}, {70, 0}, {96, 0}, {0, 96}}},
              kAmplitude) {
        for (int y = 0; y < 96; ++y) copy(50, 70, y), copy(69, 49, y);
    }
    void copy(int gutter, int source, int y) {
        surface.table.copies.push_back({static_cast<std::uint32_t>(map.index(gutter, y)),
                                        static_cast<std::uint32_t>(map.index(source, y))});
    }
    HeightMap map;
    ChartSurface surface;
};

TEST(ReliefTools, a_cut_between_islands_does_not_show) {
    const auto relief = [](double x, double y) {
        return 32768 + 9000 * bump(x - 0.5, y - 0.5, 0.05) + 2000 * std::sin(40 * x) * std::sin(35 * y);
    };
    for (const Tool tool :
         {Tool::inflate, Tool::clay, Tool::crease, Tool::pinch, Tool::smear, Tool::grab, Tool::noise}) {
        Cut cut;
        HeightMap whole_map(96, 96);
        const ChartSurface whole(whole_map, {unit_chart(whole_map)}, kAmplitude);
        fill(whole_map, [&](int x, int y) { return relief((x + 0.5) / 96, (y + 0.5) / 96); });
        fill(cut.map, [&](int x, int y) {
            const int column = x < 60 ? x - 2 : x - 70 + 48;
            return relief((column + 0.5) / 96, (y + 0.5) / 96);
        });
        Sculptor on_cut(cut.map, cut.surface), on_whole(whole_map, whole);
        const Brush brush = brush_of(tool, 0.15f, 0.9f);
        if (tool == Tool::grab) {
            pull(on_cut, cut.surface, brush, {0.45, 0.5}, {0.12, 0.03, 0.02}, 9);
            pull(on_whole, whole, brush, {0.45, 0.5}, {0.12, 0.03, 0.02}, 9);
        } else {
            stroke(on_cut, cut.surface, brush, {0.4, 0.45}, {0.6, 0.55});
            stroke(on_whole, whole, brush, {0.4, 0.45}, {0.6, 0.55});
        }
        EXPECT_TRUE(on_whole.can_undo()) << int(tool);
        int largest = 0;
        for (int y = 0; y < 96; ++y)
            for (int x = 0; x < 96; ++x)
                largest = std::max(
                    largest, std::abs(whole_map.at(x, y) - cut.map.at(x < 48 ? 2 + x : 70 + x - 48, y)));
        EXPECT_LE(largest, 25) << int(tool) << ": counts, after strokes of thousands";
        EXPECT_EQ(cut.surface.gap(0, 1, {0.5, 0.02}, {0.5, 0.98}), 0.0) << int(tool);
    }
}

TEST(ReliefTools, weak_dabs_add_up) {
    for (const Tool tool : {Tool::inflate, Tool::clay, Tool::crease, Tool::noise, Tool::pinch, Tool::smear}) {
        Plane plane(64);
        fill(plane.map, [](int x, int y) { return 32768 + 40 * std::sin(x * 0.5) * std::cos(y * 0.4); });
        const HeightMap before = plane.map;
        Brush brush = brush_of(tool, 0.2f, 0.005f);
        plane.sculptor.begin(brush);
        for (int i = 0; i < 150; ++i) plane.sculptor.dab(plane.surface.dab(0.5 + 0.1 * (i % 2), 0.52));
        plane.sculptor.end();
        EXPECT_TRUE(plane.sculptor.can_undo() || tool == Tool::smear) << int(tool);
    }
}

}  // namespace
}  // namespace relievo::relief_tools_test
