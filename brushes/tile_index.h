// Which entries of a list read which tiles of the map: what a dab changed is found by its dirty tiles.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace relievo {

using TileIndex = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // (tile, entry), sorted

template <typename List>
void sort_unique(List& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

// Calls visit(entry) for each entry of the tile.
template <typename Visit>
void visit_tile(const TileIndex& index, std::uint32_t tile, Visit&& visit) {
    for (auto it = std::lower_bound(index.begin(), index.end(), std::pair{tile, std::uint32_t{0}});
         it != index.end() && it->first == tile; ++it)
        visit(it->second);
}

}  // namespace relievo
