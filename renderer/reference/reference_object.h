// An object inside the reference: its heights with their bounds, and its holes.
#pragma once

#include <memory>

#include "renderer/procedural/procedural_source.h"
#include "renderer/reference/cell_heights.h"
#include "renderer/reference/face_shape.h"
#include "renderer/reference/reference.h"

namespace relievo::reference {

struct Interval {
    double low, high;
};

struct ObjectData {
    ReferenceObject source;
    std::shared_ptr<const ProceduralSource> procedural;  // empty: the heights are a map
    std::shared_ptr<const CellHeights> heights;

    explicit ObjectData(const ReferenceObject& object);

    // Texel coordinates are texture coordinates times `scale`, plus `shift`.
    TexelFrame texel_frame() const;
    glm::dvec2 uv_at(const glm::dvec2& texel) const;
    double displacement(double count) const { return source.amplitude * (count / 65535.0 - source.midlevel); }
    Interval displacement(const HeightRange& counts) const;
    CellPatch patch(const Cells& single) const;
    static CellPatch flat_patch(double displacement) { return {glm::dvec2(0), displacement, 0, 0, 0}; }
    Cells cover(const glm::dvec2& low, const glm::dvec2& high) const;
    bool opaque(const glm::dvec2& texel) const;  // at texel coordinates of the height map
};

}  // namespace relievo::reference
