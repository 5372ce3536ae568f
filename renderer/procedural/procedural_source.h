// A procedural height source on the processor: its tables (which the device reads too), its heights and their
// bounds in double. What it computes, and its papers: shaders/geometry/procedural.glsl.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "renderer/procedural/exemplar_bounds.h"
#include "renderer/scene/scene.h"
#include "shaders/shared.h"

namespace relievo {

struct ExemplarView;

inline std::array<glm::dvec2, 3> corner_uvs(const Mesh& mesh, std::uint32_t face) {
    const auto& uv = mesh.faces[face].uv;
    return {mesh.uvs[uv[0]], mesh.uvs[uv[1]], mesh.uvs[uv[2]]};
}

class ProceduralSource {
  public:
    struct Range {  // heights, [0, 1]
        double low, high;
    };

    // Makes the tables of an exemplar of row-major texels, row 0 at v = 0, at least 1 x 1, which are not
    // kept.
    ProceduralSource(const Procedural& settings, int width, int height, const std::uint16_t* exemplar);
    ~ProceduralSource();
    ProceduralSource(ProceduralSource&&) noexcept;
    ProceduralSource& operator=(ProceduralSource&&) noexcept;

    int width() const;
    int height() const;
    std::span<const std::uint16_t> gaussianised()
        const;                                       // the exemplar by its histogram: 0 to 65535 mean 0 to 1
    std::span<const std::uint32_t> inverse() const;  // the way back: see gpu::ProceduralData
    const gpu::ProceduralData& data() const;
    const ExemplarView& view() const;  // for procedural.glsl's functions (evaluate.h)

    // Virtual texel coordinates of texture coordinates, centres of texels at whole numbers.
    glm::dvec2 texel_at(const glm::dvec2& uv) const;
    // Of a triangle's corners. std::invalid_argument where they reach beyond 2^22 texels.
    std::array<glm::dvec2, 3> texels_at(const std::array<glm::dvec2, 3>& uv) const;
    glm::dvec2 uv_at(const glm::dvec2& texel) const;
    // Whether the triangle is so thin in the lattice's coordinates that a walk there cannot tell its places apart. Throws as
    // texels_at.
    bool thin_over_lattice(const std::array<glm::dvec2, 3>& uv) const;

    // Whole texels (below 2^22 either way): the heights that the surface is bilinear between.
    double texel(const glm::ivec2& at) const;
    // Height at texel coordinates; likewise.
    double value(const glm::dvec2& texel) const;
    // Bounds of the heights of the texels from `first` to `last`, both included. Conservative.
    Range range(const glm::ivec2& first, const glm::ivec2& last) const;
    Range whole() const;
    // Bounds of the heights over the triangle with these texture coordinates. Conservative, and as tight as
    // some dozen squares over it allow. Throws as texels_at.
    Range range(const std::array<glm::dvec2, 3>& uv) const;
    Range range(const Mesh& mesh, std::uint32_t face) const { return range(corner_uvs(mesh, face)); }

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace relievo
