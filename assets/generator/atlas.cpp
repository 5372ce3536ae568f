// Gutters by crossing seams: a texel centre outside an island is carried over the mesh edge it faces into the
// neighbour's texture coordinates. Both lie on the lattice, so it arrives exactly at a texel centre there and
// the two texels get the same value to the bit.
#include "assets/generator/atlas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

std::uint64_t edge_key(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t{from} << 32 | to;
}

int cells_along(const Island& island, int side) {
    return side % 2 == 0 ? island.columns : island.rows;
}
int cell_along(const Island& island, int side) {
    return side % 2 == 0 ? island.cell_w : island.cell_h;
}

// A point from its distance `along` a side, counter-clockwise, and its `depth` inside it.
glm::dvec2 from_side(const Island& island, int side, double along, double depth) {
    const double w = island.width(), h = island.height();
    switch (side) {
        case 0:
            return {along, depth};
        case 1:
            return {w - depth, along};
        case 2:
            return {w - along, h - depth};
        default:
            return {depth, h - along};
    }
}

double along_of(const Island& island, int side, glm::dvec2 p) {
    switch (side) {
        case 0:
            return p.x;
        case 1:
            return p.y;
        case 2:
            return island.width() - p.x;
        default:
            return island.height() - p.y;
    }
}

double depth_of(const Island& island, int side, glm::dvec2 p) {
    switch (side) {
        case 0:
            return p.y;
        case 1:
            return island.width() - p.x;
        case 2:
            return island.height() - p.y;
        default:
            return p.x;
    }
}

std::array<std::uint32_t, 2> ends(const Island& island, int side, int index) {
    const int c = island.columns, r = island.rows;
    switch (side) {
        case 0:
            return {island.vertex(index, 0), island.vertex(index + 1, 0)};
        case 1:
            return {island.vertex(c, index), island.vertex(c, index + 1)};
        case 2:
            return {island.vertex(c - index, r), island.vertex(c - index - 1, r)};
        default:
            return {island.vertex(0, r - index), island.vertex(0, r - index - 1)};
    }
}

// The side that the point lies beyond in x (1, 3) or y (0, 2); -1 for neither.
int outside_x(const Island& island, glm::dvec2 p) {
    return p.x < 0 ? 3 : p.x > island.width() ? 1 : -1;
}
int outside_y(const Island& island, glm::dvec2 p) {
    return p.y < 0 ? 0 : p.y > island.height() ? 2 : -1;
}

double distance_outside(const Island& island, glm::dvec2 p) {
    const double dx = std::max({-p.x, p.x - island.width(), 0.0});
    const double dy = std::max({-p.y, p.y - island.height(), 0.0});
    return std::max(dx, dy);
}

}  // namespace

struct Atlas::Painting {
    int size;
    double pitch;
    double reach;  // how far gutters go, lattice units
    std::uint16_t one;
    const HeightFunction& height;
    const FreeHeightFunction& free_height;

    std::uint16_t count(double value) const {
        return static_cast<std::uint16_t>(std::floor(clamp01(value) * one + 0.5));
    }
};

Atlas::Atlas(const Shape& shape) : shape_(shape) {
    for (int i = 0; i < static_cast<int>(shape.islands.size()); ++i) {
        const Island& island = shape.islands[static_cast<std::size_t>(i)];
        for (int side = 0; side < 4; ++side)
            for (int index = 0; index < cells_along(island, side); ++index) {
                const auto [from, to] = ends(island, side, index);
                edges_[edge_key(from, to)] = {i, side, index};
            }
    }
    for (const auto& [key, edge] : edges_)
        if (const std::optional<Edge> other = across(edge))
            if (cell_along(shape.islands[static_cast<std::size_t>(edge.island)], edge.side) !=
                cell_along(shape.islands[static_cast<std::size_t>(other->island)], other->side))
                throw std::logic_error("a seam's sides differ in scale");
}

std::optional<Atlas::Edge> Atlas::across(const Edge& edge) const {
    const Island& island = shape_.islands[static_cast<std::size_t>(edge.island)];
    const auto [from, to] = ends(island, edge.side, edge.index);
    const auto found = edges_.find(edge_key(to, from));
    if (found == edges_.end()) return std::nullopt;
    return found->second;
}

