// The colour map that brushes paint: plain texels, no file, no GPU. Three planes of red, green and blue, each
// a map of its own, so that strokes, seams and undo treat a plane as they treat the heights.
#pragma once

#include <array>
#include <cstdint>

#include "brushes/height_map.h"

namespace relievo {

class ColourMap {
  public:
    // A map of one colour. `bits` of a channel: 8 or 16; with 8, every texel is a multiple of 257, the
    // nearest to `fill` here. Throws std::invalid_argument on other bits, or when a side is outside [1,
    // HeightMap::kMaxSize].
    ColourMap(int width, int height, int bits, const std::array<std::uint16_t, 3>& fill = {});

    int width() const { return planes_[0].width(); }
    int height() const { return planes_[0].height(); }
    int bits() const { return bits_; }
    // Between neighbouring values of a texel.
    int step() const { return bits_ == 8 ? 257 : 1; }

    // Texels 0 to 65535 for the sRGB-encoded values 0 to 1.
    HeightMap& plane(std::size_t channel) { return planes_[channel]; }
    const HeightMap& plane(std::size_t channel) const { return planes_[channel]; }

    // 64-bit FNV-1a of the bits, then of each plane's hash: what a journal's `expect` compares.
    std::uint64_t hash() const;

  private:
    int bits_;
    std::array<HeightMap, 3> planes_;
};

}  // namespace relievo
