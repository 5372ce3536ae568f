// Height bounds and the triangle lookup against brute force over texels and points.
#include "renderer/scene/triangle_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "tests/support/scenes.h"

namespace relievo::triangle_bounds_test {
namespace {

struct Map {
    int width, height;
    std::vector<std::uint16_t> texels;
    Map(int w, int h, unsigned seed = 1) : width(w), height(h) {
        std::mt19937 random(seed);
        texels.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
        for (auto& t : texels) t = static_cast<std::uint16_t>(random());
    }
    std::uint16_t at(int x, int y) const { return texels[static_cast<std::size_t>(y * width + x)]; }
};

using test::wrapped;

using Triangle = std::array<glm::vec2, 3>;

// Texels that the four taps of bilinear filtering reach with a weight above 1e-9 from points all over the
// triangle.
std::set<std::pair<int, int>> touched_texels(const Triangle& uv, const Map& map, Wrap wrap, int steps) {
    std::set<std::pair<int, int>> found;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const double b1 = static_cast<double>(i) / steps, b2 = static_cast<double>(j) / steps;
            const glm::dvec2 p =
                glm::dvec2(uv[0]) * (1 - b1 - b2) + glm::dvec2(uv[1]) * b1 + glm::dvec2(uv[2]) * b2;
            const double tx = p.x * map.width - 0.5, ty = p.y * map.height - 0.5;
            const int x = static_cast<int>(std::floor(tx)), y = static_cast<int>(std::floor(ty));
            for (int dy = 0; dy < 2; ++dy) {
                for (int dx = 0; dx < 2; ++dx) {
                    const double weight = std::abs(1 - dx - (tx - x)) * std::abs(1 - dy - (ty - y));
                    if (weight < 1e-9) continue;
                    found.insert({wrapped(x + dx, map.width, wrap), wrapped(y + dy, map.height, wrap)});
                }
            }
        }
    }
    return found;
}

// Texels whose square of side 2 * reach meets the triangle (separating axes), wrapped: the footprint's
// definition.
std::set<std::pair<int, int>> near_texels(const Triangle& uv, const Map& map, Wrap wrap, double reach) {
    glm::dvec2 t[3], low(1e30), high(-1e30);
    for (int k = 0; k < 3; ++k) {
        t[k] = glm::dvec2(uv[static_cast<std::size_t>(k)]) * glm::dvec2(map.width, map.height) - 0.5;
        for (int c = 0; c < 2; ++c) low[c] = std::min(low[c], t[k][c]), high[c] = std::max(high[c], t[k][c]);
    }
    const auto separated = [&](double x, double y) {
        for (int k = 0; k < 3; ++k) {
            const glm::dvec2 edge = t[(k + 1) % 3] - t[k], normal(-edge.y, edge.x);
            double least = 1e300, most = -1e300;
            for (const glm::dvec2& v : t) {
                const double d = normal.x * (v.x - x) + normal.y * (v.y - y);
                least = std::min(least, d), most = std::max(most, d);
            }
            const double r = reach * (std::abs(normal.x) + std::abs(normal.y));
            if (least > r || most < -r) return true;
        }
        return false;
    };
    std::set<std::pair<int, int>> found;
    for (int y = static_cast<int>(std::floor(low.y - reach)); y <= high.y + reach; ++y) {
        for (int x = static_cast<int>(std::floor(low.x - reach)); x <= high.x + reach; ++x) {
            const bool inside =
                x >= low.x - reach && x <= high.x + reach && y >= low.y - reach && y <= high.y + reach;
            if (inside && !separated(x, y))
                found.insert({wrapped(x, map.width, wrap), wrapped(y, map.height, wrap)});
        }
    }
    return found;
}

HeightRange range_of(const std::set<std::pair<int, int>>& texels, const Map& map) {
    HeightRange range;
    for (const auto& [x, y] : texels) {
        range.low = std::min(range.low, map.at(x, y));
        range.high = std::max(range.high, map.at(x, y));
    }
    return range;
}

Mesh mesh_of(const std::vector<Triangle>& triangles) {
    Mesh mesh;
    for (const Triangle& t : triangles) {
        const auto n = static_cast<std::uint32_t>(mesh.uvs.size());
        mesh.uvs.insert(mesh.uvs.end(), t.begin(), t.end());
        mesh.faces.push_back({{0, 0, 0}, {n, n + 1, n + 2}});
    }
    return mesh;
}

