// See stale_tiles.h.
#include "editor/gui/stale_tiles.h"

#include <algorithm>
#include <limits>

namespace relievo::gui {
namespace {

constexpr int kTile = StaleTiles::kTile;

int tiles_in(int pixels) {
    return (pixels + kTile - 1) / kTile;
}

}  // namespace

void StaleTiles::reset(int width, int height) {
    width_ = width;
    height_ = height;
    columns_ = tiles_in(width);
    rows_ = tiles_in(height);
    tiles_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), late);
    count_ = columns_ * rows_;
    urgent_count_ = 0;
}

void StaleTiles::set(int column, int row, Level level) {
    std::uint8_t& tile = tiles_[index(column, row)];
    count_ += (level != fresh ? 1 : 0) - (tile != fresh ? 1 : 0);
    urgent_count_ += (level == urgent ? 1 : 0) - (tile == urgent ? 1 : 0);
    tile = level;
}

void StaleTiles::mark(const PixelRect& window, Level level) {
    if (window.x0 >= width_ || window.y0 >= height_) return;
    const int x1 = std::min(columns_, tiles_in(window.x1)), y1 = std::min(rows_, tiles_in(window.y1));
    for (int y = std::max(0, window.y0) / kTile; y < y1; ++y)
        for (int x = std::max(0, window.x0) / kTile; x < x1; ++x)
            if (at(x, y) < level) set(x, y, level);
}

void StaleTiles::clear(const PixelRect& traced) {
    for (int y = tiles_in(traced.y0); y < rows_ && std::min(height_, (y + 1) * kTile) <= traced.y1; ++y)
        for (int x = tiles_in(traced.x0); x < columns_ && std::min(width_, (x + 1) * kTile) <= traced.x1; ++x)
            set(x, y, fresh);
}

double StaleTiles::fresh_share() const {
    return tiles_.empty() ? 0 : 1 - static_cast<double>(count_) / static_cast<double>(tiles_.size());
}

StaleTiles::TileRect StaleTiles::nearest(const glm::dvec2& focus) const {
    const Level wanted = urgent_count_ > 0 ? urgent : late;
    double least = std::numeric_limits<double>::infinity();
    TileRect found{0, 0, 1, 1};
    for (int y = 0; y < rows_; ++y) {
        for (int x = 0; x < columns_; ++x) {
            if (at(x, y) != wanted) continue;
            const double dx = (x + 0.5) * kTile - focus.x, dy = (y + 0.5) * kTile - focus.y;
            if (dx * dx + dy * dy >= least) continue;
            least = dx * dx + dy * dy;
            found = {x, y, x + 1, y + 1};
        }
    }
    return found;
}

bool StaleTiles::all_stale(const TileRect& rect) const {
    if (rect.x0 < 0 || rect.y0 < 0 || rect.x1 > columns_ || rect.y1 > rows_) return false;
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x)
            if (!stale_at(x, y)) return false;
    return true;
}

PixelRect StaleTiles::pixels(const TileRect& r) const {
    return {r.x0 * kTile, r.y0 * kTile, std::min(width_, r.x1 * kTile), std::min(height_, r.y1 * kTile)};
}

// Grows at one side after another while that side's neighbours are all stale.
PixelRect StaleTiles::next(const glm::dvec2& focus, double most_pixels) const {
    TileRect rect = nearest(focus);
    constexpr int kSides = 4;
    for (int refused = 0, side = 0; refused < kSides; side = (side + 1) % kSides) {
        TileRect wider = rect, added = rect;
        if (side == 0) added.x0 = (added.x1 = rect.x0) - 1, wider.x0 = added.x0;
        if (side == 1) added.y0 = (added.y1 = rect.y0) - 1, wider.y0 = added.y0;
        if (side == 2) added.x1 = (added.x0 = rect.x1) + 1, wider.x1 = added.x1;
        if (side == 3) added.y1 = (added.y0 = rect.y1) + 1, wider.y1 = added.y1;
        const double area =
            static_cast<double>((wider.x1 - wider.x0) * (wider.y1 - wider.y0)) * kTile * kTile;
        const bool taken = area <= most_pixels && all_stale(added);
        refused = taken ? 0 : refused + 1;
        if (taken) rect = wider;
    }
    return pixels(rect);
}

}  // namespace relievo::gui
