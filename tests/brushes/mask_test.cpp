// The mask: what it protects, its commands, and that it is undone like strokes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "brushes/mask_blur.h"
#include "brushes/seams.h"
#include "chart_surface.h"

namespace relievo::mask_test {
namespace {

struct Plane {
    explicit Plane(int size = 128, float amplitude = 0.2f)
        : map(size, size), surface(map, {unit_chart(map)}, amplitude), sculptor(map, surface) {
        fill(map, [](int x, int y) { return 30000 + 311 * ((x * 7 + y * 13) % 17); });
    }
    HeightMap map;
    ChartSurface surface;
    Sculptor sculptor;
};

Brush masking_brush(Tool tool, float radius = 0.2f, float strength = 1.0f) {
    Brush brush;
    brush.tool = tool;
    brush.radius = radius;
    brush.strength = strength;
    brush.hardness = 0.5f;
    return brush;
}

void use(Plane& plane, Tool tool) {
    const Brush brush = masking_brush(tool, 0.3f);
    plane.sculptor.begin(brush, sloping_alpha());
    for (int i = 0; i <= 10; ++i) {
        const glm::dvec2 at(0.3 + (tool == Tool::grab ? 0 : 0.04 * i), 0.5);
        Dab dab = plane.surface.dab(at.x, at.y);
        dab.drag = {i * 5000, 1000, i * 4000};
        plane.sculptor.dab(dab, {}, sources_of(brush, plane.surface, at));
    }
    plane.sculptor.end();
}

TEST(Mask, protects_its_texels_from_every_tool_and_others_change) {
    for (const ToolInfo& info : tools()) {
        if (info.tool == Tool::mask) continue;
        Plane plane;
        tap(plane.sculptor, plane.surface, masking_brush(Tool::mask), {0.5, 0.5});
        const HeightMap before = plane.map;
        use(plane, info.tool);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < before.texels().size(); ++i) {
            const bool same = plane.map.texels()[i] == before.texels()[i];
            EXPECT_TRUE(same || plane.sculptor.mask()->texels()[i] < 65535) << info.name;
            changed += !same;
        }
        EXPECT_GT(changed, 100u) << info.name;
    }
}

TEST(Mask, over_everything_leaves_no_step_to_undo) {
    Plane plane;
    plane.sculptor.invert_mask();
    EXPECT_EQ(plane.sculptor.mask()->at(3, 3), 65535);
    const std::uint64_t hash = plane.map.hash(), steps = plane.sculptor.steps_made();
    for (const ToolInfo& info : tools())
        if (info.tool != Tool::mask) use(plane, info.tool);
    EXPECT_EQ(plane.map.hash(), hash);
    EXPECT_EQ(plane.sculptor.steps_made(), steps);
}

TEST(Mask, half_protection_halves_a_stroke) {
    Plane half, free;
    tap(half.sculptor, half.surface, masking_brush(Tool::mask, 0.4f, 0.5f), {0.5, 0.5});
    const int before = half.map.at(64, 64);
    for (Plane* plane : {&half, &free})
        tap(plane->sculptor, plane->surface, masking_brush(Tool::draw, 0.2f), {64.5 / 128, 64.5 / 128});
    EXPECT_NEAR(half.map.at(64, 64) - before, (free.map.at(64, 64) - before) / 2.0, 1);
}

// What mask_blur.h says, texel by texel.
HeightMap blurred_plainly(const HeightMap& mask, const Surface& surface, const Seams& seams) {
    HeightMap result = mask;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            std::uint32_t sum = 0, count = 0;
            for (const auto& [i, j] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
                if (i < 0 || j < 0 || i >= mask.width() || j >= mask.height()) continue;
                if (surface.owned(i, j) || seams.is_gutter(i, j)) sum += mask.at(i, j), ++count;
            }
            if (!surface.owned(x, y) || count == 0) continue;
            const std::uint32_t mean = (sum + count / 2) / count;
            result.set(x, y, static_cast<std::uint16_t>((mask.at(x, y) + mean + 1) / 2));
        }
    return result;
}

TEST(Mask, blur_of_any_size_is_the_plain_one) {
    std::mt19937 random(5);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 70}, {130, 1}, {64, 64}, {67, 129}, {200, 3}})
        for (const unsigned runs : {1u, 9u, 150u}) {  // mean lengths of equal texels
            HeightMap mask(width, height);
            std::uint16_t now = 0;
            for (std::uint16_t& texel : mask.texels()) {
                if (random() % runs == 0) now = static_cast<std::uint16_t>(random() % 5 * 16383);
                texel = now;
            }
            Chart chart = unit_chart(mask);
            if (width > 20) chart.high.x = 0.7;  // the rest shows nothing
            ChartSurface surface(mask, {chart}, 0.2f);
            if (width > 100) surface.table.copies.push_back({static_cast<std::uint32_t>(width) - 20, 3});
            const Seams seams(surface, width, height);
            const HeightMap wanted = blurred_plainly(mask, surface, seams);
            blur_once(mask, surface, seams, {});
            EXPECT_EQ(mask.hash(), wanted.hash()) << width << " x " << height << ", " << runs;
        }
}

