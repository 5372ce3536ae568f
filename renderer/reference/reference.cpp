// See reference.h.
#include "renderer/reference/reference.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "renderer/reference/cell_ranges.h"
#include "renderer/reference/face_search.h"
#include "renderer/reference/face_tree.h"
#include "renderer/reference/procedural_cells.h"

namespace relievo {

using glm::dvec2;
using glm::dvec3;
using namespace reference;

namespace reference {

ObjectData::ObjectData(const ReferenceObject& object) : source(object) {
    const auto& map = object.heights;
    if (object.procedural) {
        procedural =
            std::make_shared<ProceduralSource>(*object.procedural, map.width, map.height, map.texels);
        heights = std::make_shared<ProceduralCells>(procedural);
    } else {
        heights = std::make_shared<CellRanges>(map, object.wrap);
    }
}

TexelFrame ObjectData::texel_frame() const {
    const dvec2 size(source.heights.width, source.heights.height);
    if (!procedural) return {size, dvec2(-0.5)};
    return {procedural->texel_at({1, 1}) - procedural->texel_at({0, 0}), procedural->texel_at({0, 0})};
}

dvec2 ObjectData::uv_at(const dvec2& texel) const {
    if (procedural) return procedural->uv_at(texel);
    return (texel + 0.5) / dvec2(source.heights.width, source.heights.height);
}

Interval ObjectData::displacement(const HeightRange& counts) const {
    const double a = displacement(static_cast<double>(counts.low)),
                 b = displacement(static_cast<double>(counts.high));
    return {std::min(a, b), std::max(a, b)};
}

CellPatch ObjectData::patch(const Cells& single) const {
    const CellCounts counts = heights->counts(single);
    const double scale = source.amplitude / 65535.0;
    return {{counts.corner_x, counts.corner_y},
            displacement(counts.c00),
            scale * counts.cx,
            scale * counts.cy,
            scale * counts.cxy};
}

Cells ObjectData::cover(const dvec2& low, const dvec2& high) const {
    Cells cells{};
    heights->cover(0, low.x, high.x, cells);
    heights->cover(1, low.y, high.y, cells);
    return cells;
}

bool ObjectData::opaque(const dvec2& texel) const {
    const auto& map = source.opacity;
    if (map.texels == nullptr) return true;
    const dvec2 size(map.width, map.height);
    const dvec2 at = uv_at(texel) * size - 0.5;
    const dvec2 cell = glm::floor(at), f = at - cell;
    const auto value = [&](double dx, double dy) {
        const auto wrapped = [&](double place, double count) {
            if (source.wrap == Wrap::clamp) return std::clamp(place, 0.0, count - 1);
            return place - std::floor(place / count) * count;
        };
        const auto x = static_cast<std::size_t>(wrapped(cell.x + dx, size.x));
        const auto y = static_cast<std::size_t>(wrapped(cell.y + dy, size.y));
        return static_cast<double>(map.texels[y * static_cast<std::size_t>(map.width) + x]);
    };
    return glm::mix(glm::mix(value(0, 0), value(1, 0), f.x), glm::mix(value(0, 1), value(1, 1), f.x), f.y) >=
           127.5;
}

namespace {

constexpr double kMostTexels = 0x1p50, kMostVirtualTexels = 0x1p22;

void check(const ReferenceObject& object) {
    if (object.mesh == nullptr || object.heights.texels == nullptr || object.heights.width < 1 ||
        object.heights.height < 1)
        throw std::invalid_argument("the reference needs a mesh and a map of at least one texel");
    if (!std::isfinite(object.amplitude) || !std::isfinite(object.midlevel))
        throw std::invalid_argument("the reference needs a finite amplitude and midlevel");
}

// Bounds of S over the whole face: P and D n apart, n within the unit ball and near N's direction.
Bounds bounds_of(const FaceShape& shape, const ObjectData& object) {
    const std::array<DomainPoint, 3> corners{{{{0, 0}, shape.texel_at({0, 0})},
                                              {{1, 0}, shape.texel_at({1, 0})},
                                              {{0, 1}, shape.texel_at({0, 1})}}};
    const dvec2 low = glm::min(glm::min(corners[0].texel, corners[1].texel), corners[2].texel);
    const dvec2 high = glm::max(glm::max(corners[0].texel, corners[1].texel), corners[2].texel);
    const Interval d = object.displacement(object.heights->range(object.cover(low, high)));
    const LengthRange length = shape.normal_length(corners);
    double radius = std::max(std::abs(d.low), std::abs(d.high));
    const double scale = length.low > 0 ? 2 / (length.low + length.high) : 0.0;
    if (length.low > 0) radius *= (length.high - length.low) / (length.low + length.high);
    Bounds bounds;
    for (const DomainPoint& corner : corners) {
        for (const double height : {d.low, d.high}) {
            const dvec3 point = shape.base(corner.b) + shape.normal(corner.b) * (height * scale);
            bounds.include({point - radius, point + radius});
        }
    }
    return bounds;
}

}  // namespace
}  // namespace reference

ReferenceObject reference_object(const SceneObject& object, const ReferenceTexels<std::uint16_t>& heights,
                                 const ReferenceTexels<std::uint8_t>& opacity) {
    const Displacement& d = object.displacement;
    return {&object.mesh, d.amplitude, d.midlevel, d.wrap, heights, opacity, d.procedural};
}

struct ReferenceSurface::State {
    std::vector<ObjectData> objects;
    std::vector<FaceShape> shapes;  // of all objects, those without area left out
    FaceTree tree;
    std::uint64_t node_limit;
};

ReferenceSurface::ReferenceSurface(std::span<const ReferenceObject> objects, std::uint64_t node_limit)
    : state_(std::make_unique<State>()) {
    state_->node_limit = node_limit;
    std::vector<Bounds> boxes;
    for (const ReferenceObject& source : objects) {
        check(source);
        const auto index = static_cast<std::uint32_t>(state_->objects.size());
        state_->objects.emplace_back(source);
        const Mesh& mesh = *source.mesh;
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
            if (has_no_area(mesh, mesh.faces[face])) continue;
            const FaceShape shape = make_face_shape(mesh, index, face, state_->objects.back().texel_frame());
            for (const dvec2& b : {dvec2(0, 0), dvec2(1, 0), dvec2(0, 1)}) {
                const dvec2 texel = glm::abs(shape.texel_at(b));
                if (!(std::max(texel.x, texel.y) < (source.procedural ? kMostVirtualTexels : kMostTexels)))
                    throw std::invalid_argument("face " + std::to_string(face) +
                                                ": its texture coordinates lie beyond 2^50 texels, or 2^22 of "
                                                "procedural heights");
            }
            boxes.push_back(bounds_of(shape, state_->objects.back()));
            state_->shapes.push_back(shape);
        }
    }
    state_->tree = FaceTree(std::move(boxes));
}

