// See micro_scene.h.
#include "renderer/micro_scene.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>

namespace relievo {
namespace {

constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

Box box_around(const glm::uvec3& corners, const gpu::MicroVertex* vertices) {
    const glm::vec3 &a = vertices[corners.x].position, &b = vertices[corners.y].position,
                    &c = vertices[corners.z].position;
    const Box box{glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
    return with_rounding(box);
}

}  // namespace

MicroScene::MicroScene(const vulkan::Context& context, std::span<const Object> objects,
                       std::span<const gpu::Primitive> primitives, double density, TracePath path) {
    std::uint64_t most = 0;
    for (const Object& object : objects) {
        meshes_.emplace_back(*object.mesh, object.texel_at, density);
        most += meshes_.back().triangles();
    }
    if (most > kMostMicroTriangles)
        throw std::invalid_argument("method 'tessellated' would make " + std::to_string(most) +
                                    " micro-triangles, at most " + std::to_string(kMostMicroTriangles) +
                                    " are made: a smaller density than " + std::to_string(density) +
                                    " makes fewer");
    std::vector<MicroTriangle> triangles;
    triangles.reserve(most);
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
        const gpu::Primitive& p = primitives[i];
        const auto first = static_cast<std::uint32_t>(triangles.size());
        meshes_[p.object].connect(p.face, vertex_count_, i, triangles);
        parts_.push_back({vertex_count_, first, static_cast<std::uint32_t>(triangles.size()) - first});
        vertex_count_ += meshes_[p.object].vertices_of(p.face);
    }
    const VkBufferUsageFlags usage = path == TracePath::bvh ? kStorage : kStorage | vulkan::kBuildInput;
    vertices_ =
        vulkan::Buffer(context, vertex_count_ * sizeof(gpu::MicroVertex), usage, vulkan::Access::host);
    for (std::uint32_t i = 0; i < primitives.size(); ++i)
        place(parts_[i], primitives[i], objects[primitives[i].object].displacement);
    // Our own tree sorts for itself.
    std::vector<std::uint32_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    if (path != TracePath::bvh) {
        std::vector<Box> boxes;
        for (const MicroTriangle& t : triangles)
            boxes.push_back(box_around(t.corners, vertices_.as<gpu::MicroVertex>()));
        order = spatial_order(boxes);
    }
    place_of_.resize(order.size());
    corners_ = vulkan::Buffer(context, triangles.size() * sizeof(glm::uvec3), usage, vulkan::Access::host);
    primitives_ =
        vulkan::Buffer(context, triangles.size() * sizeof(std::uint32_t), kStorage, vulkan::Access::host);
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        corners_.as<glm::uvec3>()[i] = triangles[order[i]].corners;
        primitives_.as<std::uint32_t>()[i] = triangles[order[i]].primitive;
        place_of_[order[i]] = i;
    }
}

void MicroScene::place(const Part& part, const gpu::Primitive& p,
                       const MicroMesh::DisplacementAt& displacement) {
    const MicroMesh& mesh = meshes_[p.object];
    mesh.place(p.face, displacement,
               {vertices_.as<gpu::MicroVertex>() + part.first_vertex, mesh.vertices_of(p.face)});
}

Box MicroScene::box_of(std::uint32_t triangle) const {
    return box_around(corners_.as<glm::uvec3>()[triangle], vertices_.as<gpu::MicroVertex>());
}

vulkan::TriangleBuffers MicroScene::triangles() const {
    static_assert(offsetof(gpu::MicroVertex, position) == 0);
    return {vertices_.address(), vertex_count_, sizeof(gpu::MicroVertex), corners_.address(),
            static_cast<std::uint32_t>(place_of_.size())};
}

std::vector<Box> MicroScene::boxes() const {
    std::vector<Box> boxes(place_of_.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) boxes[i] = box_of(i);
    return boxes;
}

void MicroScene::move(std::uint32_t primitive, const gpu::Primitive& p,
                      const MicroMesh::DisplacementAt& displacement, SceneTree& tree) {
    const Part& part = parts_[primitive];
    place(part, p, displacement);
    if (!tree.has_boxes()) return;
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
        const std::uint32_t at = place_of_[part.first_triangle + i];
        tree.set_box(at, box_of(at));
    }
}

}  // namespace relievo