TEST(Mask, a_stopped_blur_leaves_mask_and_undo_as_they_were) {
    Plane plane, whole;
    for (Plane* each : {&plane, &whole}) {
        tap(each->sculptor, each->surface, masking_brush(Tool::mask), {0.5, 0.5});
        tap(each->sculptor, each->surface, masking_brush(Tool::mask), {0.3, 0.3});
        each->sculptor.undo();
    }
    std::vector<double> parts;
    whole.sculptor.blur_mask([&](double part) {
        parts.push_back(part);
        return true;
    });
    ASSERT_GT(parts.size(), 4u);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_GE(parts.front(), 0.0);
    EXPECT_LT(parts.back(), 1.0);
    const std::uint64_t hash = plane.sculptor.mask()->hash(), revision = plane.sculptor.mask_revision();
    for (std::size_t last = 1; last <= parts.size(); ++last) {
        std::size_t asked = 0;
        EXPECT_THROW(plane.sculptor.blur_mask([&](double) { return ++asked < last; }), Stopped) << last;
        EXPECT_EQ(asked, last);
        EXPECT_EQ(plane.sculptor.mask()->hash(), hash) << last;
        EXPECT_EQ(plane.sculptor.mask_revision(), revision) << last;
    }
    EXPECT_TRUE(plane.sculptor.can_redo()) << "what was undone is still to come";
    plane.sculptor.blur_mask();
    EXPECT_EQ(plane.sculptor.mask()->hash(), whole.sculptor.mask()->hash());
    EXPECT_FALSE(plane.sculptor.can_redo());
    plane.sculptor.undo();
    EXPECT_EQ(plane.sculptor.mask()->hash(), hash);
}

// A mask of 16384 x 16384 texels, inverted, would not fit into the undo memory else.
TEST(Mask, where_it_is_even_a_step_takes_hardly_any_memory) {
    Plane plane(512);
    plane.sculptor.invert_mask();
    const std::uint64_t all = plane.sculptor.mask()->hash();
    constexpr std::size_t kTiles = 64, kTile = 8192;
    EXPECT_LT(plane.sculptor.undo_bytes(), kTiles * 64);
    tap(plane.sculptor, plane.surface, masking_brush(Tool::mask, 0.01f), {0.5, 0.5});  // protected already
    Brush freeing = masking_brush(Tool::mask, 0.01f);
    freeing.invert = true;
    tap(plane.sculptor, plane.surface, freeing, {0.3, 0.3});
    const std::uint64_t freed = plane.sculptor.mask()->hash();
    plane.sculptor.invert_mask();
    const std::uint64_t inverted = plane.sculptor.mask()->hash();
    const std::size_t bytes = plane.sculptor.undo_bytes();
    EXPECT_LT(bytes, 2 * kTiles * 64 + 3 * kTile);
    for (const std::uint64_t hash : {freed, all}) {
        plane.sculptor.undo();
        EXPECT_EQ(plane.sculptor.mask()->hash(), hash);
        EXPECT_EQ(plane.sculptor.undo_bytes(), bytes);
    }
    plane.sculptor.undo();
    EXPECT_TRUE(std::ranges::all_of(plane.sculptor.mask()->texels(), [](std::uint16_t t) { return t == 0; }));
    for (const std::uint64_t hash : {all, freed, inverted}) {
        plane.sculptor.redo();
        EXPECT_EQ(plane.sculptor.mask()->hash(), hash);
        EXPECT_EQ(plane.sculptor.undo_bytes(), bytes);
    }
}

TEST(Mask, strokes_and_commands_are_undone_in_turn_with_the_map) {
    Plane plane;
    const std::uint64_t bare = plane.map.hash();
    tap(plane.sculptor, plane.surface, masking_brush(Tool::mask), {0.4, 0.4});
    const std::uint64_t masked = plane.sculptor.mask()->hash();
    EXPECT_EQ(plane.map.hash(), bare);
    tap(plane.sculptor, plane.surface, masking_brush(Tool::draw), {0.5, 0.5});
    const std::uint64_t drawn = plane.map.hash();
    plane.sculptor.blur_mask();
    plane.sculptor.invert_mask();
    const std::uint64_t inverted = plane.sculptor.mask()->hash();
    plane.sculptor.clear_mask();
    EXPECT_TRUE(plane.sculptor.undo().empty()) << "no texel of the map changed";
    EXPECT_EQ(plane.sculptor.mask()->hash(), inverted);
    plane.sculptor.undo();
    plane.sculptor.undo();
    EXPECT_EQ(plane.sculptor.mask()->hash(), masked);
    EXPECT_EQ(plane.map.hash(), drawn);
    EXPECT_FALSE(plane.sculptor.undo().empty());
    EXPECT_EQ(plane.map.hash(), bare);
    plane.sculptor.undo();
    EXPECT_EQ(plane.sculptor.mask()->at(51, 51), 0);
    EXPECT_FALSE(plane.sculptor.can_undo());
    while (plane.sculptor.can_redo()) plane.sculptor.redo();
    EXPECT_EQ(plane.map.hash(), drawn);
    EXPECT_EQ(plane.sculptor.mask()->at(51, 51), 0) << "cleared";
    tap(plane.sculptor, plane.surface, masking_brush(Tool::mask), {0.4, 0.4});
    const std::uint64_t again = plane.sculptor.mask()->hash();
    plane.sculptor.begin(masking_brush(Tool::mask));
    plane.sculptor.dab(plane.surface.dab(0.8, 0.8));
    EXPECT_NE(plane.sculptor.mask()->hash(), again);
    plane.sculptor.cancel();
    EXPECT_EQ(plane.sculptor.mask()->hash(), again);
}

