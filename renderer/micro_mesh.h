// The displaced surface S as micro-triangles: for the method `tessellated`.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "renderer/primitives.h"
#include "renderer/scene/mesh.h"
#include "shaders/shared.h"

namespace relievo {

constexpr std::uint64_t kMostMicroTriangles = 1u << 22;

struct MicroTriangle {
    glm::uvec3 corners;  // numbers of gpu::MicroVertex
    std::uint32_t primitive;
};

// How one object's mesh is divided. Every edge has a number of segments that follows from its length in
// texels along u or v, the longer of the two where its sides differ; a triangle is divided like its finest
// edge, and corners on a coarser edge stand on the nearest of that edge's own, so that neighbours share all
// corners and nothing is open between them.
class MicroMesh {
  public:
    using TexelAt = std::function<glm::dvec2(const glm::dvec2& uv)>;     // texel coordinates
    using DisplacementAt = std::function<double(const glm::dvec2& uv)>;  // world units

    // `mesh` outlives it. `density`: segments a texel, above 0; at most kMostSegments an edge.
    MicroMesh(const Mesh& mesh, const TexelAt& texel_at, double density);

    std::uint64_t triangles() const;  // an upper bound, over all faces

    std::uint32_t vertices_of(std::uint32_t face) const;
    // S at the face's grid of corners.
    void place(std::uint32_t face, const DisplacementAt& displacement,
               std::span<gpu::MicroVertex> vertices) const;
    // Appends the face's triangles, those that the edges' coarser corners leave an area; their corners count
    // from `first`.
    void connect(std::uint32_t face, std::uint32_t first, std::uint32_t primitive,
                 std::vector<MicroTriangle>& triangles) const;

    static constexpr std::uint32_t kMostSegments = 4096;

  private:
    struct Corner {  // barycentrics as whole numbers over `of`
        std::uint32_t b1, b2, of;
    };
    Corner corner(std::uint32_t face, std::uint32_t i, std::uint32_t j) const;

    const Mesh& mesh_;
    std::vector<std::uint32_t> segments_;                // of each face
    std::vector<std::array<std::uint32_t, 3>> of_edge_;  // of each face: the edges opposite its corners
};

}  // namespace relievo