void expect_conservative_and_tight(const Triangle& uv, const Map& map, const HeightBounds& bounds,
                                   Wrap wrap) {
    const HeightRange got = bounds.range(uv[0], uv[1], uv[2]);
    const HeightRange least = range_of(touched_texels(uv, map, wrap, 48), map);
    const HeightRange most = range_of(near_texels(uv, map, wrap, 1.05), map);
    EXPECT_LE(got.low, least.low);
    EXPECT_GE(got.high, least.high);
    EXPECT_GE(got.low, most.low);
    EXPECT_LE(got.high, most.high);
}

Triangle random_triangle(std::mt19937& random, double centre_low, double centre_high, double size) {
    std::uniform_real_distribution<double> centre(centre_low, centre_high), offset(-size, size);
    const glm::dvec2 c(centre(random), centre(random));
    Triangle t;
    for (glm::vec2& uv : t) uv = glm::vec2(c + glm::dvec2(offset(random), offset(random)));
    return t;
}

class MapSizes : public testing::TestWithParam<std::tuple<std::pair<int, int>, Wrap>> {};

TEST_P(MapSizes, random_triangles_are_bounded_and_tight) {
    const auto [size, wrap] = GetParam();
    const Map map(size.first, size.second);
    const HeightBounds bounds(map.width, map.height, map.texels.data(), wrap);
    std::mt19937 random(7);
    for (int i = 0; i < 120; ++i) {
        const double scale = i % 3 == 0 ? 0.02 : i % 3 == 1 ? 0.15 : 0.6;
        SCOPED_TRACE(i);
        expect_conservative_and_tight(random_triangle(random, -0.4, 1.4, scale), map, bounds, wrap);
    }
}

TEST_P(MapSizes, degenerate_mirrored_and_far_uvs) {
    const auto [size, wrap] = GetParam();
    const Map map(size.first, size.second);
    const HeightBounds bounds(map.width, map.height, map.texels.data(), wrap);
    const Triangle cases[] = {
        {{{0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}}},       // a point
        {{{0.1f, 0.1f}, {0.9f, 0.7f}, {0.5f, 0.4f}}},       // a line
        {{{0.2f, 0.5f}, {0.8f, 0.5f}, {0.4f, 0.5f}}},       // a line along a row
        {{{0.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 0.0f}}},       // mirrored
        {{{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}}},       // half the map, along its borders
        {{{-0.5f, -0.5f}, {1.5f, -0.5f}, {0.5f, 1.5f}}},    // over the borders
        {{{7.25f, -3.5f}, {7.5f, -3.5f}, {7.25f, -3.1f}}},  // far outside
        {{{-2.2f, 0.2f}, {-1.8f, 1.4f}, {-2.0f, 0.9f}}},
    };
    for (const Triangle& uv : cases) expect_conservative_and_tight(uv, map, bounds, wrap);
}

INSTANTIATE_TEST_SUITE_P(, MapSizes,
                         testing::Combine(testing::Values(std::pair{1, 1}, std::pair{1, 37}, std::pair{53, 1},
                                                          std::pair{2, 2}, std::pair{64, 64},
                                                          std::pair{100, 33}, std::pair{129, 257}),
                                          testing::Values(Wrap::repeat, Wrap::clamp)));

TEST(HeightBounds, many_periods_give_the_whole_map) {
    const Map map(40, 24);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const HeightBounds bounds(map.width, map.height, map.texels.data(), wrap);
        for (const float s : {9.0f, 1e4f, 1e12f, 3e38f}) {
            const HeightRange range = bounds.range({-s, -s}, {s, -s}, {0, s});
            EXPECT_EQ(range.low, *std::min_element(map.texels.begin(), map.texels.end()));
            EXPECT_EQ(range.high, *std::max_element(map.texels.begin(), map.texels.end()));
        }
    }
}

TEST(TriangleLookup, face_over_many_periods_is_touched_by_every_texel) {
    const std::vector<Triangle> triangles = {{{{-40, -40}, {40, -40}, {0, 40}}},
                                             {{{0, 0}, {0.1f, 0}, {0, 0.1f}}}};
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const TriangleLookup lookup(mesh_of(triangles), 64, 32, wrap);
        std::vector<std::uint32_t> faces;
        lookup.find({60, 20, 61, 21}, faces);
        EXPECT_EQ(faces, std::vector<std::uint32_t>{0});
        lookup.find({1, 1, 2, 2}, faces);
        EXPECT_EQ(faces, (std::vector<std::uint32_t>{0, 1}));
    }
}

