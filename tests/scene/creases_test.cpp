// Edges and their faces, and the bevel of sharp creases.
#include "renderer/scene/creases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "renderer/scene/mesh_topology.h"

namespace relievo::creases_test {
namespace {

using Indices = std::vector<std::array<std::uint32_t, 3>>;

glm::dvec2 uv_at(const glm::dvec3& p) {
    return {p.x / 4 + 0.5, p.y / 4 + 0.5 + p.z / 16};
}

// A mesh with one uv a position.
Mesh mesh_of(const std::vector<glm::dvec3>& positions, const Indices& faces) {
    MeshFile file;
    file.positions = positions;
    for (const glm::dvec3& p : positions) file.uvs.push_back(uv_at(p));
    for (const auto& face : faces) file.faces.push_back({face, face});
    return make_mesh(file, glm::dmat4(1), glm::dvec3(0), false);
}

// Two triangles on the edge from (0, 0, 0) to (0, 1, 0), opened by `degrees`, solid between them.
Mesh wedge(double degrees) {
    const double half = glm::radians(degrees) / 2;
    return mesh_of({{0, 0, 0},
                    {0, 1, 0},
                    {-std::cos(half), 0.5, std::sin(half)},
                    {-std::cos(half), 0.5, -std::sin(half)}},
                   {{0, 1, 2}, {1, 0, 3}});
}

// A closed prism whose cross section is a triangle with a tip of `degrees` at x = 0; `segments` along the
// tip.
Mesh blade(double degrees, std::uint32_t segments) {
    const double half = glm::radians(degrees) / 2;
    std::vector<glm::dvec3> positions;
    for (std::uint32_t i = 0; i <= segments; ++i) {
        const double y = static_cast<double>(i) / segments;
        positions.insert(
            positions.end(),
            {{0, y, 0}, {-std::cos(half), y, std::sin(half)}, {-std::cos(half), y, -std::sin(half)}});
    }
    Indices faces = {{0, 1, 2}, {3 * segments, 3 * segments + 2, 3 * segments + 1}};
    for (std::uint32_t i = 0; i < segments; ++i) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = 3 * i + k, b = 3 * i + (k + 1) % 3;
            faces.push_back({a, a + 3, b});
            faces.push_back({b, a + 3, b + 3});
        }
    }
    return mesh_of(positions, faces);
}

glm::dvec3 face_normal(const Mesh& mesh, const Mesh::Face& face) {
    const auto at = [&](int k) {
        return glm::dvec3(mesh.positions[face.position[static_cast<std::size_t>(k)]]);
    };
    return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
}

// The least N_i . Ng over all corners.
double least_cosine(const Mesh& mesh) {
    double least = 1;
    for (const Mesh::Face& face : mesh.faces) {
        for (const std::uint32_t p : face.position) {
            least = std::min(least, glm::dot(glm::dvec3(mesh.normals[p]), face_normal(mesh, face)));
        }
    }
    return least;
}

