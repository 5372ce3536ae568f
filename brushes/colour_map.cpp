// See colour_map.h.
#include "brushes/colour_map.h"

#include <stdexcept>
#include <string>

#include "brushes/fnv1a.h"

namespace relievo {
namespace {

int checked(int bits) {
    if (bits != 8 && bits != 16)
        throw std::invalid_argument("a colour map of " + std::to_string(bits) + " bits: it must be 8 or 16");
    return bits;
}

std::uint16_t nearest(std::uint16_t count, int bits) {
    return bits == 16 ? count : static_cast<std::uint16_t>((count + 128) / 257 * 257);
}

}  // namespace

ColourMap::ColourMap(int width, int height, int bits, const std::array<std::uint16_t, 3>& fill)
    : bits_(checked(bits)),
      planes_{HeightMap(width, height, nearest(fill[0], bits)),
              HeightMap(width, height, nearest(fill[1], bits)),
              HeightMap(width, height, nearest(fill[2], bits))} {}

std::uint64_t ColourMap::hash() const {
    Fnv1a64 hash;
    hash.add_little_endian(static_cast<std::uint32_t>(bits_));
    for (const HeightMap& plane : planes_) hash.add_little_endian(plane.hash());
    return hash.value();
}

}  // namespace relievo
