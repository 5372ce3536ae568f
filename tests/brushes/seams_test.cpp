// Seams: strokes over them leave both sides at one height under bilinear filtering.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "relief_plane.h"

namespace relievo::seams_test {
namespace {

// The unit square cut at x = 0.5 into two islands, 96 texels a unit, both sides along texel columns. Gutters
// hold copies along the seam; the other borders are extended by one texel.
struct AlignedIslands {
    static constexpr int kLeftX = 2, kRightX = 70, kY = 8, kHalf = 48, kRows = 96;

    AlignedIslands()
        : map(128, 112),
          surface(map,
                  {{{0, 0}, {0.5, 1}, {kLeftX, kY}, {96, 0}, {0, 96}},
                   {{0.5, 0}, {1, 1}, {kRightX, kY}, {96, 0}, {0, 96}}},
                  kAmplitude) {
        for (int y = kY; y < kY + kRows; ++y) {
            copy(kLeftX + kHalf, y, kRightX, y);  // beyond the left island: the right one's first column
            copy(kRightX - 1, y, kLeftX + kHalf - 1, y);  // and the other way round
        }
        for (int x = -1; x <= kHalf; ++x)
            for (const int left : {kLeftX, kRightX}) {
                const int inside = std::clamp(x, 0, kHalf - 1);
                copy(left + x, kY - 1, source_column(left, inside, x), kY);
                copy(left + x, kY + kRows, source_column(left, inside, x), kY + kRows - 1);
            }
    }
    // Above and below the corner at the seam, the gutter continues the other island.
    static int source_column(int left, int inside, int x) {
        if (left == kLeftX && x == kHalf) return kRightX;
        if (left == kRightX && x == -1) return kLeftX + kHalf - 1;
        return left + inside;
    }
    void copy(int gutter_x, int gutter_y, int x, int y) {
        surface.table.copies.push_back({static_cast<std::uint32_t>(map.index(gutter_x, gutter_y)),
                                        static_cast<std::uint32_t>(map.index(x, y))});
    }
    double gap() const { return surface.gap(0, 1, {0.5, 0}, {0.5, 1}); }