TEST(Mask, inverted_stroke_frees_again) {
    Plane plane;
    Brush brush = masking_brush(Tool::mask);
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    brush.invert = true;
    brush.radius = 0.4f;
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    EXPECT_EQ(plane.sculptor.mask()->at(64, 64), 0);
}

TEST(Mask, amplitude_0_can_be_masked) {
    Plane plane(32, 0.0f);
    tap(plane.sculptor, plane.surface, masking_brush(Tool::mask), {0.5, 0.5});
    EXPECT_EQ(plane.sculptor.mask()->at(16, 16), 65535);
}

TEST(Mask, blur_of_the_brush_softens_the_border_under_it_alone_and_is_one_step) {
    Plane plane;
    const std::uint64_t heights = plane.map.hash();
    Brush brush = masking_brush(Tool::mask, 0.25f);
    brush.falloff = Falloff::constant;
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    const HeightMap hard = *plane.sculptor.mask();
    const int left = 32, right = 95;  // the last texels inside
    ASSERT_EQ(hard.at(left, 64), 65535);
    ASSERT_EQ(hard.at(left - 1, 64), 0);

    brush.blur = true;
    brush.radius = 0.15f;
    for (int i = 0; i < 3; ++i) tap(plane.sculptor, plane.surface, brush, {0.25, 0.5});
    const HeightMap& mask = *plane.sculptor.mask();
    EXPECT_EQ(plane.map.hash(), heights);
    EXPECT_LT(mask.at(left, 64), 60000);
    EXPECT_GT(mask.at(left - 1, 64), 5000);
    for (int x = 20; x < 44; ++x) EXPECT_LE(mask.at(x, 64), mask.at(x + 1, 64)) << x;
    for (int x = 64; x < 128; ++x) EXPECT_EQ(mask.at(x, 64), hard.at(x, 64)) << x;
    EXPECT_EQ(mask.at(right, 64), 65535);

    for (int i = 0; i < 3; ++i) plane.sculptor.undo();
    EXPECT_EQ(plane.sculptor.mask()->hash(), hard.hash());
    const std::uint64_t steps = plane.sculptor.steps_made();
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    EXPECT_EQ(plane.sculptor.steps_made(), steps) << "there is nothing to even out within";
}

TEST(Mask, blur_softens_the_border_and_keeps_the_middle_over_a_cut) {
    HeightMap map(128, 96);
    ChartSurface surface(
        map, {{{0, 0}, {0.5, 1}, {2, 0}, {96, 0}, {0, 96}}, {{0.5, 0}, {1, 1}, {70, 0}, {96, 0}, {0, 96}}},
        0.2f);
    for (int y = 0; y < 96; ++y)
        for (const auto& [gutter, source] : {std::pair{50, 70}, {69, 49}})
            surface.table.copies.push_back({static_cast<std::uint32_t>(map.index(gutter, y)),
                                            static_cast<std::uint32_t>(map.index(source, y))});
    Sculptor sculptor(map, surface);
    Brush brush = masking_brush(Tool::mask, 0.1f);
    brush.falloff = Falloff::constant;
    tap(sculptor, surface, brush, {0.42, 0.5});  // its border lies in the right island
    const auto blurred_across_the_cut = [&] {
        const int at_border = sculptor.mask()->at(70 + 1, 48), outside = sculptor.mask()->at(70 + 4, 48);
        EXPECT_GT(at_border, 10000);
        EXPECT_LT(at_border, 60000);
        EXPECT_GT(outside, 0);
        EXPECT_EQ(sculptor.mask()->at(50, 48), sculptor.mask()->at(70, 48)) << "the gutter";
    };
    sculptor.blur_mask();
    EXPECT_EQ(sculptor.mask()->at(2 + 40, 48), 65535);
    blurred_across_the_cut();
    sculptor.undo();
    brush.blur = true;  // the brush's own, about the border
    tap(sculptor, surface, brush, {0.52, 0.5});
    blurred_across_the_cut();
}

}  // namespace
}  // namespace relievo::mask_test
