// See micro_scene.h.
#include "renderer/micro_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace relievo {
namespace {

constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

Box box_around(const gpu::MicroTriangle& t, const gpu::MicroVertex* vertices) {
    const glm::vec3 &a = vertices[t.vertex.x].position, &b = vertices[t.vertex.y].position,
                    &c = vertices[t.vertex.z].position;
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
    std::vector<gpu::MicroTriangle> triangles;
    triangles.reserve(most);
    std::uint32_t vertices = 0;
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
        const gpu::Primitive& p = primitives[i];
        const auto first = static_cast<std::uint32_t>(triangles.size());
        meshes_[p.object].connect(p.face, vertices, i, triangles);
        parts_.push_back({vertices, first, static_cast<std::uint32_t>(triangles.size()) - first});
        vertices += meshes_[p.object].vertices_of(p.face);
    }
    vertices_ = vulkan::Buffer(context, vertices * sizeof(gpu::MicroVertex), kStorage, vulkan::Access::host);
    for (std::uint32_t i = 0; i < primitives.size(); ++i)
        place(parts_[i], primitives[i], objects[primitives[i].object].displacement);
    // Our own tree sorts for itself.
    std::vector<std::uint32_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    if (path != TracePath::bvh) {
        std::vector<Box> boxes;
        for (const gpu::MicroTriangle& t : triangles)
            boxes.push_back(box_around(t, vertices_.as<gpu::MicroVertex>()));
        order = spatial_order(boxes);
    }
    place_of_.resize(order.size());
    triangles_ = vulkan::Buffer(context, triangles.size() * sizeof(gpu::MicroTriangle), kStorage,
                                vulkan::Access::host);
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        triangles_.as<gpu::MicroTriangle>()[i] = triangles[order[i]];
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
    return box_around(triangles_.as<gpu::MicroTriangle>()[triangle], vertices_.as<gpu::MicroVertex>());
}

std::vector<Box> MicroScene::boxes() const {
    std::vector<Box> boxes(place_of_.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) boxes[i] = box_of(i);
    return boxes;
}

void MicroScene::move(std::uint32_t primitive, const gpu::Primitive& p,
                      const MicroMesh::DisplacementAt& displacement, BoxTree& tree) {
    const Part& part = parts_[primitive];
    place(part, p, displacement);
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
        const std::uint32_t at = place_of_[part.first_triangle + i];
        tree.set_box(at, box_of(at));
    }
}

}  // namespace relievo
