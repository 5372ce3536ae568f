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

Box box_around(const glm::uvec3& corners, std::span<const gpu::MicroVertex> vertices) {
    const glm::vec3 &a = vertices[corners.x].position, &b = vertices[corners.y].position,
                    &c = vertices[corners.z].position;
    const Box box{glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
    return with_rounding(box);
}

}  // namespace

MicroScene::MicroScene(std::span<const Object> objects, double density) {
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
}

void MicroScene::build(const vulkan::Context& context, std::span<const Object> objects,
                       std::span<const gpu::Primitive> primitives, TracePath path) {
    std::uint64_t most = 0;
    for (const MicroMesh& mesh : meshes_) most += mesh.triangles();
    std::vector<MicroTriangle> triangles;
    triangles.reserve(most);
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
        const gpu::Primitive& p = primitives[i];
        const auto first = static_cast<std::uint32_t>(triangles.size());
        meshes_[p.object].connect(p.face, vertex_count_, i, triangles);
        parts_.push_back({vertex_count_, first});
        vertex_count_ += meshes_[p.object].vertices_of(p.face);
    }
    const VkBufferUsageFlags usage = path == TracePath::bvh ? kStorage : kStorage | vulkan::kBuildInput;
    std::vector<gpu::MicroVertex> vertices(vertex_count_);
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
        const gpu::Primitive& p = primitives[i];
        const MicroMesh& mesh = meshes_[p.object];
        mesh.place(p.face, objects[p.object].displacement,
                   std::span(vertices).subspan(parts_[i].first_vertex, mesh.vertices_of(p.face)));
    }
    vertices_ = vulkan::Buffer(context, vertex_count_ * sizeof(gpu::MicroVertex), usage, vulkan::Access::host);
    std::ranges::copy(vertices, vertices_.as<gpu::MicroVertex>());
    boxes_.reserve(triangles.size());
    for (const MicroTriangle& t : triangles) boxes_.push_back(box_around(t.corners, vertices));
    // Our own tree sorts for itself; the driver's has no use for boxes.
    std::vector<std::uint32_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    if (path != TracePath::bvh) {
        order = spatial_order(boxes_);
        boxes_ = {};
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

vulkan::TriangleBuffers MicroScene::triangles() const {
    static_assert(offsetof(gpu::MicroVertex, position) == 0);
    return {vertices_.address(), vertex_count_, sizeof(gpu::MicroVertex), corners_.address(),
            static_cast<std::uint32_t>(place_of_.size())};
}

void MicroScene::move(std::uint32_t primitive, const gpu::Primitive& p,
                      const MicroMesh::DisplacementAt& displacement, SceneTree& tree) {
    const Part& part = parts_[primitive];
    const MicroMesh& mesh = meshes_[p.object];
    std::vector<gpu::MicroVertex> vertices(mesh.vertices_of(p.face));
    mesh.place(p.face, displacement, vertices);
    std::ranges::copy(vertices, vertices_.as<gpu::MicroVertex>() + part.first_vertex);
    if (!tree.has_boxes()) return;
    std::vector<MicroTriangle> triangles;
    mesh.connect(p.face, 0, primitive, triangles);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        tree.set_box(place_of_[part.first_triangle + i], box_around(triangles[i].corners, vertices));
}

}  // namespace relievo
