// Which items lie in which cell of a grid over space: a hash of the cells that hold any, so that its size
// follows them, not the items, and not the space between.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace relievo {

class CellTable {
  public:
    struct Range {
        std::uint32_t first, count;  // places of items, cell by cell
    };

    // The key of the cell at whole coordinates in [-500000, 500000].
    static std::int64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
        return ((x + kSpan / 2) * kSpan + (y + kSpan / 2)) * kSpan + (z + kSpan / 2);
    }

    // For every item in turn, the key of its cell: gives each its place, so that those of a cell stand
    // together and in their given order. To be called once. Fewer than 2^32 - 1 items.
    template <typename KeyOf>  // std::int64_t(std::uint32_t item)
    std::vector<std::uint32_t> place(std::uint32_t count, KeyOf key_of);

    // Of a cell without items: {0, 0}.
    Range find(std::int64_t key) const {
        const std::uint32_t cell = slots_[slot_of(key)];
        return cell == kFree ? Range{0, 0} : cells_[cell].range;
    }

  private:
    static constexpr std::int64_t kSpan = 1 << 20;  // cells a side
    static constexpr std::uint32_t kFree = ~0u;

    struct Cell {
        std::int64_t key;
        Range range;
    };

    // Where the cell stands, or would.
    std::size_t slot_of(std::int64_t key) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15u >> 32) & mask;
        while (slots_[slot] != kFree && cells_[slots_[slot]].key != key) slot = (slot + 1) & mask;
        return slot;
    }
    std::uint32_t add(std::int64_t key);

    std::vector<Cell> cells_;                                    // in the order of their first items
    std::vector<std::uint32_t> slots_ = std::vector(64, kFree);  // into cells_; a power of two, half free
};

template <typename KeyOf>
std::vector<std::uint32_t> CellTable::place(std::uint32_t count, KeyOf key_of) {
    std::vector<std::uint32_t> places(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::int64_t key = key_of(i);
        // Neighbours mostly share a cell.
        const bool same = i > 0 && cells_[places[i - 1]].key == key;
        places[i] = same ? places[i - 1] : add(key);
        ++cells_[places[i]].range.count;
    }
    std::uint32_t first = 0;
    for (Cell& cell : cells_) {
        cell.range.first = first;
        first += cell.range.count;
        cell.range.count = 0;
    }
    for (std::uint32_t& place : places) {
        Range& range = cells_[place].range;
        place = range.first + range.count++;
    }
    return places;
}

}  // namespace relievo
