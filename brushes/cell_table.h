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
    Range find(std::int64_t key) const { return cells_[slot_of(key)].range; }

  private:
    static constexpr std::int64_t kSpan = 1 << 20;  // cells a side

    struct Cell {
        std::int64_t key;
        Range range;  // count 0: a free slot
    };

    // Where the cell stands, or would.
    std::size_t slot_of(std::int64_t key) const {
        const std::size_t mask = cells_.size() - 1;
        std::size_t slot = (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15u >> 32) & mask;
        while (cells_[slot].range.count > 0 && cells_[slot].key != key) slot = (slot + 1) & mask;
        return slot;
    }
    void grow();

    std::vector<Cell> cells_ = std::vector<Cell>(64);  // by hash; a power of two, half of them free
    std::size_t held_ = 0;                             // cells with items
};

template <typename KeyOf>
std::vector<std::uint32_t> CellTable::place(std::uint32_t count, KeyOf key_of) {
    // Each item's number within its cell comes first, then the cells' own places.
    std::vector<std::uint32_t> places(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::int64_t key = key_of(i);
        Cell& cell = cells_[slot_of(key)];
        cell.key = key;
        places[i] = cell.range.count++;
        if (places[i] == 0 && 2 * ++held_ > cells_.size()) grow();
    }
    std::uint32_t first = 0;
    for (Cell& cell : cells_) {
        cell.range.first = first;
        first += cell.range.count;
    }
    for (std::uint32_t i = 0; i < count; ++i) places[i] += find(key_of(i)).first;
    return places;
}

}  // namespace relievo
