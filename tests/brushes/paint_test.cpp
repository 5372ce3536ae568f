// Painting: what dabs blend into the colour map, beside or in place of the heights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "brushes/dab_tools.h"
#include "chart_surface.h"

namespace relievo::paint_test {
namespace {

constexpr std::array<std::uint16_t, 3> kGround{20 * 257, 100 * 257, 200 * 257};

struct Plane {
    explicit Plane(int bits = 16, int size = 128, float amplitude = 0.2f,
                   std::size_t budget = std::size_t{1} << 30)
        : map(size, size),
          colours(size, size, bits, kGround),
          surface(map, {unit_chart(map)}, amplitude),
          sculptor(map, surface, budget) {
        sculptor.set_colours(colours);
    }
    HeightMap map;
    ColourMap colours;
    ChartSurface surface;
    Sculptor sculptor;
};

Brush brush_of(Paint paint, float strength = 1.0f, Tool tool = Tool::draw) {
    Brush brush;
    brush.tool = tool;
    brush.radius = 0.2f;
    brush.strength = strength;
    brush.paint = paint;
    brush.red = 1.0f, brush.green = 0.25f, brush.blue = 0.0f;
    return brush;
}

double target_of(const Brush& brush, std::size_t channel) {
    const float part[] = {brush.red, brush.green, brush.blue};
    return double{part[channel]} * 65535;
}

// Of the dab at the middle of the texel (x, y) seen from the middle of texel (cx, cy).
double falloff_at(const Plane& plane, const Brush& brush, int x, int y, double cx, double cy) {
    const double d = std::hypot((x + 0.5) / plane.map.width() - cx, (y + 0.5) / plane.map.height() - cy);
    return d < double{brush.radius}
               ? double{falloff_weight(brush, static_cast<float>(d / double{brush.radius}))}
               : 0;
}

TEST(Paint, one_dab_blends_by_the_documented_fraction) {
    for (const int bits : {8, 16})
        for (const double pressure : {1.0, 0.5}) {
            Plane plane(bits);
            Brush brush = brush_of(Paint::colour, 0.8f);
            brush.hardness = 0.3f;
            plane.sculptor.begin(brush);
            plane.sculptor.dab(plane.surface.dab(0.5, 0.4, pressure));
            plane.sculptor.end();
            const double step = plane.colours.step();
            for (int y = 0; y < 128; ++y)
                for (int x = 0; x < 128; ++x)
                    for (std::size_t k = 0; k < 3; ++k) {
                        const double part = 0.8 * pressure * falloff_at(plane, brush, x, y, 0.5, 0.4) *
                                            double{brush.spacing} / 0.15;
                        const double wanted =
                            kGround[k] + (target_of(brush, k) - kGround[k]) * std::min(part, 1.0);
                        ASSERT_NEAR(plane.colours.plane(k).at(x, y), wanted, 0.5 * step + 3)
                            << x << ", " << y;
                        ASSERT_EQ(plane.colours.plane(k).at(x, y) % plane.colours.step(), 0);
                    }
        }
}

TEST(Paint, thousand_weak_dabs_do_not_round_away) {
    for (const int bits : {8, 16}) {
        Plane plane(bits);
        Brush brush = brush_of(Paint::colour, 0.0005f);  // far less than half a value of 8 bits a dab
        brush.falloff = Falloff::constant;
        plane.sculptor.begin(brush);
        for (int i = 0; i < 1000; ++i) plane.sculptor.dab(plane.surface.dab(0.5, 0.5));
        plane.sculptor.end();
        const double part = 1 - std::pow(1 - 0.0005, 1000);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(plane.colours.plane(k).at(64, 64),
                        kGround[k] + (target_of(brush, k) - kGround[k]) * part,
                        0.5 * plane.colours.step() + 8);
    }
}

TEST(Paint, without_accumulate_passing_again_in_a_stroke_adds_nothing) {
    for (const Tool tool : {Tool::draw, Tool::level}) {
        Plane once, often;
        Brush brush = brush_of(Paint::colour, 0.5f, tool);
        brush.accumulate = false;
        tap(once.sculptor, once.surface, brush, {0.5, 0.5});
        often.sculptor.begin(brush);
        for (int i = 0; i < 50; ++i) often.sculptor.dab(often.surface.dab(0.5, 0.5));
        often.sculptor.end();
        EXPECT_EQ(once.colours.hash(), often.colours.hash());
        EXPECT_NEAR(once.colours.plane(0).at(64, 64), (kGround[0] + 65535) / 2, 200);
        tap(often.sculptor, often.surface, brush, {0.5, 0.5});
        EXPECT_GT(often.colours.plane(0).at(64, 64), once.colours.plane(0).at(64, 64))
            << "a second stroke goes on";
    }
}

TEST(Paint, full_strength_arrives_at_the_very_colour) {
    Plane plane(8);
    Brush brush = brush_of(Paint::colour);
    brush.red = 200 / 255.0f, brush.green = 3 / 255.0f, brush.blue = 0.5f;
    brush.hardness = 0.5f;
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    EXPECT_EQ(plane.colours.plane(0).at(64, 64), 200 * 257);
    EXPECT_EQ(plane.colours.plane(1).at(64, 64), 3 * 257);
    EXPECT_EQ(plane.colours.plane(2).at(64, 64), 128 * 257);
}

TEST(Paint, switch_says_what_each_tool_changes) {
    const auto white = std::make_shared<const Alpha>("white", 1, 1, std::vector<float>{1.0f});
    for (const ToolInfo& info : tools()) {
        if (info.tool == Tool::mask) continue;
        for (const Paint paint : {Paint::height, Paint::colour, Paint::both}) {
            Plane plane;
            fill(plane.map, [](int x, int y) { return 30000 + 311 * ((x * 7 + y * 13) % 17); });
            fill(plane.colours.plane(1), [](int x, int y) { return 20000 + 411 * ((x * 11 + y * 5) % 19); });
            const std::uint64_t heights = plane.map.hash(), colours = plane.colours.hash();
            plane.sculptor.begin(brush_of(paint, 0.7f, info.tool), white);
            for (int i = 0; i < 6; ++i) {
                Dab dab = plane.surface.dab(0.3 + (info.tool == Tool::grab ? 0 : 0.04 * i), 0.5);
                dab.drag = {i * 5000, 1000, i * 4000};
                const FacePoint source{dab.face, dab.b1 / 2, dab.b2};
                const bool clones = info.tool == Tool::clone;
                plane.sculptor.dab(dab, {}, std::span(&source, clones ? 1u : 0u));
            }
            plane.sculptor.end();
            const bool can = holds(kPaintingTools, info.tool);
            EXPECT_EQ(plane.colours.hash() != colours, can && paint != Paint::height) << info.name;
            EXPECT_EQ(plane.map.hash() != heights, !can || paint != Paint::colour) << info.name;
        }
    }
}

TEST(Paint, smooth_evens_colours_out_as_it_does_heights) {
    Plane colours, heights;
    const auto spike = [](int x, int y) { return x / 4 % 2 == y / 4 % 2 ? 20000 : 30000; };
    fill(colours.colours.plane(2), spike);
    fill(heights.map, spike);
    // A surface so flat that heights do not change distances.
    ChartSurface flat(heights.map, {unit_chart(heights.map)}, 1e-6f);
    Sculptor on_flat(heights.map, flat);
    stroke(on_flat, flat, brush_of(Paint::height, 0.8f, Tool::smooth), {0.4, 0.5}, {0.6, 0.5});
    stroke(colours.sculptor, colours.surface, brush_of(Paint::colour, 0.8f, Tool::smooth), {0.4, 0.5},
           {0.6, 0.5});
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            ASSERT_NEAR(colours.colours.plane(2).at(x, y), heights.map.at(x, y), 1) << x << ", " << y;
    EXPECT_NEAR(colours.colours.plane(2).at(64, 64), 25000, 1500);
    EXPECT_EQ(colours.colours.plane(0).at(64, 64), kGround[0]);
}

TEST(Paint, both_does_what_height_and_colour_do_each) {
    Plane both, height, colour;
    for (const auto& [plane, paint] :
         {std::pair{&both, Paint::both}, {&height, Paint::height}, {&colour, Paint::colour}})
        tap(plane->sculptor, plane->surface, brush_of(paint), {0.5, 0.5});
    EXPECT_EQ(both.map.hash(), height.map.hash());
    EXPECT_EQ(both.colours.hash(), colour.colours.hash());
}

TEST(Paint, is_undone_and_redone_to_the_byte_in_one_step_with_the_height) {
    for (const int bits : {8, 16}) {
        Plane plane(bits);
        std::vector<std::pair<std::uint64_t, std::uint64_t>> states;
        const auto note = [&] { states.emplace_back(plane.map.hash(), plane.colours.hash()); };
        note();
        for (const Paint paint : {Paint::both, Paint::colour, Paint::height, Paint::both}) {
            stroke(plane.sculptor, plane.surface, brush_of(paint, 0.3f),
                   {0.2, 0.3 + 0.1 * double(states.size())}, {0.8, 0.5});
            note();
        }
        EXPECT_EQ(plane.sculptor.steps_made(), 4u);
        for (std::size_t i = states.size() - 1; i-- > 0;) {
            plane.sculptor.undo();
            EXPECT_EQ(std::pair(plane.map.hash(), plane.colours.hash()), states[i]) << i;
        }
        EXPECT_FALSE(plane.sculptor.can_undo());
        for (std::size_t i = 1; i < states.size(); ++i) {
            plane.sculptor.redo();
            EXPECT_EQ(std::pair(plane.map.hash(), plane.colours.hash()), states[i]) << i;
        }
    }
}

TEST(Paint, counts_in_the_same_budget_of_bytes_as_the_heights) {
    Plane plain(16, 128, 0.2f), tight(16, 128, 0.2f, 60000);
    stroke(plain.sculptor, plain.surface, brush_of(Paint::height), {0.3, 0.5}, {0.6, 0.5});
    const std::size_t of_heights = plain.sculptor.undo_bytes();
    plain.sculptor.undo();
    stroke(plain.sculptor, plain.surface, brush_of(Paint::both), {0.3, 0.5}, {0.6, 0.5});
    EXPECT_GT(plain.sculptor.undo_bytes(), 3 * of_heights);
    for (int i = 0; i < 8; ++i)
        stroke(tight.sculptor, tight.surface, brush_of(Paint::both, 0.2f), {0.3, 0.1 * i}, {0.4, 0.1 * i});
    EXPECT_LE(tight.sculptor.undo_bytes(), 60000u);
}

TEST(Paint, reports_the_texels_that_changed_and_leaves_no_trace_when_cancelled) {
    Plane plane;
    const ColourMap before = plane.colours;
    const auto covered = [&](const std::vector<TexelRect>& rects) {
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                bool changed = false, inside = false;
                for (std::size_t k = 0; k < 3; ++k)
                    changed = changed || plane.colours.plane(k).at(x, y) != before.plane(k).at(x, y);
                for (const TexelRect& r : rects)
                    inside = inside || (x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1);
                if (changed && !inside) return false;
            }
        return !rects.empty();
    };
    plane.sculptor.begin(brush_of(Paint::colour));
    EXPECT_TRUE(plane.sculptor.dab(plane.surface.dab(0.5, 0.5)).empty()) << "no height changed";
    plane.sculptor.dab(plane.surface.dab(0.6, 0.5));
    const auto rects = plane.sculptor.take_painted();
    EXPECT_TRUE(covered(rects));
    for (std::size_t i = 0; i < rects.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(rects[i].overlaps(rects[j]));
    EXPECT_TRUE(plane.sculptor.take_painted().empty());
    plane.sculptor.cancel();
    EXPECT_EQ(plane.colours.hash(), before.hash());
    EXPECT_FALSE(plane.sculptor.take_painted().empty());
    EXPECT_FALSE(plane.sculptor.can_undo());
    tap(plane.sculptor, plane.surface, brush_of(Paint::colour), {0.2, 0.2});
    plane.sculptor.take_painted();
    plane.sculptor.undo();
    EXPECT_FALSE(plane.sculptor.take_painted().empty());
}

TEST(Paint, mask_protects_colours_as_it_protects_heights) {
    Plane half, free;
    Brush mask = brush_of(Paint::height, 0.5f, Tool::mask);
    mask.hardness = 0.9f;
    tap(half.sculptor, half.surface, mask, {0.5, 0.5});
    for (Plane* plane : {&half, &free})
        tap(plane->sculptor, plane->surface, brush_of(Paint::colour, 0.8f), {0.5, 0.5});
    EXPECT_NEAR(half.colours.plane(0).at(64, 64) - kGround[0],
                (free.colours.plane(0).at(64, 64) - kGround[0]) / 2.0, 2);
    half.sculptor.clear_mask();
    half.sculptor.invert_mask();
    const std::uint64_t hash = half.colours.hash();
    tap(half.sculptor, half.surface, brush_of(Paint::both), {0.5, 0.5});
    EXPECT_EQ(half.colours.hash(), hash);
}

TEST(Paint, amplitude_0_can_be_painted) {
    Plane plane(8, 32, 0.0f);
    const std::uint64_t heights = plane.map.hash(), colours = plane.colours.hash();
    tap(plane.sculptor, plane.surface, brush_of(Paint::both), {0.5, 0.5});
    EXPECT_EQ(plane.map.hash(), heights);
    EXPECT_NE(plane.colours.hash(), colours);
}

TEST(Paint, map_of_one_texel_can_be_painted) {
    Plane plane(8, 1);
    tap(plane.sculptor, plane.surface, brush_of(Paint::both), {0.5, 0.5});
    EXPECT_EQ(plane.colours.plane(0).at(0, 0), 65535);
}

TEST(Paint, mirrored_copies_paint_the_same_on_both_sides_and_once_where_they_overlap) {
    HeightMap map(128, 128);
    ColourMap colours(128, 128, 16);
    ChartSurface surface(map, {{{-1, -1}, {1, 1}, {0, 0}, {64, 0}, {0, 64}}}, 0.2f);
    Sculptor sculptor(map, surface);
    sculptor.set_colours(colours);
    Brush brush = brush_of(Paint::both, 0.5f);
    brush.mirror_x = true;
    sculptor.begin(brush);
    const auto dab_at = [&](double x, double y) {
        const Dab copy = surface.dab(-x, y);
        const FacePoint point{copy.face, copy.b1, copy.b2};
        sculptor.dab(surface.dab(x, y), std::span(&point, 1));
    };
    dab_at(0.5, 0.25);
    dab_at(0.0, -0.5);  // on the plane: the copy lies on the hand
    sculptor.end();
    for (std::size_t k = 0; k < 3; ++k)
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_EQ(colours.plane(k).at(x, y), colours.plane(k).at(127 - x, y)) << x << ", " << y;
    EXPECT_NEAR(colours.plane(0).at(64, 32), 32768, 600) << "half of the way, not three quarters";
}

TEST(PaintSeam, both_sides_of_an_aligned_seam_hold_the_same_colours_after_every_dab) {
    for (const int bits : {8, 16}) {
        HeightMap map(128, 96);
        ColourMap colours(128, 96, bits, kGround);
        const std::vector<Chart> charts{{{0, 0}, {0.5, 1}, {2, 0}, {96, 0}, {0, 96}},
                                        {{0.5, 0}, {1, 1}, {70, 0}, {96, 0}, {0, 96}}};
        ChartSurface surface(map, charts, 0.2f);
        for (int y = 0; y < 96; ++y)
            for (const auto& [gutter, source] : {std::pair{50, 70}, {69, 49}})
                surface.table.copies.push_back({static_cast<std::uint32_t>(map.index(gutter, y)),
                                                static_cast<std::uint32_t>(map.index(source, y))});
        Sculptor sculptor(map, surface);
        sculptor.set_colours(colours);
        sculptor.begin(brush_of(Paint::both, 0.3f));
        for (int i = 0; i < 12; ++i) {
            sculptor.dab(surface.dab(0.4 + 0.02 * i, 0.5));
            for (std::size_t k = 0; k < 3; ++k)
                ASSERT_EQ(ChartSurface(colours.plane(k), charts, 0.2f).gap(0, 1, {0.5, 0.1}, {0.5, 0.9}),
                          0.0);
        }
        sculptor.end();
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(ChartSurface(colours.plane(k), charts, 0.2f).gap(0, 1, {0.5, 0.1}, {0.5, 0.9}), 0.0);
    }
}

TEST(PaintSeam, slanted_seam_is_settled_to_a_part_of_the_stroke) {
    const std::vector<Chart> charts{{{0, 0}, {0.5, 1}, {3, 3}, {90, 0}, {0, 90}},
                                    {{0.5, 0}, {1, 1}, {66, 20}, {60, 22}, {-22, 60}}};
    HeightMap map(128, 112);
    ColourMap colours(128, 112, 16, kGround);
    ChartSurface surface(map, charts, 0.2f);
    surface.add_equations(0, 1, {0.5, 0.0}, {0.5, 1.0});
    Sculptor sculptor(map, surface);
    sculptor.set_colours(colours);
    stroke(sculptor, surface, brush_of(Paint::both, 0.6f), {0.3, 0.5}, {0.7, 0.55});
    for (std::size_t k = 0; k < 3; ++k) {
        const double change = std::abs(1.0 * colours.plane(k).at(3 + 44, 3 + 46) - kGround[k]);
        EXPECT_GT(change, 2000);
        EXPECT_LT(ChartSurface(colours.plane(k), charts, 0.2f).gap(0, 1, {0.5, 0.1}, {0.5, 0.9}),
                  0.02 * change)
            << k;
    }
}

TEST(PaintMisuse, is_refused_in_words_and_changes_nothing) {
    HeightMap map(32, 32);
    ChartSurface surface(map, {unit_chart(map)}, 0.2f);
    Sculptor sculptor(map, surface);
    const auto refusal = [](const auto& act) {
        try {
            act();
        } catch (const std::invalid_argument& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal([&] { sculptor.begin(brush_of(Paint::both)); }),
              "painting needs a colour map: make one first");
    EXPECT_FALSE(sculptor.in_stroke());
    ColourMap other(32, 16, 8), right(32, 32, 8);
    EXPECT_EQ(refusal([&] { sculptor.set_colours(other); }),
              "the colour map has 32 x 16 texels, the displacement map 32 x 32: to be painted, it must have "
              "as many");
    sculptor.set_colours(right);
    EXPECT_THROW(sculptor.set_colours(right), std::logic_error);
    Brush brush = brush_of(Paint::colour);
    brush.green = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal([&] { sculptor.begin(brush); }).find("green"), std::string::npos);
    brush = brush_of(Paint{7});
    EXPECT_EQ(refusal([&] { sculptor.begin(brush); }), "brush paint: no such choice");
    EXPECT_EQ(refusal([] { ColourMap(1, 1, 12); }), "a colour map of 12 bits: it must be 8 or 16");
    EXPECT_THROW(ColourMap(0, 4, 8), std::invalid_argument);
}

TEST(Paint, stamp_paints_through_its_image) {
    // White on the image's right half, black on its left.
    std::vector<float> values;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) values.push_back(x < 32 ? 0.0f : 0.5f);
    const auto halves = std::make_shared<const Alpha>("halves", 64, 64, std::move(values));
    for (const bool accumulate : {false, true}) {
        Plane plane;
        Brush brush = brush_of(Paint::colour, 1.0f, Tool::stamp);
        brush.falloff = Falloff::constant;
        brush.accumulate = accumulate;
        plane.sculptor.begin(brush, halves);
        plane.sculptor.dab(plane.surface.dab(0.5, 0.5));
        plane.sculptor.dab(plane.surface.dab(0.5, 0.5));
        plane.sculptor.end();
        const double part = accumulate ? 0.75 : 0.5;  // two presses: half of the way, and half of what is left
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(plane.colours.plane(k).at(72, 64),
                        kGround[k] + (target_of(brush, k) - kGround[k]) * part, 1.0);
            EXPECT_EQ(plane.colours.plane(k).at(56, 64), kGround[k]);
        }
        EXPECT_EQ(plane.map.at(72, 64), HeightMap(1, 1).at(0, 0));
    }
}

}  // namespace
}  // namespace relievo::paint_test
