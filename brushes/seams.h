// Keeps both sides of a texture seam at one height under bilinear filtering.
//
// Seams along texel rows: gutter texels are copies of the texels across the seam (SeamCopy), equal after
// every dab; where the rows bend, copies with a shift (seam_bends.h).
//
// Slanted and scaled seams, after S. Liu, Z. Ferguson, A. Jacobson, Y. Gingold, "Seamless: Seam erasure and
// seam-aware decoupling of shape from mesh resolution", ACM TOG 36(6), 2017: least squares over the texels
// that bilinear filtering reads along the seam, so that the differences of both sides at points along it
// vanish, with a damping to the present values. Deviations: only the equations that a stroke touched are
// solved, the rest of the map stands fixed; texels that only filtering reads ("loose") start as the surface's
// extension of the island over the seam (or, without one, as the mean of the owned texels around), so that
// little is left to solve, and slopes pass; the damping is firm, and yields where heights would lie apart;
// differences are sampled (as the surface's equations say) where they integrate them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "brushes/seam_bends.h"
#include "brushes/stroke_tiles.h"
#include "brushes/surface.h"
#include "brushes/tile_index.h"

namespace relievo {

struct SeamSystem;

// What passes a seam: the values alone (masks, colours), or their slope as well (heights).
enum class Across { values, slopes };

class Seams {
  public:
    // Reads surface.seams() and surface.owned() once. Throws std::invalid_argument on a texel outside the
    // map.
    Seams(const Surface& surface, int width, int height);

    // A texel outside every island that holds a copy of the surface.
    bool is_gutter(int x, int y) const;

    // After a dab: copies what changed, and extends islands to the loose texels beside what changed.
    void follow(StrokeTiles& stroke, Across across) const;

    // At a stroke's end: solves the equations that it touched, then follows. What the mask protects wholly
    // stands fixed (null: nothing).
    void settle(StrokeTiles& stroke, Across across, const HeightMap* mask = nullptr) const;

    // Makes every gutter texel of a mask that was changed without a stroke equal to its source.
    void copy_all(HeightMap& map) const;

  private:
    struct Texel {
        std::int16_t x, y;
    };
    struct Weighted {
        Texel at;
        float weight;
    };
    struct Loose {
        std::uint32_t texel;
        std::vector<Weighted> sources;  // owned
    };

    Texel place(std::uint32_t texel) const {
        return {static_cast<std::int16_t>(texel % width_), static_cast<std::int16_t>(texel / width_)};
    }
    void index_copies(const SeamTable& table, const TileGrid& grid);
    void index_equations(const SeamTable& table, const Surface& surface, const TileGrid& grid);
    void add_unowned_around(std::uint32_t texel, const Surface& surface,
                            std::vector<std::uint32_t>& loose) const;
    void add_loose(std::uint32_t texel, const Surface& surface, const TileGrid& grid);
    std::vector<Weighted> mean_of_owned(std::uint32_t texel, const Surface& surface,
                                        const TileGrid& grid) const;
    void copy_changed(StrokeTiles& stroke, Across across) const;
    void extend_islands(StrokeTiles& stroke) const;
    bool is_loose(std::uint32_t texel) const;
    std::vector<std::uint32_t> touched_texels(const StrokeTiles& stroke) const;
    std::vector<std::uint32_t> equations_on(const std::vector<std::uint32_t>& texels,
                                            const TileGrid& grid) const;
    SeamSystem system_on(const std::vector<std::uint32_t>& unknowns, const StrokeTiles& stroke) const;

    std::uint32_t width_, height_;
    std::vector<SeamCopy> copies_;  // sorted by gutter
    std::vector<bool> shifted_;     // of each copy: bends_ determines its height
    SeamBends bends_;
    std::vector<SeamEquation> equations_;  // gutters replaced by their sources
    std::vector<Loose> loose_;             // sorted by texel
    TileIndex copies_of_tile_, equations_of_tile_, loose_of_tile_;
};

}  // namespace relievo