// Carries a point beyond `side` into the island there; at an open border, to the nearest texel of its own
// island.
Atlas::Point Atlas::cross(const Point& outside, int side, double pitch) const {
    const Island& island = shape_.islands[static_cast<std::size_t>(outside.island)];
    const double along = along_of(island, side, outside.local);
    const double beyond = -depth_of(island, side, outside.local);
    const int cell = cell_along(island, side);
    const int index =
        std::clamp(static_cast<int>(std::floor(along / cell)), 0, cells_along(island, side) - 1);
    const std::optional<Edge> other = across({outside.island, side, index});
    if (!other) {
        if (shape_.rows_continue && side == 2) return outside;
        return {outside.island, from_side(island, side, along, pitch / 2)};
    }
    const Island& there = shape_.islands[static_cast<std::size_t>(other->island)];
    const double other_along = (other->index + 1) * cell - (along - index * cell);
    return {other->island, from_side(there, other->side, other_along, beyond)};
}

std::uint16_t Atlas::island_texel(const Painting& painting, const Point& point) const {
    const Island& island = shape_.islands[static_cast<std::size_t>(point.island)];
    const glm::dvec2 p = point.local;
    return painting.count(
        painting.height({point.island, p.x, p.y, p.x / island.cell_w, p.y / island.cell_h, painting.pitch}));
}

std::uint16_t Atlas::texel(const Painting& painting, int x, int y) const {
    const double pitch = painting.pitch;
    const glm::dvec2 map_point{(x + 0.5) * pitch, (y + 0.5) * pitch};
    Point point{-1, {}};
    double nearest = painting.reach;
    for (int i = 0; i < static_cast<int>(shape_.islands.size()); ++i) {
        const Island& island = shape_.islands[static_cast<std::size_t>(i)];
        const glm::dvec2 local = island.local_from_map(map_point);
        const double distance = distance_outside(island, local);
        if (distance >= nearest) continue;
        nearest = distance;
        point = {i, local};
    }
    if (point.island < 0) return painting.count(painting.free_height ? painting.free_height(map_point) : 0.5);

    const Island& island = shape_.islands[static_cast<std::size_t>(point.island)];
    const int side_x = outside_x(island, point.local), side_y = outside_y(island, point.local);
    if (side_x < 0 && side_y < 0) return island_texel(painting, point);
    if (side_x < 0 || side_y < 0)
        return island_texel(painting, cross(point, std::max(side_x, side_y), pitch));

    // Beyond a corner: where four cells meet, both ways round lead to one texel.
    const auto settle = [&](Point p) {
        const Island& now = shape_.islands[static_cast<std::size_t>(p.island)];
        const int sx = outside_x(now, p.local), sy = outside_y(now, p.local);
        if (sx < 0 && sy < 0) return p;
        return cross(p, sx >= 0 ? sx : sy, pitch);
    };
    const Point one_way = settle(cross(point, side_x, pitch)),
                other_way = settle(cross(point, side_y, pitch));
    if (one_way == other_way) return island_texel(painting, one_way);

    // Where three meet (a corner of a box) there is no such texel. The seams are exact when all three corner
    // gutters hold one value: the mean of the three corner texels.
    const glm::dvec2 inner{side_x == 1 ? island.width() - pitch / 2 : pitch / 2,
                           side_y == 2 ? island.height() - pitch / 2 : pitch / 2};
    const glm::dvec2 right{side_x == 1 ? island.width() + pitch / 2 : -pitch / 2, inner.y};
    const glm::dvec2 above{inner.x, side_y == 2 ? island.height() + pitch / 2 : -pitch / 2};
    const int sum = island_texel(painting, {point.island, inner}) +
                    island_texel(painting, cross({point.island, right}, side_x, pitch)) +
                    island_texel(painting, cross({point.island, above}, side_y, pitch));
    return static_cast<std::uint16_t>((sum + 1) / 3);
}

std::vector<std::uint16_t> Atlas::paint(int size, std::uint16_t one, const HeightFunction& height,
                                        const FreeHeightFunction& free_height) const {
    const double pitch = static_cast<double>(kLattice) / size;
    // Gutters meet halfway between islands; a coarse map's need their two texels all the same.
    const Painting painting{size, pitch, std::max(kGap / 2.0, 2.0 * pitch), one, height, free_height};
    std::vector<std::uint16_t> map(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const auto work = [&](int first) {
        for (int y = first; y < size; y += threads)
            for (int x = 0; x < size; ++x)
                map[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                    static_cast<std::size_t>(x)] = texel(painting, x, y);
    };
    std::vector<std::jthread> pool;
    for (int first = 0; first < threads; ++first) pool.emplace_back(work, first);
    pool.clear();
    return map;
}

}  // namespace relievo::assets
