// The micro-triangles of all objects on the device, in the order in which the tree knows them.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "renderer/micro_mesh.h"
#include "renderer/scene_tree.h"
#include "renderer/vulkan/resources.h"

namespace relievo {

class MicroScene {
  public:
    struct Object {
        const Mesh* mesh;  // outlives the scene
        MicroMesh::TexelAt texel_at;
        MicroMesh::DisplacementAt displacement;
    };

    // How the objects' meshes are divided. Throws std::invalid_argument where there would be more than
    // kMostMicroTriangles.
    MicroScene(std::span<const Object> objects, double density);
    // Of the same objects, once; `primitives` as on the device.
    void build(const vulkan::Context& context, std::span<const Object> objects,
               std::span<const gpu::Primitive> primitives, TracePath path);

    // What the tree is made of: of our own boxes, to be taken once, box i that of micro-triangle i; else triangles.
    std::vector<Box> take_boxes() { return std::move(boxes_); }
    vulkan::TriangleBuffers triangles() const;
    // Moves the micro-triangles of one primitive to where the heights are now, and their boxes, where the
    // tree has any.
    void move(std::uint32_t primitive, const gpu::Primitive& p, const MicroMesh::DisplacementAt& displacement,
              SceneTree& tree);

    // As in gpu::FrameData.
    VkDeviceAddress vertices() const { return vertices_.address(); }
    VkDeviceAddress corners() const { return corners_.address(); }
    VkDeviceAddress primitives() const { return primitives_.address(); }
    VkDeviceSize bytes() const { return vertices_.bytes() + corners_.bytes() + primitives_.bytes(); }

  private:
    struct Part {  // of one primitive
        std::uint32_t first_vertex = 0, first_triangle = 0;
    };

    std::vector<MicroMesh> meshes_;
    std::vector<Part> parts_;
    std::vector<std::uint32_t> place_of_;  // of a triangle in its part's order: where it is stored
    std::uint32_t vertex_count_ = 0;
    std::vector<Box> boxes_;
    vulkan::Buffer vertices_, corners_, primitives_;
};

}  // namespace relievo
