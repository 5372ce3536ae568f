// See cell_table.h.
#include "brushes/cell_table.h"

#include <utility>

namespace relievo {

void CellTable::grow() {
    const std::vector<Cell> old = std::exchange(cells_, std::vector<Cell>(2 * cells_.size()));
    for (const Cell& cell : old)
        if (cell.range.count > 0) cells_[slot_of(cell.key)] = cell;
}

}  // namespace relievo
