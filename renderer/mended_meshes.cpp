// See mended_meshes.h.
#include "renderer/mended_meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo {
namespace {

// Barycentrics of the base face's point nearest to `p`, in the face's plane, held inside the face.
FacePoint nearest_on_face(const Mesh& mesh, std::uint32_t face, const glm::dvec3& p) {
    const auto& f = mesh.faces[face].position;
    const glm::dvec3 a = mesh.positions[f[0]], e1 = glm::dvec3(mesh.positions[f[1]]) - a,
                     e2 = glm::dvec3(mesh.positions[f[2]]) - a, d = p - a;
    const double a11 = glm::dot(e1, e1), a12 = glm::dot(e1, e2), a22 = glm::dot(e2, e2);
    const double r1 = glm::dot(d, e1), r2 = glm::dot(d, e2), det = a11 * a22 - a12 * a12;
    if (!(det > 0)) return {face, 0, 0};
    double b1 = std::clamp((r1 * a22 - r2 * a12) / det, 0.0, 1.0);
    double b2 = std::clamp((r2 * a11 - r1 * a12) / det, 0.0, 1.0);
    if (b1 + b2 > 1) {
        const double scale = 1 / (b1 + b2);
        b1 *= scale;
        b2 *= scale;
    }
    return {face, static_cast<float>(b1), static_cast<float>(b2)};
}

}  // namespace

MendedMeshes::MendedMeshes(const Scene& scene) : scene_(&scene) {
    for (const SceneObject& object : scene.objects) mended_.push_back(mend_creases(object.mesh));
}

bool MendedMeshes::any() const {
    return std::any_of(mended_.begin(), mended_.end(), [](const MendedMesh& m) { return m.mended_edges > 0; });
}

std::vector<Mesh> MendedMeshes::traced(bool mended) const {
    std::vector<Mesh> meshes;
    for (std::size_t i = 0; i < mended_.size(); ++i)
        meshes.push_back(mended ? mended_[i].mesh : scene_->objects[i].mesh);
    return meshes;
}

FacePoint MendedMeshes::on_base(std::size_t object, const FacePoint& traced) const {
    const MendedMesh& m = mended_[object];
    if (m.mended_edges == 0) return traced;
    const auto& f = m.mesh.faces[traced.face].position;
    const glm::dvec3 p = glm::dvec3(m.mesh.positions[f[0]]) * (1.0 - traced.b1 - traced.b2) +
                         glm::dvec3(m.mesh.positions[f[1]]) * double{traced.b1} +
                         glm::dvec3(m.mesh.positions[f[2]]) * double{traced.b2};
    return nearest_on_face(scene_->objects[object].mesh, m.original_face[traced.face], p);
}

}  // namespace relievo