ReferenceSurface::~ReferenceSurface() = default;
ReferenceSurface::ReferenceSurface(ReferenceSurface&&) noexcept = default;
ReferenceSurface& ReferenceSurface::operator=(ReferenceSurface&&) noexcept = default;

ReferenceAnswer ReferenceSurface::trace(const dvec3& origin, const dvec3& direction, double t_min,
                                        double t_max) const {
    const double length = glm::length(direction);
    const double sum = length + glm::length(origin);
    if (!std::isfinite(sum) || !(length > 0) || std::isnan(t_min) || std::isnan(t_max))
        throw std::invalid_argument(
            "a ray needs a finite origin, a finite direction that is not 0, and no NaN bounds");
    const RayFrame frame(origin, direction / length);
    FaceSearch search(frame, t_min * length, t_max * length, state_->node_limit);
    state_->tree.visit(origin, frame.direction(), t_min * length, search.z_max(),
                       [&](std::uint32_t index, double) {
                           const FaceShape& shape = state_->shapes[index];
                           if (!search.exhausted()) search.search(state_->objects[shape.object], shape);
                       });
    ReferenceAnswer answer;
    answer.nodes = search.nodes();
    answer.undecided = search.exhausted();
    if (const auto& found = search.found()) {
        const SurfaceJet jet = found->shape->jet(found->patch, found->at);
        const dvec3 across = glm::cross(jet.s1, jet.s2);
        const double size = glm::length(across);
        const dvec3 fallback = glm::cross(found->shape->p1, found->shape->p2);
        answer.hit = ReferenceHit{found->shape->object,
                                  found->shape->face,
                                  found->at.b.x,
                                  found->at.b.y,
                                  found->z / length,
                                  jet.s,
                                  size > 0 ? across / size : glm::normalize(fallback)};
    }
    return answer;
}

ReferencePoint ReferenceSurface::evaluate(std::uint32_t object, std::uint32_t face, double b1,
                                          double b2) const {
    const ObjectData& data = state_->objects[object];
    const FaceShape shape = make_face_shape(*data.source.mesh, object, face, data.texel_frame());
    const DomainPoint at{{b1, b2}, shape.texel_at({b1, b2})};
    const CellPatch patch = data.patch(data.cover(at.texel, at.texel));
    const SurfaceJet jet = shape.jet(patch, at);
    const dvec3 across = glm::cross(jet.s1, jet.s2);
    const double length = glm::length(across);
    const dvec3 fallback = glm::cross(shape.p1, shape.p2);
    return {jet.s, length > 0 ? across / length : glm::normalize(fallback), patch.at(at.texel),
            data.uv_at(at.texel)};
}

}  // namespace relievo
