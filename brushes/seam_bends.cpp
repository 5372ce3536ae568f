// Shifts of gutters in whole counts; see the header for where they come from.
#include "brushes/seam_bends.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace relievo {
namespace {

constexpr int kHighest = static_cast<int>(kTop);

// The two maps that gutters are set in, by texel index.
struct InStroke {
    StrokeTiles& stroke;
    std::uint32_t width;

    int x(std::uint32_t texel) const { return static_cast<int>(texel % width); }
    int y(std::uint32_t texel) const { return static_cast<int>(texel / width); }
    int count(std::uint32_t texel) const { return stroke.count(x(texel), y(texel)); }
    void set(std::uint32_t texel, int count) {
        stroke.set_value(x(texel), y(texel), static_cast<float>(count));
    }
    void copy(std::uint32_t from, std::uint32_t to, int shift) {
        stroke.copy(x(from), y(from), x(to), y(to), shift);
    }
};

struct InMap {
    HeightMap& map;

    int count(std::uint32_t texel) const { return map.texels()[texel]; }
    void set(std::uint32_t texel, int count) { map.texels()[texel] = static_cast<std::uint16_t>(count); }
    void copy(std::uint32_t from, std::uint32_t to, int shift) { set(to, count(from) + shift); }
};

std::int64_t rounded_quotient(std::int64_t value, std::int64_t divisor) {
    const std::int64_t half = divisor / 2;
    return value < 0 ? -((half - value) / divisor) : (value + half) / divisor;
}

template <typename Map>
int shift_of(const SeamBend& bend, const Map& map) {
    const int inside[2] = {map.count(bend.inside[0]), map.count(bend.inside[1])};
    int low = std::min(inside[0], inside[1]), high = std::max(inside[0], inside[1]);
    std::int64_t sum = std::int64_t{bend.lean} * (inside[0] - inside[1]);
    for (int k = 0; k < 2; ++k) {
        const int ahead = map.count(bend.ahead[k]), behind = map.count(bend.behind[k]);
        low = std::min({low, ahead, behind});
        high = std::max({high, ahead, behind});
        sum += std::int64_t{bend.bend[k]} * (ahead - behind);
    }
    const std::int64_t lowest = std::max(low - high, -std::min(inside[0], inside[1]));
    const std::int64_t highest = std::min(high - low, kHighest - std::max(inside[0], inside[1]));
    return static_cast<int>(std::clamp(rounded_quotient(sum, SeamBend::kOne), lowest, highest));
}

template <typename Map>
void set_column(const SeamBend& bend, Map& map) {
    const int shift = shift_of(bend, map);
    for (int k = 0; k < 2; ++k) map.copy(bend.inside[1 - k], bend.gutter[k], shift);
}

}  // namespace

SeamBends::SeamBends(const SeamTable& table, int width, int height)
    : width_(static_cast<std::uint32_t>(width)),
      bends_(table.bends),
      corners_(table.corners),
      corner_of_(bends_.size(), kNone) {
    const TileGrid grid(width, height);
    const std::uint32_t texels = width_ * static_cast<std::uint32_t>(height);
    const auto check = [&](std::uint32_t texel, const char* what, std::uint32_t i) {
        if (texel >= texels) throw std::invalid_argument(what + std::to_string(i) + " lies outside the map");
    };
    for (std::uint32_t i = 0; i < bends_.size(); ++i)
        for (int k = 0; k < 2; ++k) {
            check(bends_[i].gutter[k], "seam bend ", i);
            gutters_.push_back(bends_[i].gutter[k]);
            for (const std::uint32_t texel : {bends_[i].inside[k], bends_[i].ahead[k], bends_[i].behind[k]}) {
                check(texel, "seam bend ", i);
                bends_of_tile_.emplace_back(grid.tile_of(texel), i);
            }
        }
    for (std::uint32_t i = 0; i < corners_.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            check(std::max(corners_[i].gutter[k], corners_[i].inside[k]), "seam corner ", i);
            if (corners_[i].bend[k] >= bends_.size())
                throw std::invalid_argument("seam corner " + std::to_string(i) + " names no bend");
            gutters_.push_back(corners_[i].gutter[k]);
            corner_of_[corners_[i].bend[k]] = i;
        }
    sort_unique(gutters_);
    sort_unique(bends_of_tile_);
}

bool SeamBends::determines(std::uint32_t texel) const {
    return std::binary_search(gutters_.begin(), gutters_.end(), texel);
}

template <typename Map>
void SeamBends::set_corner(const SeamCorner& corner, Map& map) const {
    int shift[3];
    std::int64_t others = 0, mean = 0, weights = 0;
    for (int k = 0; k < 3; ++k) {
        const int count = map.count(corner.inside[k]);
        shift[k] = shift_of(bends_[corner.bend[k]], map);
        others += count + shift[k];
        mean += std::int64_t{corner.weight[k]} * count;
        weights += corner.weight[k];
    }
    // The height at the vertex is the mean of the four texels about it, three of which stand already. Each
    // shift keeps the texels inside its two islands' corners in the range, so that some g keeps all three
    // gutters.
    const std::int64_t g = std::clamp<std::int64_t>(rounded_quotient(4 * mean, weights) - others,
                                                    -*std::min_element(shift, shift + 3),
                                                    kHighest - *std::max_element(shift, shift + 3));
    for (int k = 0; k < 3; ++k) map.set(corner.gutter[k], static_cast<int>(g) + shift[k]);
}

std::vector<std::uint32_t> SeamBends::changed(const StrokeTiles& stroke) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t tile : stroke.dirty()) {
        const TexelRect dirty = stroke.tile(tile)->dirty;
        const auto holds = [&](std::uint32_t texel) {
            return dirty.contains(static_cast<int>(texel % width_), static_cast<int>(texel / width_));
        };
        visit_tile(bends_of_tile_, tile, [&](std::uint32_t i) {
            const SeamBend& bend = bends_[i];
            bool read = false;
            for (int k = 0; k < 2; ++k)
                read = read || holds(bend.inside[k]) || holds(bend.ahead[k]) || holds(bend.behind[k]);
            if (read) found.push_back(i);
        });
    }
    sort_unique(found);
    // A corner and its columns hold together: one of them alone would tear the seams' ends.
    for (std::size_t i = 0, size = found.size(); i < size; ++i) {
        const std::uint32_t corner = corner_of_[found[i]];
        if (corner != kNone) found.insert(found.end(), corners_[corner].bend, corners_[corner].bend + 3);
    }
    sort_unique(found);
    return found;
}

void SeamBends::follow(StrokeTiles& stroke) const {
    InStroke map{stroke, width_};
    for (const std::uint32_t i : changed(stroke)) {
        set_column(bends_[i], map);
        const std::uint32_t corner = corner_of_[i];
        if (corner != kNone && corners_[corner].bend[0] == i) set_corner(corners_[corner], map);
    }
}

void SeamBends::apply(HeightMap& map) const {
    InMap in_map{map};
    for (const SeamBend& bend : bends_) set_column(bend, in_map);
    for (const SeamCorner& corner : corners_) set_corner(corner, in_map);
}

}  // namespace relievo