    HeightMap map;
    ChartSurface surface;
};

TEST(AlignedSeam, every_tool_leaves_a_gap_of_zero_counts_after_every_dab) {
    AlignedIslands islands;
    Sculptor sculptor(islands.map, islands.surface);
    for (const ToolInfo& info : tools()) {
        const Brush brush = brush_of(info.tool, 0.15f, 0.8f);
        sculptor.begin(brush, sloping_alpha());
        for (int i = 0; i <= 30; ++i) {
            const glm::dvec2 at(0.3 + 0.4 * (i / 30.0), 0.02 + 0.96 * (i / 30.0));
            sculptor.dab(islands.surface.dab(at.x, at.y), {}, sources_of(brush, islands.surface, at));
            ASSERT_EQ(islands.gap(), 0.0) << info.name << ", dab " << i;
        }
        sculptor.end();
        EXPECT_EQ(islands.gap(), 0.0) << info.name;
    }
    while (sculptor.can_undo()) {
        sculptor.undo();
        EXPECT_EQ(islands.gap(), 0.0);
    }
}

TEST(AlignedSeam, erasing_to_what_was_saved_gives_its_gutters_back_too) {
    AlignedIslands islands;
    Sculptor sculptor(islands.map, islands.surface);
    stroke(sculptor, islands.surface, brush_of(Tool::draw, 0.15f, 0.8f), {0.3, 0.3}, {0.7, 0.6});
    sculptor.mark_saved();
    const std::uint64_t saved = islands.map.hash();
    stroke(sculptor, islands.surface, brush_of(Tool::draw, 0.1f, 0.8f), {0.3, 0.6}, {0.7, 0.3});
    Brush erase = brush_of(Tool::erase, 0.15f, 0.7f);
    erase.erase_to = EraseTo::saved;
    sculptor.begin(erase);
    for (int i = 0; i <= 20; ++i) {
        sculptor.dab(islands.surface.dab(0.4 + 0.01 * i, 0.5));
        ASSERT_EQ(islands.gap(), 0.0) << "dab " << i;
    }
    sculptor.end();
    erase = brush_of(Tool::erase, 3, 1.0f);
    erase.erase_to = EraseTo::saved;
    erase.falloff = Falloff::constant;
    tap(sculptor, islands.surface, erase, {0.5, 0.5});
    EXPECT_EQ(islands.map.hash(), saved);
}

TEST(AlignedSeam, height_does_not_depend_on_the_cut) {
    AlignedIslands cut;
    HeightMap whole_map(96, 96);
    const ChartSurface whole(whole_map, {unit_chart(whole_map)}, kAmplitude);
    Sculptor on_cut(cut.map, cut.surface), on_whole(whole_map, whole);
    for (const Tool tool : {Tool::draw, Tool::smooth, Tool::flatten, Tool::level}) {
        const Brush brush = brush_of(tool, 0.15f, 0.8f);
        stroke(on_cut, cut.surface, brush, {0.3, 0.3}, {0.7, 0.6});
        stroke(on_whole, whole, brush, {0.3, 0.3}, {0.7, 0.6});
    }
    int largest = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const int cut_x = x < 48 ? AlignedIslands::kLeftX + x : AlignedIslands::kRightX + x - 48;
            largest =
                std::max(largest, std::abs(whole_map.at(x, y) - cut.map.at(cut_x, AlignedIslands::kY + y)));
        }
    EXPECT_LE(largest, 20) << "counts, after strokes of thousands (barycentrics are quantised per face)";
}

TEST(AlignedSeam, far_islands_are_reported_as_separate_rects) {
    AlignedIslands islands;
    Sculptor sculptor(islands.map, islands.surface);
    sculptor.begin(brush_of(Tool::draw, 0.05f, 1.0f));
    const HeightMap before = islands.map;
    const auto rects = sculptor.dab(islands.surface.dab(0.5, 0.5));
    std::int64_t area = 0;
    for (const TexelRect& rect : rects) area += rect.area();
    EXPECT_LT(area, 600);
    EXPECT_GE(rects.size(), 1u);
    sculptor.end();
}

// The same cut, the right island turned and scaled.
struct SlantedIslands {
    SlantedIslands(double degrees, double scale, int size = 512)
        : map(size, size), surface(map, charts(degrees, scale, size), kAmplitude) {
        surface.add_equations(0, 1, {0.5, 0}, {0.5, 1});
    }
    static std::vector<Chart> charts(double degrees, double scale, int size) {
        const double unit = 0.4 * size, angle = degrees * 3.14159265358979 / 180;
        const glm::dvec2 along(std::cos(angle) * scale * unit, std::sin(angle) * scale * unit);
        return {{{0, 0}, {0.5, 1}, {5.3, 7.7}, {unit, 0}, {0, unit}},
                {{0.5, 0}, {1, 1}, {0.72 * size, 0.12 * size}, along, {-along.y, along.x}}};
    }
    double gap() const { return surface.gap(0, 1, {0.5, 0}, {0.5, 1}); }
    // The stroke's height beside the seam.
    double height() const {
        double largest = 0;
        for (double y = 0; y <= 1; y += 0.005)
            largest = std::max(largest, std::abs(surface.counts(0, {0.49, y}) - 32768));
        return largest;
    }
    // Counts by which a texel of either island differs at most.
    double farthest_from(const HeightMap& other) const {
        double worst = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x)
                if (surface.owned(x, y))
                    worst = std::max(worst, std::abs(map.at(x, y) - 1.0 * other.at(x, y)));
        return worst;
    }

    HeightMap map;
    ChartSurface surface;
};

TEST(SlantedSeam, gap_is_at_most_two_percent_of_the_stroke) {
    double worst = 0;
    for (const double degrees : {0.0, 7.0, 30.0, 45.0, 90.0})
        for (const double scale : {0.6, 0.83, 1.0})
            for (const double radius_texels : {2.0, 6.0, 25.0}) {
                SlantedIslands islands(degrees, scale);
                Sculptor sculptor(islands.map, islands.surface);
                const auto radius = static_cast<float>(radius_texels / (0.4 * 512));
                stroke(sculptor, islands.surface, brush_of(Tool::draw, radius, 0.8f), {0.3, 0.4}, {0.7, 0.6});
                EXPECT_LE(islands.gap(), 0.02 * islands.height())
                    << "across: " << degrees << " degrees, scale " << scale << ", radius " << radius_texels;
                worst = std::max(worst, islands.gap() / islands.height());
                stroke(sculptor, islands.surface, brush_of(Tool::draw, radius, 0.5f), {0.5, 0.2}, {0.5, 0.8});
                EXPECT_LE(islands.gap(), 0.02 * islands.height())
                    << "along: " << degrees << " degrees, scale " << scale << ", radius " << radius_texels;
                worst = std::max(worst, islands.gap() / islands.height());
            }
    RecordProperty("worst_gap_percent", std::to_string(100 * worst));
}

