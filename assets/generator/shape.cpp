// Triangles of an island mesh, their normals, and the OBJ file.
#include "assets/generator/shape.h"

#include <cstdio>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace relievo::assets {
namespace {

void append_number(std::string& text, double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, " %.9g", value);  // enough to give every float back
    text += digits;
}

void append_vector(std::string& text, const char* key, const glm::dvec3& v) {
    text += key;
    for (int i = 0; i < 3; ++i) append_number(text, v[i] == 0.0 ? 0.0 : v[i]);  // no "-0"
    text += '\n';
}

void append_cell(std::vector<Triangle>& out, const Island& island, int column, int row) {
    const int corner[4][2] = {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}};
    const int first = (column + row) & 1;  // where the diagonal starts
    for (const int k : {0, 1}) {
        Triangle t{};
        for (int i = 0; i < 3; ++i) {
            const int* c = corner[(first + (i == 0 ? 0 : i + k)) & 3];
            const auto slot = static_cast<std::size_t>(i);
            t.position[slot] = island.vertex(c[0], c[1]);
            t.uv[slot] = island.map_from_local({c[0] * island.cell_w, c[1] * island.cell_h});
        }
        out.push_back(t);
    }
}

}  // namespace

void Shape::add_island(Island island, const std::function<std::uint32_t(int, int)>& vertex) {
    for (int row = 0; row <= island.rows; ++row)
        for (int column = 0; column <= island.columns; ++column)
            island.vertices.push_back(vertex(column, row));
    islands.push_back(std::move(island));
}

std::vector<Triangle> Shape::triangles() const {
    std::vector<Triangle> all;
    for (const Island& island : islands)
        for (int row = 0; row < island.rows; ++row)
            for (int column = 0; column < island.columns; ++column) append_cell(all, island, column, row);
    all.insert(all.end(), free_triangles.begin(), free_triangles.end());
    return all;
}

void Shape::make_normals() {
    normals.assign(positions.size(), glm::dvec3(0));
    for (const Triangle& t : triangles()) {
        const glm::dvec3 a = positions[t.position[0]];
        const glm::dvec3 area = glm::cross(positions[t.position[1]] - a, positions[t.position[2]] - a);
        for (const std::uint32_t p : t.position) normals[p] += area;
    }
    for (glm::dvec3& n : normals) n = glm::normalize(n);
}

void write_obj(const Shape& shape, const std::filesystem::path& path) {
    std::string text = "# Relievo sample asset: made by relievo_assets\n";
    for (const glm::dvec3& p : shape.positions) append_vector(text, "v", p);
    for (const glm::dvec3& n : shape.normals) append_vector(text, "vn", n);

    std::map<std::pair<double, double>, std::size_t> uv_index;
    std::string faces;
    for (const Triangle& t : shape.triangles()) {
        faces += 'f';
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [at, added] = uv_index.try_emplace({t.uv[i].x, t.uv[i].y}, uv_index.size() + 1);
            if (added) {
                text += "vt";
                append_number(text, t.uv[i].x / kLattice);
                append_number(text, t.uv[i].y / kLattice);
                text += '\n';
            }
            const std::string p = std::to_string(t.position[i] + 1);
            faces += ' ' + p + '/' + std::to_string(at->second) + '/' + p;
        }
        faces += '\n';
    }
    std::ofstream file(path, std::ios::binary);
    file << text << faces;
    file.close();
    if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace relievo::assets
