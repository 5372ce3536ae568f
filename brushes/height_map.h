// The 16-bit displacement map that brushes edit: plain texels, no file, no GPU.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace relievo {

inline constexpr float kTop = 65535.0f;  // the highest count

class HeightMap {
  public:
    static constexpr int kMaxSize = 16384;  // texels a side

    // A map of one value. Throws std::invalid_argument when a side is outside [1, kMaxSize].
    HeightMap(int width, int height, std::uint16_t fill = 32768);

    int width() const { return width_; }
    int height() const { return height_; }

    // Row-major, row 0 at the bottom of the image (v = 0); texel (x, y) stands at uv ((x+.5)/W, (y+.5)/H).
    std::span<const std::uint16_t> texels() const { return texels_; }
    std::span<std::uint16_t> texels() { return texels_; }
    std::uint16_t at(int x, int y) const { return texels_[index(x, y)]; }
    void set(int x, int y, std::uint16_t count) { texels_[index(x, y)] = count; }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    // 64-bit FNV-1a of width, height and texels (little endian): what a journal's `expect` compares.
    std::uint64_t hash() const;

  private:
    int width_, height_;
    std::vector<std::uint16_t> texels_;
};

}  // namespace relievo
