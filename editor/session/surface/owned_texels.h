// Which texels stand on the surface: one bit a texel (8 MiB for an 8192 x 8192 map), filled span by span.
#pragma once

#include <cstdint>
#include <vector>

#include "editor/session/surface/texel_sampling.h"
#include "renderer/scene/mesh.h"

namespace relievo {

class OwnedTexels {
  public:
    OwnedTexels(const Mesh& mesh, const MapGrid& grid);

    // True where the texel's centre lies in some face's texture footprint, borders included.
    bool operator()(std::uint32_t texel) const { return (words_[texel >> 6] >> (texel & 63) & 1) != 0; }

  private:
    void fill(std::size_t first, std::size_t last);  // closed range of texel indices

    std::vector<std::uint64_t> words_;
};

}  // namespace relievo
