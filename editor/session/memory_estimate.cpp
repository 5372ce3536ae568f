// See memory_estimate.h.
#include "editor/session/memory_estimate.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "editor/session/text.h"
#include "renderer/height_slabs.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kWithoutLimit = std::numeric_limits<std::uint64_t>::max();

// Bytes a texel beside the texel itself.
constexpr double kSurfaceTables = 0.25;  // which texels are owned, height bounds
// Overlapping bounds of levels 1 to 7, on the device and what they are made from.
double bytes_of(MapBounds bounds, const MapInfo& map) {
    switch (bounds) {
        case MapBounds::heights: return 3;
        case MapBounds::planes: return slab_levels_left_out(map.width, map.height) > 0 ? 2.25 : 4.75;
        default: return 0;
    }
}

// "Key:   12345 kB" of a /proc file, in bytes.
std::uint64_t proc_value(const char* file, const std::string& key) {
    std::ifstream in(file);
    for (std::string word; in >> word;) {
        std::uint64_t value = 0;
        if (word == key + ":" && in >> value) return value * 1024;
    }
    return kWithoutLimit;
}

// The first number in a file; a word such as "max" is no limit.
std::uint64_t number_in(const char* file) {
    std::uint64_t value = 0;
    return std::ifstream(file) >> value ? value : kWithoutLimit;
}

std::uint64_t rest(std::uint64_t limit, std::uint64_t used) {
    if (limit == kWithoutLimit || used == kWithoutLimit) return kWithoutLimit;
    return limit > used ? limit - used : 0;
}

}  // namespace

MapMemory estimate_memory(const MapInfo& map, bool with_renderer, MapBounds bounds) {
    const double texels = static_cast<double>(map.width) * map.height;
    const double file = texels * map.bytes_per_texel;
    const bool file_kept = map.bytes_per_texel > 2 || map.format == MapFormat::exr_half;
    MapMemory need;
    need.editing = static_cast<std::uint64_t>(texels * (sizeof(std::uint16_t) + kSurfaceTables) +
                                              (file_kept ? file : 0));
    need.passing = static_cast<std::uint64_t>(file);
    if (with_renderer)
        need.device =
            static_cast<std::uint64_t>(texels * (sizeof(std::uint16_t) + bytes_of(bounds, map)));
    return need;
}

MapMemory estimate_colour_memory(const ColourInfo& colours, bool with_renderer) {
    const std::uint64_t texels =
        static_cast<std::uint64_t>(colours.width) * static_cast<std::uint64_t>(colours.height);
    const std::uint64_t channel = colours.bits == 8 ? 1 : 2;
    const std::uint64_t file = texels * static_cast<std::uint64_t>(colours.channels) * channel;
    MapMemory need;
    need.editing = texels * 3 * sizeof(std::uint16_t) + (colours.channels > 3 ? file : 0);
    need.passing = file;
    if (with_renderer) need.device = texels * 4 * channel;
    return need;
}

std::uint64_t available_memory() {
    std::uint64_t least = proc_value("/proc/meminfo", "MemAvailable");
    least = std::min(
        least, rest(number_in("/sys/fs/cgroup/memory.max"), number_in("/sys/fs/cgroup/memory.current")));
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        least = std::min(least, rest(limit.rlim_cur, proc_value("/proc/self/status", "VmSize")));
    return least;
}

void require_memory(const fs::path& map, const MapInfo& info, const MapMemory& need,
                    std::uint64_t available) {
    const std::uint64_t total = need.editing + need.passing + need.device;
    if (total <= available) return;
    throw MemoryShortage("map '" + map.string() + "': " + std::to_string(info.width) + " x " +
                         std::to_string(info.height) + " texels take about " + bytes_text(total) + " of memory, " +
                         bytes_text(available) + " are free; close other programs or take a smaller map");
}

}  // namespace relievo
