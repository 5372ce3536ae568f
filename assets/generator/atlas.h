// Paints a map over a shape's islands: every texel's height is asked at its surface point, and the gutter
// around an island holds what lies across the seam, so that bilinear heights agree along it.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "assets/generator/shape.h"

namespace relievo::assets {

// A point of an island.
struct Sample {
    int island;
    double x, y;   // lattice units along columns and rows from the island's corner
    double s, t;   // the same in cells
    double pitch;  // lattice units a texel
};

using HeightFunction = std::function<double(const Sample&)>;         // map value, clamped to [0, 1]
using FreeHeightFunction = std::function<double(glm::dvec2 point)>;  // of a point of the map, lattice units

class Atlas {
  public:
    // `shape` outlives the atlas. Throws std::logic_error when the two sides of a seam differ in scale.
    explicit Atlas(const Shape& shape);

    // A map of size x size counts in [0, one], row 0 at the bottom. Texels far from every island get
    // `free_height`'s value, or half of `one` without it. Calls the functions from several threads.
    std::vector<std::uint16_t> paint(int size, std::uint16_t one, const HeightFunction& height,
                                     const FreeHeightFunction& free_height) const;

  private:
    struct Point {  // of an island, or outside its rectangle
        int island;
        glm::dvec2 local;
        bool operator==(const Point&) const = default;
    };
    struct Edge {  // one cell's edge on an island's border; side 0 bottom, 1 right, 2 top, 3 left
        int island, side, index;
    };
    struct Painting;

    std::optional<Edge> across(const Edge& edge) const;
    Point cross(const Point& outside, int side, double pitch) const;
    std::uint16_t island_texel(const Painting& painting, const Point& point) const;
    std::uint16_t texel(const Painting& painting, int x, int y) const;

    const Shape& shape_;
    std::unordered_map<std::uint64_t, Edge> edges_;  // by the two positions, in counter-clockwise order
};

}  // namespace relievo::assets