TEST(HeightBounds, update_after_an_edit_equals_a_new_build) {
    Map map(301, 190);
    HeightBounds live(map.width, map.height, map.texels.data(), Wrap::repeat);
    std::mt19937 random(3);
    for (int edit = 0; edit < 30; ++edit) {
        const int x0 = static_cast<int>(random() % 301), y0 = static_cast<int>(random() % 190);
        const TexelBox rect{x0 - 5, y0 - 5, x0 + static_cast<int>(random() % 90),
                            y0 + static_cast<int>(random() % 90)};
        const std::uint16_t value = static_cast<std::uint16_t>(random() % 3 * 32767);
        for (int y = std::max(rect.y0, 0); y < std::min(rect.y1, map.height); ++y) {
            for (int x = std::max(rect.x0, 0); x < std::min(rect.x1, map.width); ++x) {
                map.texels[static_cast<std::size_t>(y * map.width + x)] = value;
            }
        }
        live.update(rect);
        const HeightBounds fresh(map.width, map.height, map.texels.data(), Wrap::repeat);
        for (int i = 0; i < 20; ++i) {
            const Triangle t = random_triangle(random, 0, 1, 0.1);
            const HeightRange a = live.range(t[0], t[1], t[2]), b = fresh.range(t[0], t[1], t[2]);
            EXPECT_EQ(a.low, b.low);
            EXPECT_EQ(a.high, b.high);
        }
    }
}

TEST(HeightBounds, rectangle_outside_the_map_changes_nothing) {
    const Map map(8, 8);
    HeightBounds bounds(8, 8, map.texels.data(), Wrap::clamp);
    bounds.update({-20, -20, 0, 0});
    bounds.update({8, 0, 20, 8});
    bounds.update({3, 3, 3, 3});
    EXPECT_EQ(bounds.whole().high, *std::max_element(map.texels.begin(), map.texels.end()));
}

TEST(HeightBounds, single_texel_spike_is_seen_by_every_triangle_that_filters_it) {
    Map map(64, 64);
    std::fill(map.texels.begin(), map.texels.end(), std::uint16_t{100});
    map.texels[20 * 64 + 10] = 60000;
    const HeightBounds bounds(64, 64, map.texels.data(), Wrap::repeat);
    // The spike's texel stands at (10.5, 20.5) / 64 and reaches one texel around it.
    const auto near = [&](float x, float y) {
        return bounds.range({x / 64, y / 64}, {x / 64, (y + 0.1f) / 64}, {(x + 0.1f) / 64, y / 64}).high ==
               60000;
    };
    EXPECT_TRUE(near(9.6f, 19.6f));
    EXPECT_TRUE(near(11.3f, 21.3f));
    EXPECT_FALSE(near(9.3f, 20.5f));
    EXPECT_FALSE(near(11.6f, 20.5f));
}

TEST_P(MapSizes, lookup_finds_every_face_that_a_texel_touches) {
    const auto [size, wrap] = GetParam();
    const Map map(size.first, size.second);
    std::mt19937 random(11);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 150; ++i)
        triangles.push_back(random_triangle(random, -0.4, 1.4, i % 5 == 0 ? 0.5 : 0.05));
    const TriangleLookup lookup(mesh_of(triangles), map.width, map.height, wrap);
    std::vector<std::set<std::pair<int, int>>> least, most;
    for (const Triangle& t : triangles) {
        least.push_back(touched_texels(t, map, wrap, 24));
        most.push_back(near_texels(t, map, wrap, 1.05));
    }
    std::vector<std::uint32_t> faces;
    for (int i = 0; i < 20; ++i) {
        const int x0 = static_cast<int>(random() % static_cast<unsigned>(map.width));
        const int y0 = static_cast<int>(random() % static_cast<unsigned>(map.height));
        const TexelBox rect{x0, y0, x0 + 1 + i, y0 + 1 + i};
        lookup.find(rect, faces);
        EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
        const auto meets = [&](const std::set<std::pair<int, int>>& texels) {
            return std::any_of(texels.begin(), texels.end(), [&](const std::pair<int, int>& t) {
                return t.first >= rect.x0 && t.first < rect.x1 && t.second >= rect.y0 && t.second < rect.y1;
            });
        };
        for (std::uint32_t face = 0; face < triangles.size(); ++face) {
            const bool found = std::binary_search(faces.begin(), faces.end(), face);
            EXPECT_TRUE(found || !meets(least[face])) << "face " << face << " is missing";
            EXPECT_TRUE(!found || i > 0 || meets(most[face])) << "face " << face << " is too many";
        }
    }
    lookup.find({map.width, 0, map.width + 9, 9}, faces);
    EXPECT_TRUE(faces.empty());
}

}  // namespace
}  // namespace relievo::triangle_bounds_test
