// See micro_mesh.h.
#include "renderer/micro_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace relievo {
namespace {

using glm::dvec2;
using glm::dvec3;

std::uint32_t segments_for(double texels, double density) {
    const double wanted = std::ceil(texels * density - 1e-9);
    return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, double{MicroMesh::kMostSegments}));
}

// Corners lie row by row along b2.
std::uint32_t index_of(std::uint32_t i, std::uint32_t j, std::uint32_t segments) {
    return j * (segments + 1) - j * (j - 1) / 2 + i;
}

// Where corner k of n along an edge stands on an edge of `coarse` segments. `turned`: the edge is counted
// from its other end, so that both its sides round alike.
std::uint32_t snapped(std::uint32_t k, std::uint32_t n, std::uint32_t coarse, bool turned) {
    const std::uint32_t from = turned ? n - k : k;
    const std::uint32_t place = (2 * from * coarse + n) / (2 * n);
    return turned ? coarse - place : place;
}

}  // namespace

MicroMesh::MicroMesh(const Mesh& mesh, const TexelAt& texel_at, double density) : mesh_(mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> segments;
    const auto edge_of = [](const Mesh::Face& f, std::size_t i) -> std::pair<std::uint32_t, std::uint32_t> {
        return std::minmax({f.position[(i + 1) % 3], f.position[(i + 2) % 3]});
    };
    for (const Mesh::Face& f : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i) {
            const dvec2 a = texel_at(mesh.uvs[f.uv[(i + 1) % 3]]), b = texel_at(mesh.uvs[f.uv[(i + 2) % 3]]);
            std::uint32_t& most = segments[edge_of(f, i)];
            most = std::max(most, segments_for(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)), density));
        }
    for (const Mesh::Face& f : mesh.faces) {
        std::array<std::uint32_t, 3> edges{};
        for (std::size_t i = 0; i < 3; ++i) edges[i] = segments.at(edge_of(f, i));
        of_edge_.push_back(edges);
        segments_.push_back(*std::max_element(edges.begin(), edges.end()));
    }
}

std::uint64_t MicroMesh::triangles() const {
    std::uint64_t sum = 0;
    for (const std::uint32_t n : segments_) sum += std::uint64_t{n} * n;
    return sum;
}

std::uint32_t MicroMesh::vertices_of(std::uint32_t face) const {
    const std::uint32_t n = segments_[face];
    return (n + 1) * (n + 2) / 2;
}

MicroMesh::Corner MicroMesh::corner(std::uint32_t face, std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t n = segments_[face];
    const auto& position = mesh_.faces[face].position;
    const auto on_edge = [&](std::size_t opposite,
                             std::uint32_t k) {  // k from the edge's first end in cyclic order
        const bool turned = position[(opposite + 1) % 3] > position[(opposite + 2) % 3];
        return snapped(k, n, of_edge_[face][opposite], turned);
    };
    if (i + j == n) {
        const std::uint32_t of = of_edge_[face][0], place = on_edge(0, j);
        return {of - place, place, of};
    }
    if (i == 0) {
        const std::uint32_t of = of_edge_[face][1], place = on_edge(1, n - j);
        return {0, of - place, of};
    }
    if (j == 0) return {on_edge(2, i), 0, of_edge_[face][2]};
    return {i, j, n};
}

void MicroMesh::place(std::uint32_t face, const DisplacementAt& displacement,
                      std::span<gpu::MicroVertex> vertices) const {
    const Mesh::Face& f = mesh_.faces[face];
    const std::uint32_t n = segments_[face];
    // Sums in the positions' order: both sides of an edge round alike.
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return f.position[a] < f.position[b]; });
    std::size_t next = 0;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i + j <= n; ++i) {
            const Corner c = corner(face, i, j);
            const std::array<double, 3> b{static_cast<double>(c.of - c.b1 - c.b2) / c.of,
                                          static_cast<double>(c.b1) / c.of, static_cast<double>(c.b2) / c.of};
            dvec3 point(0), normal(0);
            dvec2 uv(0);
            for (const std::size_t k : order) {
                point += b[k] * dvec3(mesh_.positions[f.position[k]]);
                normal += b[k] * dvec3(mesh_.normals[f.position[k]]);
                uv += b[k] * dvec2(mesh_.uvs[f.uv[k]]);
            }
            const double length = glm::length(normal);  // 0 where normals cancel: S has no place there
            if (length > 0) point += normal * (displacement(uv) / length);
            vertices[next++] = {glm::vec3(point), glm::vec2(b[1], b[2])};
        }
}

void MicroMesh::connect(std::uint32_t face, std::uint32_t first, std::uint32_t primitive,
                        std::vector<MicroTriangle>& triangles) const {
    const std::uint32_t n = segments_[face];
    const auto same = [](const Corner& a, const Corner& b) {
        return std::uint64_t{a.b1} * b.of == std::uint64_t{b.b1} * a.of &&
               std::uint64_t{a.b2} * b.of == std::uint64_t{b.b2} * a.of;
    };
    const auto add = [&](std::array<glm::uvec2, 3> at) {
        std::array<Corner, 3> c{};
        glm::uvec3 vertex(0);
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = corner(face, at[k].x, at[k].y);
            vertex[static_cast<int>(k)] = first + index_of(at[k].x, at[k].y, n);
        }
        if (same(c[0], c[1]) || same(c[1], c[2]) || same(c[2], c[0])) return;
        triangles.push_back({vertex, primitive});
    };
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i + j < n; ++i) {
            add({glm::uvec2(i, j), {i + 1, j}, {i, j + 1}});
            if (i + j + 1 < n) add({glm::uvec2(i + 1, j), {i + 1, j + 1}, {i, j + 1}});
        }
}

}  // namespace relievo
