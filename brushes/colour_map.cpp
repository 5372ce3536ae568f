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

// Each byte of a plane waits for the one before: the three planes' go side by side.
std::uint64_t ColourMap::hash() const {
    std::array<Fnv1a64, 3> of_plane;
    for (Fnv1a64& hash : of_plane) {
        hash.add_little_endian(static_cast<std::uint32_t>(width()));
        hash.add_little_endian(static_cast<std::uint32_t>(height()));
    }
    const auto red = planes_[0].texels(), green = planes_[1].texels(), blue = planes_[2].texels();
    for (std::size_t i = 0; i < red.size(); ++i) {
        of_plane[0].add_little_endian(red[i]);
        of_plane[1].add_little_endian(green[i]);
        of_plane[2].add_little_endian(blue[i]);
    }
    Fnv1a64 hash;
    hash.add_little_endian(static_cast<std::uint32_t>(bits_));
    for (const Fnv1a64& plane : of_plane) hash.add_little_endian(plane.value());
    return hash.value();
}

}  // namespace relievo
