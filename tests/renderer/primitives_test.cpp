// Prisms hold their part of the surface: no sampled point leaves the box or the height range.
#include "renderer/surface_hull.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/scenes.h"

namespace relievo::test::primitives_test {
namespace {

Mesh random_triangle(std::mt19937& rng, double spread) {
    std::uniform_real_distribution<double> u(-1, 1);
    MeshFile m;
    for (int i = 0; i < 3; ++i) m.positions.push_back({u(rng), u(rng), u(rng)});
    const glm::dvec3 ng = glm::normalize(glm::cross(m.positions[1] - m.positions[0], m.positions[2] - m.positions[0]));
    for (int i = 0; i < 3; ++i)
        m.file_normals.push_back(glm::normalize(ng + glm::dvec3(u(rng), u(rng), u(rng)) * spread));
    m.uvs = {{u(rng), u(rng)}, {u(rng), u(rng)}, {u(rng), u(rng)}};
    m.faces = {{{0, 1, 2}, {0, 1, 2}}};
    return make_mesh(m, glm::dmat4(1), {}, true);
}

TEST(Primitives, BoxHoldsEveryPointOfTheOffsetSurface) {
    std::mt19937 rng(7);
    std::uniform_real_distribution<double> u(0, 1);
    for (int round = 0; round < 2000; ++round) {
        const Mesh mesh = random_triangle(rng, 0.5);
        auto p = make_primitive(mesh, 0, 0, {{64, 32}});
        ASSERT_TRUE(p);
        const double a = u(rng) - 0.5, b = u(rng) - 0.5;
        set_heights(*p, {std::min(a, b), std::max(a, b)});
        const Box box = prism_box(*p);
        for (int i = 0; i < 50; ++i) {
            double b1 = u(rng), b2 = u(rng);
            if (b1 + b2 > 1) { b1 = 1 - b1; b2 = 1 - b2; }
            const double d = std::min(a, b) + std::abs(a - b) * u(rng);
            // A point at height d along M(b), the projection direction of parallel offset prisms.
            const glm::vec2 shift = p->shift0 * float(1 - b1 - b2) + p->shift1 * float(b1) + p->shift2 * float(b2);
            const float w = float(d) / std::sqrt(1 + glm::dot(shift, shift));
            ASSERT_GE(w, p->w_low);
            ASSERT_LE(w, p->w_high);
            const glm::vec2 q = glm::vec2(p->q1x, 0) * float(b1) + p->q2 * float(b2) + shift * w;
            const glm::vec3 point = p->origin + p->tangent * q.x + glm::cross(p->ng, p->tangent) * q.y + p->ng * w;
            for (int k = 0; k < 3; ++k) {
                ASSERT_GE(point[k], box.low[k]);
                ASSERT_LE(point[k], box.high[k]);
            }
        }
    }
}

TEST(Primitives, BoxHoldsEveryPointOfTheCanonicalSurface) {
    std::mt19937 rng(8);
    std::uniform_real_distribution<double> u(0, 1);
    for (int round = 0; round < 4000; ++round) {
        const Mesh mesh = random_triangle(rng, round % 2 == 0 ? 0.5 : 1.2);
        auto p = make_primitive(mesh, 0, 0, {{64, 32}});
        ASSERT_TRUE(p);
        const Mesh::Face& f = mesh.faces[0];
        glm::dvec3 q[3], n[3];
        for (std::size_t i = 0; i < 3; ++i) {
            q[i] = mesh.positions[f.position[i]];
            n[i] = mesh.normals[f.position[i]];
        }
        const double a = (u(rng) - 0.5) * 2, b = (u(rng) - 0.5) * 2;
        const DisplacementRange range{std::min(a, b), std::max(a, b)};
        set_shell(*p, primitive_normals(mesh, 0), range);
        const Box box = surface_box(*p, primitive_normals(mesh, 0), range);
        for (int i = 0; i < 60; ++i) {
            double b1 = u(rng), b2 = u(rng);
            if (b1 + b2 > 1) b1 = 1 - b1, b2 = 1 - b2;
            const double d = i % 3 == 0 ? a : i % 3 == 1 ? b : a + (b - a) * u(rng);
            const glm::dvec3 point = q[0] * (1 - b1 - b2) + q[1] * b1 + q[2] * b2 +
                                     glm::normalize(n[0] * (1 - b1 - b2) + n[1] * b1 + n[2] * b2) * d;
            for (int k = 0; k < 3; ++k) {
                ASSERT_GE(point[k], double{box.low[k]}) << round;
                ASSERT_LE(point[k], double{box.high[k]}) << round;
            }
        }
    }
}

TEST(Primitives, TexelCoordinatesKeepTheirFractionsOnLargeMaps) {
    MeshFile m = plane_mesh();
    for (auto& uv : m.uvs) uv = uv / 1000.0 + glm::dvec2(0.875);
    const Mesh mesh = make_mesh(m, glm::dmat4(1), {}, false);
    const auto p = make_primitive(mesh, 0, 0, {{16384, 16384}});
    ASSERT_TRUE(p);
    EXPECT_LT(p->tx0.x, 1);
    EXPECT_LT(p->tx1.x, 18);
    EXPECT_EQ(p->base & 0xffffu, static_cast<unsigned>(std::floor(0.875 * 16384 - 0.5)));
}

TEST(Primitives, ZeroAreaFacesAreNoPrimitives) {
    MeshFile m = plane_mesh();
    m.faces = {{{0, 1, 1}, {0, 1, 1}}};
    EXPECT_FALSE(make_primitive(make_mesh(m, glm::dmat4(1), {}, false), 0, 0, {{4, 4}}));
}

TEST(Primitives, SpatialOrderIsAPermutation) {
    std::mt19937 rng(3);
    std::uniform_real_distribution<float> u(0, 1);
    std::vector<Box> boxes;
    for (int i = 0; i < 1001; ++i) {
        const glm::vec3 p(u(rng), u(rng), u(rng));
        boxes.push_back({p, p});
    }
    auto order = spatial_order(boxes);
    std::sort(order.begin(), order.end());
    for (std::uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
}

}  // namespace
}  // namespace relievo::test::primitives_test
