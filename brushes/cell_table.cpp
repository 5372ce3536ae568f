// See cell_table.h.
#include "brushes/cell_table.h"

namespace relievo {

std::uint32_t CellTable::add(std::int64_t key) {
    const std::size_t slot = slot_of(key);
    if (slots_[slot] != kFree) return slots_[slot];
    const auto cell = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back({key, {0, 0}});
    slots_[slot] = cell;
    if (2 * cells_.size() > slots_.size()) {
        slots_.assign(2 * slots_.size(), kFree);
        for (std::uint32_t i = 0; i <= cell; ++i) slots_[slot_of(cells_[i].key)] = i;
    }
    return cell;
}

}  // namespace relievo
