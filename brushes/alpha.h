// The grey image that the stamp tool presses into the surface.
//
// Where texels of the map lie further apart than its pixels, it is read from a pyramid of halved images,
// after L. Williams, "Pyramidal Parametrics", SIGGRAPH 1983, so that a large image under a small brush does
// not alias.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace relievo {

class Alpha {
  public:
    static constexpr int kMaxSize = 4096;  // pixels a side

    // `values`: row-major, row 0 at the bottom, finite; 0 leaves the surface as it is, 1 raises it fully, a
    // negative value lowers it. Where any is beyond [-1, 1], all are divided by the largest. Throws
    // std::invalid_argument when a side is outside [1, kMaxSize] or a value is not finite.
    Alpha(std::filesystem::path path, int width, int height, std::vector<float> values);

    const std::filesystem::path& path() const { return path_; }  // as given
    float largest() const { return largest_; }  // what all values were divided by; 1: by nothing
    int width() const { return levels_.front().width; }
    int height() const { return levels_.front().height; }
    std::span<const float> values() const { return levels_.front().values; }  // row 0 at the bottom

    // The value at (x, y), by bilinear filtering between pixel centres: the image's middle is (0, 0), its
    // longer side reaches from -1 to 1, y up. 0 beyond its border. `footprint`, in the same units: how far
    // apart the places lie that are asked for.
    float at(double x, double y, double footprint) const;

    // Of size and values (brushes/fnv1a.h): what a journal names the image by.
    std::uint64_t hash() const { return hash_; }

  private:
    struct Level {  // pixel (i, j) covers 2^level pixels of the image a side, from its lower left on
        int width, height;
        std::vector<float> values;
    };
    float bilinear(std::size_t level, double x, double y) const;

    std::filesystem::path path_;
    float largest_ = 1;
    std::vector<Level> levels_;
    std::uint64_t hash_;
};

// Reads the first image of any file that OpenImageIO knows, of 8, 16 or 32 bits or float: its one channel, or
// the luminance (ITU-R BT.709) of the first three, times the file's alpha channel where it has one. Stored
// values count as they are, without colour management. Throws std::invalid_argument that names the file and
// says what was wrong: missing, damaged, too large, a value that is not finite (with the pixel).
std::shared_ptr<const Alpha> load_alpha(const std::filesystem::path& path);

// Writes the values as an EXR of floats, atomically: load_alpha() reads an image of the same hash. Throws
// std::invalid_argument that names the file when it cannot be written.
void save_alpha(const Alpha& alpha, const std::filesystem::path& path);

}  // namespace relievo
