// MeshSurface::at: points and normals of S.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "editor/session/surface/mesh_surface.h"
#include "test_meshes.h"

namespace relievo::point_test {
namespace {

using namespace test;

TEST(Point, neighbours_agree_along_a_shared_edge) {
    const Mesh mesh = plane();
    const HeightMap map = random_map(16, 16, 4);
    const MeshSurface surface(mesh, displacement(0.7, 0.3), map);
    // Face 0 is (0,0) (1,0) (1,1), face 1 is (0,0) (1,1) (0,1): the diagonal is b2 of one and b1 of the
    // other.
    for (int i = 0; i <= 64; ++i) {
        const float t = static_cast<float>(i) / 64;
        const SurfacePoint a = surface.at(0, 0, t), b = surface.at(1, t, 0);
        EXPECT_LT(glm::distance(a.position, b.position), 1e-6f);
    }
}

TEST(Point, a_texel_centre_has_the_texels_own_height) {
    const Mesh mesh = plane();
    const HeightMap map = random_map(8, 8, 4);
    const MeshSurface surface(mesh, displacement(2, 0.5), map);
    for (int y = 0; y < 8; ++y) {
        for (int x = y; x < 8; ++x) {  // face 0: position = (b1 + b2, b2)
            const float u = (static_cast<float>(x) + 0.5f) / 8, v = (static_cast<float>(y) + 0.5f) / 8;
            EXPECT_NEAR(static_cast<double>(surface.at(0, u - v, v).position.z),
                        2 * (map.at(x, y) / 65535.0 - 0.5), 1e-6);
        }
    }
}

TEST(Point, normal_is_that_of_finite_differences) {
    const Mesh mesh = box_sphere(3, 4, 5);
    const HeightMap map = random_map(64, 64, 6);
    for (const double amplitude : {0.05, -0.05, 1.5}) {
        const MeshSurface surface(mesh, displacement(amplitude), map);
        for (std::uint32_t face = 0; face < surface.face_count(); ++face) {
            constexpr float k = 1e-3f, b = 0.3f;
            // Bilinear patches have creases: a step across one is no measure.
            const auto point = [&](float b1, float b2) {
                return glm::dvec3(surface.at(face, b1, b2).position);
            };
            const glm::dvec3 forward =
                glm::cross(point(b + k, b) - point(b, b), point(b, b + k) - point(b, b));
            const glm::dvec3 backward =
                glm::cross(point(b, b) - point(b - k, b), point(b, b) - point(b, b - k));
            if (glm::dot(glm::normalize(forward), glm::normalize(backward)) < 0.9999) continue;
            const glm::dvec3 normal(surface.at(face, b, b).normal);
            EXPECT_GT(std::abs(glm::dot(glm::normalize(forward), normal)), 0.995) << face;
        }
    }
}

TEST(Point, normal_points_to_the_base_normals_side_on_mirrored_texture_and_negative_amplitude) {
    for (unsigned order = 0; order < 8; ++order) {
        const Mesh mesh = box_sphere(3, 4, 5, order);
        const HeightMap map = random_map(32, 32, 6);
        const MeshSurface surface(mesh, displacement(order % 2 ? 0.1 : -0.1), map);
        for (std::uint32_t face = 0; face < surface.face_count(); ++face) {
            const SurfacePoint p = surface.at(face, 0.25f, 0.25f);
            EXPECT_GT(glm::dot(p.normal, p.position), 0) << face;
            EXPECT_NEAR(static_cast<double>(glm::length(p.normal)), 1, 1e-5);
        }
    }
}

TEST(Point, degenerate_faces_give_unit_normals) {
    MeshBuilder builder;
    const MeshBuilder::Corner a{{0, 0, 0}, {0, 0}}, b{{1, 0, 0}, {1, 0}};
    builder.triangle(a, a, a);
    builder.triangle(a, b, b);
    builder.triangle(a, b, {{1, 1, 0}, {0, 0}});
    builder.triangle(a, {{1e-30f, 0, 0}, {1, 0}}, {{0, 1e-30f, 0}, {1, 1}});
    Mesh mesh = builder.build();
    const HeightMap map = random_map(4, 4, 1);
    for (int pass = 0; pass < 2; ++pass) {
        for (const double amplitude : {0.0, 0.5, 1e-6, -20.0}) {
            const MeshSurface surface(mesh, displacement(amplitude), map);
            for (std::uint32_t face = 0; face < surface.face_count(); ++face) {
                for (const float t : {0.0f, 0.3f, 1.0f}) {
                    const SurfacePoint p = surface.at(face, t, 0);
                    EXPECT_NEAR(static_cast<double>(glm::length(p.normal)), 1, 1e-5);
                    EXPECT_TRUE(std::isfinite(p.position.x + p.position.y + p.position.z));
                }
            }
        }
        for (glm::vec3& normal : mesh.normals) normal = glm::vec3(0);  // not even a normal to fall back on
    }
}

}  // namespace
}  // namespace relievo::point_test