double volume(const Mesh& mesh) {
    double sum = 0;
    for (const Mesh::Face& f : mesh.faces) {
        const glm::dvec3 a(mesh.positions[f.position[0]]), b(mesh.positions[f.position[1]]),
            c(mesh.positions[f.position[2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

bool is_closed(const Mesh& mesh) {
    const MeshTopology topology = find_edges(mesh);
    return std::all_of(topology.edges.begin(), topology.edges.end(),
                       [](const MeshEdge& e) { return e.is_manifold(); });
}

TEST(MeshTopology, borders_shared_edges_and_non_manifold_ones) {
    const Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                              {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}, {0, 0, 1}});
    const MeshTopology topology = find_edges(mesh);
    ASSERT_EQ(topology.edges.size(), 7u);
    EXPECT_EQ(topology.edges[0].p0, 0u);
    EXPECT_EQ(topology.edges[0].p1, 1u);
    EXPECT_EQ(topology.edges[0].side_count, 5u);  // the face that names position 0 twice runs there and back
    EXPECT_FALSE(topology.edges[0].is_manifold());
    for (std::size_t i = 1; i < 7; ++i) EXPECT_TRUE(topology.edges[i].is_border());
    EXPECT_EQ(topology.face_edges[9], MeshTopology::kNoEdge);
    EXPECT_EQ(topology.face_edges[0], 0u);
}

TEST(MeshTopology, neighbours_of_one_orientation_and_of_two) {
    const std::vector<glm::dvec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    EXPECT_TRUE(find_edges(mesh_of(positions, {{0, 1, 2}, {1, 0, 3}})).edges[0].is_manifold());
    EXPECT_FALSE(find_edges(mesh_of(positions, {{0, 1, 2}, {0, 1, 3}})).edges[0].is_manifold());
    EXPECT_TRUE(is_closed(blade(60, 2)));
    EXPECT_TRUE(find_edges(Mesh{}).edges.empty());
}

TEST(Creases, wedge_of_2_degrees_gets_two_triangles_and_usable_normals) {
    const Mesh mesh = wedge(2);
    EXPECT_LT(least_cosine(mesh), 0.02);
    const MendedMesh mended = mend_creases(mesh);
    EXPECT_EQ(mended.mended_edges, 1u);
    ASSERT_EQ(mended.mesh.faces.size(), 4u);
    EXPECT_EQ(mended.original_face, (std::vector<std::uint32_t>{0, 1, 0, 0}));
    EXPECT_GT(least_cosine(mended.mesh), 0.35);
    for (const std::size_t strip : {2u, 3u})
        EXPECT_GT(face_normal(mended.mesh, mended.mesh.faces[strip]).x, 0.99);
    // The inset: 1/32 of the height, in position and uv alike.
    const glm::vec3 p = mended.mesh.positions[mended.mesh.faces[0].position[0]];
    EXPECT_NEAR(static_cast<double>(p.x), -kCreaseInset * std::cos(glm::radians(1.0)), 1e-7);
    EXPECT_EQ(p.y, 0.0f);
    for (const Mesh::Face& face : mended.mesh.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 want = uv_at(glm::dvec3(mended.mesh.positions[face.position[k]]));
            EXPECT_NEAR(glm::length(glm::dvec2(mended.mesh.uvs[face.uv[k]]) - want), 0, 1e-7);
        }
    }
    EXPECT_EQ(mended.mesh.sphere_radius, mesh.sphere_radius);
}

TEST(Creases, closed_blades_stay_closed) {
    for (const std::uint32_t segments : {1u, 2u, 5u}) {
        for (const double degrees : {0.1, 2.0, 4.9}) {
            const Mesh mesh = blade(degrees, segments);
            const MendedMesh mended = mend_creases(mesh);
            SCOPED_TRACE(segments);
            EXPECT_EQ(mended.mended_edges, segments);
            EXPECT_TRUE(is_closed(mended.mesh));
            EXPECT_EQ(mended.mesh.faces.size(), mended.original_face.size());
            EXPECT_NEAR(volume(mended.mesh) / volume(mesh), 1, 0.08);
            // No face looks inside, and the crease's copies fit the faces along it and the strip.
            for (const Mesh::Face& face : mended.mesh.faces) {
                const glm::dvec3 normal = face_normal(mended.mesh, face);
                EXPECT_TRUE(std::abs(normal.y) > 0.99 || std::abs(normal.y) < 0.01);
                EXPECT_TRUE(normal.x > -0.01 || normal.x < -0.99);
                for (const std::uint32_t p : face.position) {
                    if (p < mesh.positions.size() || std::abs(normal.y) > 0.5) continue;
                    EXPECT_GT(glm::dot(glm::dvec3(mended.mesh.normals[p]), normal), 0.6);
                }
            }
        }
    }
}

TEST(Creases, wider_edges_and_concave_folds_are_untouched) {
    for (const Mesh& mesh :
         {wedge(6), blade(6, 2),
          mesh_of({{0, 0, 0}, {0, 1, 0}, {-1, 0.5, 0.01}, {-1, 0.5, -0.01}}, {{1, 0, 2}, {0, 1, 3}})}) {
        const MendedMesh mended = mend_creases(mesh);
        EXPECT_EQ(mended.mended_edges, 0u);
        EXPECT_EQ(mended.mesh.positions.size(), mesh.positions.size());
        ASSERT_EQ(mended.original_face.size(), mesh.faces.size());
        EXPECT_EQ(mended.original_face.back(), mesh.faces.size() - 1);
    }
    EXPECT_EQ(mend_creases(wedge(6), 10).mended_edges, 1u);
    EXPECT_EQ(mend_creases(wedge(2), 0).mended_edges, 0u);
}

TEST(Creases, non_manifold_edges_and_double_sided_triangles_are_left_alone) {
    Mesh mesh = wedge(2);
    mesh.positions.push_back({1, 0.5f, 0});
    mesh.normals.push_back({0, 0, 1});
    mesh.faces.push_back({{0, 1, 4}, {0, 1, 2}});
    EXPECT_EQ(mend_creases(mesh).mended_edges, 0u);
    EXPECT_EQ(mend_creases(mesh).mesh.faces.size(), 3u);
    const Mesh both_sides = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
    EXPECT_EQ(mend_creases(both_sides).mended_edges, 0u);
    EXPECT_EQ(mend_creases(Mesh{}).mended_edges, 0u);
}

TEST(Creases, fold_of_0_degrees_gives_no_nan) {
    const Mesh mesh = mesh_of({{0, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {-1, 0.4, 0}}, {{0, 1, 2}, {1, 0, 3}});
    const MendedMesh mended = mend_creases(mesh);
    EXPECT_EQ(mended.mended_edges, 1u);
    for (const glm::vec3& n : mended.mesh.normals) EXPECT_NEAR(static_cast<double>(glm::length(n)), 1, 1e-6);
    for (const glm::vec3& p : mended.mesh.positions) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
}

TEST(Creases, strip_across_a_texture_seam_stays_in_one_island) {
    Mesh mesh = wedge(2);
    const auto first = static_cast<std::uint32_t>(mesh.uvs.size());
    mesh.uvs.insert(mesh.uvs.end(), {{8, 8}, {8, 9}, {9, 9}});
    mesh.faces[1].uv = {first, first + 1, first + 2};
    const MendedMesh mended = mend_creases(mesh);
    ASSERT_EQ(mended.mesh.faces.size(), 4u);
    for (const std::size_t strip : {2u, 3u}) {
        for (const std::uint32_t uv : mended.mesh.faces[strip].uv) EXPECT_LT(mended.mesh.uvs[uv].x, 2.0f);
    }
    for (const std::uint32_t uv : mended.mesh.faces[1].uv) EXPECT_GT(mended.mesh.uvs[uv].x, 7.0f);
}

}  // namespace
}  // namespace relievo::creases_test
