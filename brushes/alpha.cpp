// The pyramid of a stamp's image, and reading it.
#include "brushes/alpha.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>

#include "brushes/fnv1a.h"

namespace relievo {
namespace {

void check(const std::filesystem::path& path, int width, int height, const std::vector<float>& values) {
    const std::string where = "alpha '" + path.string() + "': ";
    if (width < 1 || height < 1 || width > Alpha::kMaxSize || height > Alpha::kMaxSize)
        throw std::invalid_argument(where + std::to_string(width) + " x " + std::to_string(height) +
                                    " pixels; each side must be 1 to " + std::to_string(Alpha::kMaxSize));
    if (values.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw std::invalid_argument(where + "has " + std::to_string(values.size()) + " values for " +
                                    std::to_string(width) + " x " + std::to_string(height) + " pixels");
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw std::invalid_argument(where + (std::isnan(values[i]) ? "NaN" : "infinity") + " at pixel (" +
                                        std::to_string(i % static_cast<std::size_t>(width)) + ", " +
                                        std::to_string(i / static_cast<std::size_t>(width)) +
                                        "), counted from the lower left; every value must be finite");
}

}  // namespace

Alpha::Alpha(std::filesystem::path path, int width, int height, std::vector<float> values)
    : path_(std::move(path)) {
    check(path_, width, height, values);
    for (const float value : values) largest_ = std::max(largest_, std::abs(value));
    if (largest_ > 1.0f)
        for (float& value : values) value /= largest_;
    Fnv1a64 hash;
    hash.add_little_endian(static_cast<std::uint32_t>(width));
    hash.add_little_endian(static_cast<std::uint32_t>(height));
    for (const float value : values) hash.add_little_endian(std::bit_cast<std::uint32_t>(value));
    hash_ = hash.value();
    levels_.push_back({width, height, std::move(values)});
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const Level& fine = levels_.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        coarse.values.reserve(static_cast<std::size_t>(coarse.width) *
                              static_cast<std::size_t>(coarse.height));
        const auto value = [&](int x, int y) {
            x = std::min(x, fine.width - 1), y = std::min(y, fine.height - 1);
            return double{fine.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(fine.width) +
                                      static_cast<std::size_t>(x)]};
        };
        for (int y = 0; y < 2 * coarse.height; y += 2)
            for (int x = 0; x < 2 * coarse.width; x += 2)
                coarse.values.push_back(static_cast<float>(
                    0.25 * (value(x, y) + value(x + 1, y) + value(x, y + 1) + value(x + 1, y + 1))));
        levels_.push_back(std::move(coarse));
    }
}

// `x`, `y`: in pixels of the level from its lower left corner.
float Alpha::bilinear(std::size_t level, double x, double y) const {
    const Level& l = levels_[level];
    x = std::clamp(x - 0.5, 0.0, l.width - 1.0), y = std::clamp(y - 0.5, 0.0, l.height - 1.0);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, l.width - 1), y1 = std::min(y0 + 1, l.height - 1);
    const auto value = [&](int i, int j) {
        return double{l.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(l.width) +
                               static_cast<std::size_t>(i)]};
    };
    const double fx = x - x0, fy = y - y0;
    return static_cast<float>((1 - fy) * ((1 - fx) * value(x0, y0) + fx * value(x1, y0)) +
                              fy * ((1 - fx) * value(x0, y1) + fx * value(x1, y1)));
}

float Alpha::at(double x, double y, double footprint) const {
    const double half = 0.5 * std::max(width(), height());  // pixels in a unit
    const double px = 0.5 * width() + half * x, py = 0.5 * height() + half * y;
    if (!(px >= 0 && py >= 0 && px <= width() && py <= height())) return 0.0f;
    // 2^level <= footprint in pixels; in between, the two levels are blended by how far it is to the next.
    int exponent = 0;
    const double fraction = std::frexp(std::clamp(half * footprint, 1.0, 1e6), &exponent);
    const auto level = std::min(static_cast<std::size_t>(exponent - 1), levels_.size() - 1);
    const double scale = std::ldexp(1.0, -static_cast<int>(level));
    const float fine = bilinear(level, scale * px, scale * py);
    if (level + 1 == levels_.size()) return fine;
    const float coarse = bilinear(level + 1, 0.5 * scale * px, 0.5 * scale * py);
    return fine + static_cast<float>(2.0 * fraction - 1.0) * (coarse - fine);
}

}  // namespace relievo
