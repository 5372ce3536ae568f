// make_mesh: normals, transforms, rebasing, bounds.
#include "renderer/scene/mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "tests/scene/test_files.h"

namespace relievo::mesh_test {
namespace {

MeshFile mesh_of(std::vector<glm::dvec3> positions, const std::vector<std::array<std::uint32_t, 3>>& faces) {
    MeshFile file;
    file.path = "test.obj";
    file.positions = std::move(positions);
    file.uvs = {{0, 0}, {1, 0}, {0, 1}};
    for (const auto& face : faces) file.faces.push_back({face, {0, 1, 2}});
    return file;
}

glm::dvec3 geometric_normal(const Mesh& mesh, const Mesh::Face& face) {
    const glm::dvec3 a(mesh.positions[face.position[0]]), b(mesh.positions[face.position[1]]),
        c(mesh.positions[face.position[2]]);
    return glm::normalize(glm::cross(b - a, c - a));
}

MeshFile tetrahedron() {
    return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

TEST(Mesh, normals_are_weighted_by_area) {
    // A large face in z = 0 and a small one in x = 0 share an edge.
    const Mesh mesh =
        make_mesh(mesh_of({{0, 0, 0}, {0, 1, 0}, {-3, 0, 0}, {0, 0, -1}}, {{0, 1, 2}, {0, 3, 1}}),
                  glm::dmat4(1), glm::dvec3(0), true);
    const glm::dvec3 want = glm::normalize(glm::dvec3(1, 0, 3));
    EXPECT_NEAR(glm::length(glm::dvec3(mesh.normals[0]) - want), 0, 1e-7);
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
}

TEST(Mesh, cancelling_normals_take_the_largest_face_and_no_area_takes_z) {
    const Mesh folded =
        make_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}),
                  glm::dmat4(1), glm::dvec3(0), true);
    EXPECT_EQ(folded.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(folded.normals[3], glm::vec3(0, 0, -1));
    const Mesh flat = make_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), glm::dmat4(1),
                                glm::dvec3(0), true);
    EXPECT_EQ(flat.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(flat.warnings.size(), 1u);
}

TEST(Mesh, slivers_of_aspect_1e4_have_an_area) {
    const Mesh mesh = make_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-4, 0}}, {{0, 1, 2}}), glm::dmat4(1),
                                glm::dvec3(0), true);
    EXPECT_FALSE(has_no_area(mesh, mesh.faces[0]));
    EXPECT_TRUE(mesh.warnings.empty());
}

TEST(Mesh, mirrored_transform_flips_faces_and_keeps_normals_outside) {
    MeshFile file = tetrahedron();
    const glm::dvec3 inside(0.2, 0.2, 0.2);
    for (const bool file_normals : {false, true}) {
        if (file_normals) {
            for (const glm::dvec3& p : file.positions)
                file.file_normals.push_back(glm::normalize(p - inside));
        }
        const glm::dmat4 matrix = glm::scale(glm::dmat4(1), glm::dvec3(-2, 1, 3));
        const Mesh mesh = make_mesh(file, matrix, glm::dvec3(0), true);
        const glm::dvec3 centre(matrix * glm::dvec4(inside, 1));
        for (const Mesh::Face& face : mesh.faces) {
            const glm::dvec3 corner(mesh.positions[face.position[0]]);
            EXPECT_GT(glm::dot(geometric_normal(mesh, face), corner - centre), 0);
        }
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_GT(glm::dot(glm::dvec3(mesh.normals[i]), glm::dvec3(mesh.positions[i]) - centre), 0);
            EXPECT_NEAR(glm::length(glm::dvec3(mesh.normals[i])), 1, 1e-6);
        }
        EXPECT_EQ(mesh.faces[0].uv, (std::array<std::uint32_t, 3>{0, 2, 1}));
    }
}

TEST(Mesh, normals_follow_the_inverse_transpose) {
    MeshFile file = mesh_of({{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}, {{0, 1, 2}});
    file.file_normals.assign(3, glm::normalize(glm::dvec3(-1, 0, 1)));
    const Mesh mesh = make_mesh(file, glm::scale(glm::dmat4(1), glm::dvec3(4, 1, 1)), glm::dvec3(0), true);
    EXPECT_NEAR(glm::length(glm::dvec3(mesh.normals[0]) - geometric_normal(mesh, mesh.faces[0])), 0, 1e-6);
}

TEST(Mesh, far_away_keeps_digits_of_1e_minus_6) {
    MeshFile file = mesh_of({{1e5, 0, 0}, {1e5 + 1e-6, 0, 0}, {1e5, 1, 0}}, {{0, 1, 2}});
    const Mesh mesh = make_mesh(file, glm::translate(glm::dmat4(1), glm::dvec3(0, 1e5, -1e5)),
                                glm::dvec3(1e5, 1e5, -1e5), true);
    EXPECT_NEAR(static_cast<double>(mesh.positions[1].x - mesh.positions[0].x), 1e-6, 1e-10);
}

TEST(Mesh, scales_from_1e_minus_4_to_1e4) {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const Mesh mesh =
            make_mesh(tetrahedron(), glm::scale(glm::dmat4(1), glm::dvec3(scale)), glm::dvec3(0), true);
        const Mesh unit = make_mesh(tetrahedron(), glm::dmat4(1), glm::dvec3(0), true);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(glm::length(glm::dvec3(mesh.normals[i]) - glm::dvec3(unit.normals[i])), 0, 1e-6);
        }
        EXPECT_TRUE(mesh.warnings.empty());
        EXPECT_NEAR(static_cast<double>(mesh.sphere_radius) / scale, static_cast<double>(unit.sphere_radius),
                    1e-6);
    }
}

TEST(Mesh, sphere_and_bounds_hold_every_position) {
    const Mesh mesh = make_mesh(tetrahedron(), glm::dmat4(1), glm::dvec3(0.3, 0.1, 7), true);
    for (const glm::vec3& p : mesh.positions) {
        EXPECT_LE(glm::length(glm::dvec3(p) - glm::dvec3(mesh.sphere_centre)),
                  static_cast<double>(mesh.sphere_radius));
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(mesh.bounds_low[k], p[k]);
            EXPECT_GE(mesh.bounds_high[k], p[k]);
        }
    }
}

TEST(Mesh, positions_beyond_float_are_refused) {
    const MeshFile file = mesh_of({{0, 0, 0}, {1e39, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(refusal([&] { make_mesh(file, glm::dmat4(1), glm::dvec3(0), true); }),
              "test.obj: a position lies beyond the range of numbers; scale the mesh down");
}

}  // namespace
}  // namespace relievo::mesh_test
