// Gutters of height maps where texel rows bend at a seam, by the brushes' own rule (brushes/seam_bends.h), so
// that sculpting near a seam changes nothing beside the stroke.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace relievo::assets {

// `map` is of size x size counts, row 0 at the bottom, of the mesh in the file, repeated; its gutters hold
// what lies across the seams. Throws std::invalid_argument when the mesh cannot be read.
void bend_gutters(const std::filesystem::path& mesh, int size, std::vector<std::uint16_t>& map);

}  // namespace relievo::assets
