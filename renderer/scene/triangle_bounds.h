// Conservative heights of triangles over their texture-space footprints, and the triangles that texels touch:
// both live, at a cost that follows the edit and not the map.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "renderer/scene/mesh.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/texel_footprint.h"

namespace relievo {

struct HeightRange {
    std::uint16_t low = 65535, high = 0;  // counts; low > high: empty
};

// A min-max pyramid over blocks of 32 x 32 texels. It reads the map through the pointer that it was given:
// call update() with every rectangle that changed before the next range().
class HeightBounds {
  public:
    static constexpr int kBlock = 32;

    // Row-major texels, row 0 at v = 0; they outlive the bounds. Requires a size of at least 1 x 1.
    HeightBounds(int width, int height, const std::uint16_t* texels, Wrap wrap);

    // Reads the rectangle's blocks again (the rectangle may reach over the map). Costs as much as the
    // rectangle.
    void update(const TexelBox& rect);
    // The same map at another place, its texels unchanged.
    void move(const std::uint16_t* texels) { texels_ = texels; }

    // Least and greatest count of all texels that bilinear filtering touches on the triangle
    // (texel_footprint.h). Exact over that footprint. A triangle over more than 16 map periods gets the whole
    // map's range.
    HeightRange range(const glm::vec2& uv0, const glm::vec2& uv1, const glm::vec2& uv2) const;
    HeightRange range(const Mesh& mesh, std::uint32_t face) const;
    HeightRange whole() const { return levels_.back().nodes[0]; }

  private:
    struct Level {
        int width, height;
        std::vector<HeightRange> nodes;
    };
    TexelBox node_box(int level, int x, int y) const;
    void read_blocks(const TexelBox& blocks);
    void reduce(std::size_t level, const TexelBox& nodes);
    void extend(const FootprintPiece& piece, int level, int x, int y, HeightRange& range) const;
    void extend_by_rows(const FootprintPiece& piece, const TexelBox& box, HeightRange& range) const;

    int width_, height_;
    const std::uint16_t* texels_;
    Wrap wrap_;
    std::vector<Level> levels_;  // from blocks to a single node
};

// Which triangles a rectangle of texels can touch: a uniform grid over the map, each cell with the footprints
// that meet it.
class TriangleLookup {
  public:
    TriangleLookup(const Mesh& mesh, int width, int height, Wrap wrap);

    // The faces whose footprint holds a texel of the rectangle, ascending; `faces` is cleared first. The cost
    // follows the rectangle's cells and the faces found. The rectangle may reach over the map, which has no
    // texels there.
    void find(const TexelBox& rect, std::vector<std::uint32_t>& faces) const;

  private:
    struct Piece {
        FootprintPiece area;
        std::uint32_t face;
    };
    void insert_pieces();

    int width_, height_, cells_x_ = 1, cells_y_ = 1, cell_size_ = 1;
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> cell_begin_;   // cells + 1 places in cell_pieces_
    std::vector<std::uint32_t> cell_pieces_;  // piece numbers, cell by cell
};

}  // namespace relievo
