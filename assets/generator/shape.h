// A base mesh made of rectangular islands of square cells, laid out on a lattice of 256 x 256 units over the
// map. Island borders on lattice lines are texel borders of every map whose side is a multiple of 256; both
// sides of a seam run along u or v at one scale. So the texel outside an island's border and the texel inside
// its neighbour's are the same surface point, and a seam can be exact under bilinear filtering.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace relievo::assets {

inline constexpr int kLattice = 256;  // lattice units a side of the map
inline constexpr int kGap = 4;        // least distance between islands, lattice units

struct Island {
    int columns, rows;    // cells; columns x rows is counter-clockwise seen from outside
    int x, y;             // lower left corner in the map, lattice units
    int cell_w, cell_h;   // one cell along the columns and along the rows, lattice units
    bool turned = false;  // by 90 degrees counter-clockwise in the map: columns run along +v, rows along -u
    std::vector<std::uint32_t> vertices = {};  // (columns + 1) * (rows + 1) positions, row by row

    int width() const { return columns * cell_w; }  // along the columns, lattice units
    int height() const { return rows * cell_h; }    // along the rows
    std::uint32_t vertex(int column, int row) const {
        return vertices[static_cast<std::size_t>(row * (columns + 1) + column)];
    }
    // From coordinates along columns and rows (lattice units from the island's corner) to the map, and back.
    // Exact.
    glm::dvec2 map_from_local(glm::dvec2 p) const {
        return turned ? glm::dvec2(x + height() - p.y, y + p.x) : glm::dvec2(x + p.x, y + p.y);
    }
    glm::dvec2 local_from_map(glm::dvec2 m) const {
        return turned ? glm::dvec2(m.y - y, height() - (m.x - x)) : glm::dvec2(m.x - x, m.y - y);
    }
};

struct Triangle {
    std::array<std::uint32_t, 3> position;
    std::array<glm::dvec2, 3> uv;  // lattice units
};

struct Shape {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;  // unit, one a position
    std::vector<Island> islands;
    std::vector<Triangle> free_triangles;  // of islands that are no rectangle, already in the map's lattice
    bool rows_continue =
        false;  // the islands' last rows meet free triangles: heights are asked beyond them too

    // Adds an island whose vertex (column, row) is position `vertex(column, row)`.
    void add_island(Island island, const std::function<std::uint32_t(int, int)>& vertex);

    // All triangles, island after island, then the free ones. A cell's diagonals alternate.
    std::vector<Triangle> triangles() const;

    // Area-weighted over all triangles at a position.
    void make_normals();
};

// Wavefront OBJ with one normal a position. Throws std::runtime_error that names the file when it cannot be
// written.
void write_obj(const Shape& shape, const std::filesystem::path& path);

}  // namespace relievo::assets