TEST(SlantedSeam, solving_leaves_no_groove_along_the_seam) {
    SlantedIslands islands(30.0, 0.83);
    Sculptor sculptor(islands.map, islands.surface);
    Brush brush = brush_of(Tool::level, 0.2f, 1.0f);
    brush.level = 0.9f;
    brush.hardness = 0.8f;
    stroke(sculptor, islands.surface, brush, {0.5, 0.4}, {0.5, 0.6});
    for (double y = 0.4; y < 0.6; y += 0.001)
        for (const std::size_t chart : {0u, 1u})
            ASSERT_NEAR(islands.surface.counts(chart, {0.5, y}), 0.9 * 65535, 2.0) << "at " << y;
}

TEST(SlantedSeam, strokes_elsewhere_leave_it_alone_and_undo_restores_it) {
    SlantedIslands islands(30.0, 0.83);
    Sculptor sculptor(islands.map, islands.surface);
    const std::uint64_t start = islands.map.hash();
    const Brush brush = brush_of(Tool::draw, 0.05f, 1.0f);
    stroke(sculptor, islands.surface, brush, {0.1, 0.3}, {0.3, 0.6});
    EXPECT_NEAR(islands.gap(), 0.0, 1e-6);
    stroke(sculptor, islands.surface, brush, {0.4, 0.3}, {0.6, 0.6});
    sculptor.undo();
    sculptor.undo();
    EXPECT_EQ(islands.map.hash(), start);
}

TEST(SlantedSeam, erasing_to_what_was_saved_keeps_it_closed) {
    SlantedIslands islands(30.0, 0.83);
    Sculptor sculptor(islands.map, islands.surface);
    stroke(sculptor, islands.surface, brush_of(Tool::draw, 0.12f, 0.8f), {0.3, 0.5}, {0.7, 0.5});
    sculptor.mark_saved();
    const HeightMap saved = islands.map;
    const double height = islands.height();
    stroke(sculptor, islands.surface, brush_of(Tool::draw, 0.12f, 1.0f), {0.3, 0.4}, {0.7, 0.6});
    Brush erase = brush_of(Tool::erase, 0.2f, 1.0f);
    erase.erase_to = EraseTo::saved;
    stroke(sculptor, islands.surface, erase, {0.5, 0.2}, {0.5, 0.8});
    EXPECT_LE(islands.gap(), 0.02 * height);
    erase.falloff = Falloff::constant;
    erase.radius = 3;
    tap(sculptor, islands.surface, erase, {0.5, 0.5});
    EXPECT_LE(islands.gap(), 0.02 * height);
    EXPECT_LT(islands.farthest_from(saved), 0.02 * height) << "what closing the seam takes";
}

TEST(SlantedSeam, repeated_strokes_do_not_wear_the_border) {
    SlantedIslands islands(30.0, 0.83);
    Sculptor sculptor(islands.map, islands.surface);
    stroke(sculptor, islands.surface, brush_of(Tool::draw, 0.12f, 0.8f), {0.3, 0.5}, {0.7, 0.5});
    const HeightMap before = islands.map;
    for (int i = 0; i < 20; ++i)
        stroke(sculptor, islands.surface, brush_of(Tool::draw, 0.12f, 1e-3f), {0.3, 0.5}, {0.7, 0.5});
    const double height = islands.height();
    EXPECT_LE(islands.gap(), 0.02 * height);
    EXPECT_LT(islands.farthest_from(before), 0.06 * height)
        << "20 strokes of a thousandth add 2.5% themselves";
}

TEST(Seams, texel_outside_the_map_is_refused) {
    HeightMap map(8, 8);
    ChartSurface surface(map, {unit_chart(map)}, 1.0f);
    surface.table.copies.push_back({64, 0});
    EXPECT_THROW(Sculptor(map, surface), std::invalid_argument);
    surface.table.copies.clear();
    surface.table.equations.push_back({{0, 1, 2, 3, 4, 5, 6, 64}, {}});
    EXPECT_THROW(Sculptor(map, surface), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::seams_test
