#include "assets/generator/bent_gutters.h"

#include <algorithm>
#include <glm/mat4x4.hpp>

#include "brushes/height_map.h"
#include "brushes/seam_bends.h"
#include "editor/session/surface/seam_table.h"
#include "renderer/scene/mesh.h"

namespace relievo::assets {

void bend_gutters(const std::filesystem::path& path, int size, std::vector<std::uint16_t>& map) {
    const Mesh mesh = make_mesh(load_mesh_file(path), glm::dmat4(1.0), glm::dvec3(0.0), true);
    HeightMap heights(size, size);
    std::copy(map.begin(), map.end(), heights.texels().begin());
    SeamBends(build_seam_table(mesh, size, size, Wrap::repeat), size, size).apply(heights);
    std::copy(heights.texels().begin(), heights.texels().end(), map.begin());
}

}  // namespace relievo::assets
