// Lets slopes pass a texture seam at which the texel rows bend, without a difference of heights.
//
// A gutter texel stands where its island's texel-to-world map, carried on over the seam, puts it. Where rows
// go straight on at one scale that is the place of the other island's texel, and a copy is right. Elsewhere
// the two islands see other slopes across the seam, and light along the surface shows a line one texel wide.
// On a column across the seam, with A and B the texels at the border on either side, let the rows of side A
// go a across it and k_A column widths along it for each texel, likewise b and k_B, and let h be the border's
// height and h' its slope, counts a column. The gradient of the heights over the base mesh is the same on
// both sides when
//     (2 (h - A) - k_A h') / a = (2 (B - h) - k_B h') / b
// which gives h, and with it the gutters, B + d beyond A and A + d beyond B, by
//     d = 2 h - A - B = (b - a) / (a + b) (A - B) + (b k_A - a k_B) / (a + b) h'
// Any whole d keeps both sides at one height to the last count, so d is rounded once, for both. h' comes from
// the neighbouring columns' h with d = 0, an error of the heights' second differences.
//
// A shift is at most as large as the range of the six texels that it is made of: cliffs get no towers.
//
// Where three islands meet, three more gutters stand past the seams' ends. With d_k the last column's shift
// on the seam that does not touch gutter k's island, they hold g + d_k for one g, or the last half texels
// would differ; g makes the height at the vertex a mean of the islands' corner texels, weighted so that it is
// right where the heights are a plane.
#pragma once

#include <cstdint>
#include <vector>

#include "brushes/height_map.h"
#include "brushes/stroke_tiles.h"
#include "brushes/surface.h"
#include "brushes/tile_index.h"

namespace relievo {

class SeamBends {
  public:
    // Throws std::invalid_argument on a texel outside the map, or a bend outside the table.
    SeamBends(const SeamTable& table, int width, int height);

    // A gutter that a bend or a corner determines.
    bool determines(std::uint32_t texel) const;

    // Sets the gutters beside what changed since stroke.take_dirty().
    void follow(StrokeTiles& stroke) const;
    // Sets all of them.
    void apply(HeightMap& map) const;

  private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    template <typename Map>
    void set_corner(const SeamCorner& corner, Map& map) const;
    std::vector<std::uint32_t> changed(const StrokeTiles& stroke) const;  // bends, sorted

    std::uint32_t width_;
    std::vector<SeamBend> bends_;
    std::vector<SeamCorner> corners_;
    std::vector<std::uint32_t> corner_of_;  // of each bend, or kNone
    std::vector<std::uint32_t> gutters_;    // sorted
    TileIndex bends_of_tile_;               // what each reads
};

}  // namespace relievo
