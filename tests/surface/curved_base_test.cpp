// The base mesh curved between its vertices, and that tools which make planes do not show its triangles.
#include "editor/session/surface/curved_base.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "brushes/sculptor.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/texel_triangle.h"
#include "test_meshes.h"

namespace relievo::curved_base_test {
namespace {

using namespace test;

TEST(CurvedBase, texels_of_a_sphere_of_few_triangles_lie_on_the_sphere) {
    const Mesh mesh = box_sphere(6, 6, 7);
    const HeightMap map(128, 128);
    const MeshSurface surface(mesh, displacement(0), map);
    std::vector<SurfaceTexel> fast, precise;
    surface.texels_in_ball({0, 0, 1}, 1.0f, fast);
    surface.precise_texels_in_ball({0, 0, 1}, 1.0f, precise);
    ASSERT_GT(fast.size(), 200u);
    ASSERT_EQ(fast.size(), precise.size());
    double flat = 0, curved = 0;
    for (std::size_t i = 0; i < fast.size(); ++i) {
        flat = std::max(flat, std::abs(double{glm::length(fast[i].position)} - 1));
        curved = std::max(curved, std::abs(double{glm::length(fast[i].shaded())} - 1));
        EXPECT_NEAR(fast[i].bulge, precise[i].bulge, 1e-6);
    }
    EXPECT_GT(flat, 0.01);
    EXPECT_LT(curved, 0.2 * flat);
}

TEST(CurvedBase, triangles_bulge_alike_along_the_edge_that_they_share) {
    const glm::dvec3 p0(0, 0, 0), p1(1, 0, 0.2), p2(0, 1, -0.3), p3(1.2, 0.9, 0);
    const glm::dvec3 n0(0, 0, 1), n1 = glm::normalize(glm::dvec3(0.5, 0, 1)),
                                  n2 = glm::normalize(glm::dvec3(0, -0.4, 1)),
                                  n3 = glm::normalize(glm::dvec3(1, 1, 1));
    const Bulge a({p0, p1, p2}, {n0, n1, n2}), b({p1, p3, p2}, {n1, n3, n2});
    for (const double t : {0.0, 0.25, 0.5, 0.9, 1.0})
        EXPECT_DOUBLE_EQ(a.at({0, 1 - t, t}), b.at({1 - t, 0, t}));
    const glm::dvec3 u(0.5, 0.3, 0.2), v(0.1, -0.05, -0.05);
    EXPECT_NEAR(4 * a.at(u) + 6 * a.mixed(u, v) + 9 * a.at(v), a.at(2.0 * u + 3.0 * v), 1e-15);
}

// The greatest angle in degrees between two shading normals (of a height over the base mesh, in the normals'
// own field) at texels of the faces within 0.4 of (0, 0, 1).
double spread_of_shading(const Mesh& mesh, const HeightMap& map, double amplitude) {
    const MapGrid grid{map.width(), map.height(), Wrap::repeat};
    std::vector<glm::dvec3> normals;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        std::array<glm::dvec3, 3> n;
        bool near = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = mesh.faces[face].position[i];
            n[i] = glm::dvec3(mesh.normals[vertex]);
            near = near && glm::length(mesh.positions[vertex] - glm::vec3(0, 0, 1)) < 0.4f;
        }
        if (!near) continue;
        const TexelTriangle triangle = texel_triangle(mesh, face, grid);
        const glm::dmat2x3 steps = space_from_texels(mesh, face, triangle);
        const glm::dmat2x3 slope_from_gradient = steps * glm::inverse(glm::transpose(steps) * steps);
        const glm::dmat2 edges(triangle.p[1] - triangle.p[0], triangle.p[2] - triangle.p[0]);
        for (std::int64_t y = triangle.rows().first; y <= triangle.rows().last; ++y)
            for (std::int64_t x = triangle.columns(y).first; x <= triangle.columns(y).last; ++x) {
                const int i = static_cast<int>(x), j = static_cast<int>(y);
                const glm::dvec2 b = glm::inverse(edges) * (glm::dvec2(i, j) - triangle.p[0]);
                const glm::dvec2 gradient(map.at(i + 1, j) - map.at(i - 1, j),
                                          map.at(i, j + 1) - map.at(i, j - 1));
                normals.push_back(
                    glm::normalize(glm::normalize(n[0] * (1 - b.x - b.y) + n[1] * b.x + n[2] * b.y) -
                                   slope_from_gradient * (gradient * amplitude / (2 * 65535.0))));
            }
    }
    EXPECT_GT(normals.size(), 200u);
    double least = 1;
    for (std::size_t i = 0; i < normals.size(); i += 7)
        for (std::size_t j = 0; j < i; j += 7) least = std::min(least, glm::dot(normals[i], normals[j]));
    return glm::degrees(std::acos(least));
}

TEST(CurvedBase, what_is_flattened_or_filled_with_clay_is_shaded_without_triangles) {
    const Mesh mesh = box_sphere(6, 6, 7);
    constexpr double kAmplitude = 0.6;
    for (const Tool tool : {Tool::flatten, Tool::clay}) {
        HeightMap map(1024, 1024, 32768);
        const MeshSurface surface(mesh, displacement(kAmplitude), map);
        Sculptor sculptor(map, surface);
        Brush brush;
        brush.tool = tool;
        brush.radius = 0.8f;
        brush.hardness = 0.8f;
        brush.strength = tool == Tool::flatten ? 1.0f : 0.3f;
        sculptor.begin(brush);
        const FacePoint at = surface.nearest_on_base(glm::dvec3(0.02, 0.01, 1));
        Dab dab;
        dab.face = at.face, dab.b1 = at.b1, dab.b2 = at.b2;
        for (int i = 0; i < 10; ++i) sculptor.dab(dab);
        sculptor.end();
        EXPECT_LT(spread_of_shading(mesh, map, kAmplitude), tool == Tool::flatten ? 4 : 3)
            << "19 and 15 over flat triangles";
    }
}

}  // namespace
}  // namespace relievo::curved_base_test
