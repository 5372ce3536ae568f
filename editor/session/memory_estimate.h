// What a map will take in memory, asked before it is loaded: a map that does not fit is refused in words, not
// by the system's killer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "brushes/colour_file.h"
#include "brushes/map_file.h"
#include "renderer/methods/registry.h"

namespace relievo {

// Bytes. The figures are bounds from above, measured at 2048 to 8192 texels a side; on top come undo steps,
// up to their own budget, and what edits keep of the saved map, at most 2 bytes a texel.
struct MapMemory {
    std::uint64_t editing = 0;  // texels, what of the file is kept for saving, texel tables of the surface
    std::uint64_t passing = 0;  // while the file is read or written
    std::uint64_t device = 0;   // image, and the bounds of its heights where the method wants them
};
MapMemory estimate_memory(const MapInfo& map, bool with_renderer, MapBounds bounds);

// The same of a colour map.
MapMemory estimate_colour_memory(const ColourInfo& colours, bool with_renderer);

// What this process may still take: the least of the system's available memory, the control group's rest and
// the process's own limit of address space.
std::uint64_t available_memory();

// There is not memory enough, now.
class MemoryShortage : public std::invalid_argument {
  public:
    using std::invalid_argument::invalid_argument;
};

// Throws MemoryShortage when `need` is more than `available`: names the map, its size, both amounts,
// and what would help. Device memory counts too: the processor's own where it is the device, and where it is
// not, copies pass through as large.
void require_memory(const std::filesystem::path& map, const MapInfo& info, const MapMemory& need,
                    std::uint64_t available);

}  // namespace relievo
