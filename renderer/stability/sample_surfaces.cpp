// See sample_surfaces.h.
#include "renderer/stability/sample_surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace relievo::stability {

using glm::dvec2;
using glm::dvec3;

ReferenceObject SampleSurface::object() const {
    ReferenceObject object{&mesh, amplitude, midlevel, wrap, {width, height, texels.data()}, {}};
    if (!opacity.empty())
        object.opacity = {opacity_width, static_cast<int>(opacity.size()) / opacity_width, opacity.data()};
    object.procedural = procedural;
    return object;
}

SceneObject SampleSurface::scene_object() const {
    SceneObject object;
    object.displacement.amplitude = amplitude;
    object.displacement.midlevel = midlevel;
    object.displacement.wrap = wrap;
    object.displacement.procedural = procedural;
    object.mesh = mesh;
    return object;
}

ReferenceSurface SampleSurface::reference() const {
    const ReferenceObject one = object();
    return ReferenceSurface({&one, 1});
}

void SampleSurface::paint(int w, int h, const std::function<double(int, int)>& value) {
    width = w;
    height = h;
    texels.clear();
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x)
            texels.push_back(
                static_cast<std::uint16_t>(std::lround(std::clamp(value(x, y), 0.0, 1.0) * 65535)));
    }
}

namespace {

Mesh from_file(const MeshFile& file, bool file_normals) {
    return make_mesh(file, glm::dmat4(1), dvec3(0), file_normals);
}

// Rings of `columns` vertices between two poles; `place` gives the position of a latitude and longitude in
// [0, 1].
MeshFile lat_long(int columns, int rows, const std::function<dvec3(double, double)>& place) {
    MeshFile file;
    const auto vertex = [&](int x, int y) {
        if (y == 0) return 0u;
        if (y == rows) return 1u;
        return static_cast<std::uint32_t>(2 + (y - 1) * columns + x % columns);
    };
    const auto uv = [&](int x, int y) { return static_cast<std::uint32_t>(y * (2 * columns + 1) + x); };
    file.positions.push_back(place(0, 0));
    file.positions.push_back(place(0, 1));
    for (int y = 1; y < rows; ++y) {
        for (int x = 0; x < columns; ++x)
            file.positions.push_back(place(static_cast<double>(x) / columns, static_cast<double>(y) / rows));
    }
    for (int y = 0; y <= rows; ++y) {
        for (int x = 0; x <= 2 * columns; ++x)
            file.uvs.emplace_back(x / (2.0 * columns), static_cast<double>(y) / rows);
    }
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            // At a pole the corner stands over the middle of the opposite side.
            const int low_x = y == 0 ? 2 * x + 1 : 2 * x, high_x = y + 1 == rows ? 2 * x + 1 : 2 * x;
            if (y > 0)
                file.faces.push_back(
                    {{vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)},
                     {uv(2 * x, y), uv(2 * x + 2, y), uv(y + 1 == rows ? high_x : 2 * x + 2, y + 1)}});
            if (y + 1 < rows)
                file.faces.push_back({{vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)},
                                      {uv(low_x, y), uv(2 * x + 2, y + 1), uv(2 * x, y + 1)}});
        }
    }
    return file;
}

dvec3 on_sphere(double u, double v) {
    const double longitude = 2 * std::numbers::pi * u, latitude = std::numbers::pi * (v - 0.5);
    if (v == 0 || v == 1) return {0, 0, v == 0 ? -1.0 : 1.0};
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
            std::sin(latitude)};
}

}  // namespace

Mesh plane_mesh(double scale, double shift) {
    MeshFile file;
    for (const dvec2& corner : {dvec2(0, 0), dvec2(1, 0), dvec2(1, 1), dvec2(0, 1)}) {
        file.positions.emplace_back(corner, 0);
        file.file_normals.emplace_back(0, 0, 1);
        file.uvs.push_back(corner * scale + shift);
    }
    file.faces = {{{0, 1, 2}, {0, 1, 2}}, {{0, 2, 3}, {0, 2, 3}}};
    return from_file(file, true);
}

Mesh ball_mesh(int columns, int rows, double radius) {
    MeshFile file = lat_long(columns, rows, [&](double u, double v) { return on_sphere(u, v) * radius; });
    for (const dvec3& p : file.positions) file.file_normals.push_back(glm::normalize(p));
    return from_file(file, true);
}

Mesh lump_mesh() {
    MeshFile file = lat_long(5, 4, on_sphere);
    std::uint32_t i = 0;
    for (dvec3& p : file.positions) p *= 0.6 + 0.8 * hash01(i++, 7, 1);
    return from_file(file, false);
}

Mesh triangle_mesh(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& na, const dvec3& nb,
                   const dvec3& nc) {
    MeshFile file;
    file.positions = {a, b, c};
    file.file_normals = {glm::normalize(na), glm::normalize(nb), glm::normalize(nc)};
    file.uvs = {{0, 0}, {1, 0}, {0, 1}};
    file.faces = {{{0, 1, 2}, {0, 1, 2}}};
    return from_file(file, true);
}

double dunes(double u, double v) {
    constexpr double kTurn = 2 * std::numbers::pi;
    return 0.5 + 0.2 * std::sin(kTurn * (3 * u + std::sin(kTurn * v) * 0.3)) +
           0.15 * std::cos(kTurn * (2 * v - 4 * u)) + 0.1 * std::sin(kTurn * 7 * v) * std::cos(kTurn * 5 * u);
}

double ball_dunes(double u, double v) {
    const double fade = std::clamp(2 * std::sin(std::numbers::pi * v) - 0.45, 0.0, 1.0);
    return 0.5 + fade * (dunes(u, v) - 0.5);
}

double hash01(std::uint32_t a, std::uint32_t b, std::uint32_t seed) {
    std::uint32_t h = a * 0x9e3779b1u ^ (b + 0x7f4a7c15u) * 0x85ebca77u ^ (seed + 1u) * 0xc2b2ae3du;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return (h >> 8) * (1.0 / 16777216.0);
}

}  // namespace relievo::stability
