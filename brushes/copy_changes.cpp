// See copy_changes.h. Changes are taken in the copies' order, whichever core was done first: the order of a
// sum shows in its last bit.
#include "brushes/copy_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace relievo {

namespace {

double larger(double a, double b) {
    return std::abs(b) > std::abs(a) || (b == -a && b > 0) ? b : a;
}

}  // namespace

void CopyChanges::Sum::add(const TexelChange& change, bool add_up) {
    if (++changes == 1) {
        from = change.from;
        together = double{change.to};
        return;
    }
    if (changes == 2) {  // steps from here on
        const double first = double{static_cast<float>(together) - from};
        together = add_up ? first : larger(0, first);
    }
    const double step = double{change.to - change.from};
    together = add_up ? together + step : larger(together, step);
}

float CopyChanges::Sum::to() const {
    return changes == 1 ? static_cast<float>(together) : from + static_cast<float>(together);
}

void CopyChanges::add(std::size_t copy, std::vector<TexelChange> changes) {
    const std::lock_guard lock(mutex_);
    bytes_ += changes.size() * sizeof(TexelChange);
    lists_[copy] = std::move(changes);
    if (bytes_ <= waiting_) return;
    for (; summed_ < lists_.size() && lists_[summed_]; ++summed_) {
        sum_up(*lists_[summed_]);
        bytes_ -= lists_[summed_]->size() * sizeof(TexelChange);
        std::vector<TexelChange>().swap(*lists_[summed_]);
    }
}

void CopyChanges::sum_up(const std::vector<TexelChange>& changes) {
    tiles_.resize(stroke_.grid().count());
    for (const TexelChange& change : changes) {
        std::unique_ptr<SumTile>& tile = tiles_[stroke_.grid().tile_of(change.x, change.y)];
        if (!tile) tile = std::make_unique<SumTile>();
        (*tile)[place_in_tile(change.x, change.y)].add(change, add_up_);
    }
}

void CopyChanges::apply() {
    if (summed_ == 0) return apply_lists();
    for (; summed_ < lists_.size(); ++summed_) sum_up(*lists_[summed_]);
    apply_sums();
}

// By rows, as lists are applied.
void CopyChanges::apply_sums() {
    const TexelRect map = stroke_.grid().bounds();
    for (int y = 0; y < map.y1; ++y)
        for (int x0 = 0; x0 < map.x1; x0 += kTileSize) {
            const SumTile* tile = tiles_[stroke_.grid().tile_of(x0, y)].get();
            if (!tile) continue;
            for (int x = x0; x < std::min(x0 + kTileSize, map.x1); ++x) {
                const Sum& sum = (*tile)[place_in_tile(x, y)];
                if (sum.changes > 0) stroke_.set_change(x, y, sum.to());
            }
        }
}

// One copy's, each texel once and in order: most dabs.
bool CopyChanges::apply_plainly() {
    const auto not_before = [](const TexelChange& a, const TexelChange& b) {
        return std::tie(a.y, a.x) >= std::tie(b.y, b.x);
    };
    if (lists_.size() != 1 || std::ranges::adjacent_find(*lists_[0], not_before) != lists_[0]->end()) return false;
    for (const TexelChange& change : *lists_[0]) stroke_.set_change(change.x, change.y, change.to);
    return true;
}

void CopyChanges::apply_lists() {
    if (apply_plainly()) return;
    std::vector<std::size_t> next(lists_.size(), 0);
    std::vector<TexelChange> row;
    const auto by_column = [](const TexelChange& a, const TexelChange& b) { return a.x < b.x; };
    while (true) {
        std::int32_t y = std::numeric_limits<std::int32_t>::max();
        for (std::size_t k = 0; k < next.size(); ++k)
            if (next[k] < lists_[k]->size()) y = std::min(y, (*lists_[k])[next[k]].y);
        row.clear();
        for (std::size_t k = 0; k < next.size(); ++k)
            for (; next[k] < lists_[k]->size() && (*lists_[k])[next[k]].y == y; ++next[k])
                row.push_back((*lists_[k])[next[k]]);
        if (row.empty()) return;
        if (!std::is_sorted(row.begin(), row.end(), by_column))
            std::stable_sort(row.begin(), row.end(), by_column);
        for (std::size_t i = 0; i < row.size();) {
            const std::int32_t x = row[i].x;
            Sum sum{};
            for (; i < row.size() && row[i].x == x; ++i) sum.add(row[i], add_up_);
            stroke_.set_change(x, y, sum.to());
        }
    }
}

}  // namespace relievo
