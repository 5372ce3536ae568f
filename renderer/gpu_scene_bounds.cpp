// What bounds a GpuScene's triangles: their heights, boxes and hulls, as the method's hits want them.
#include <algorithm>
#include <array>
#include <utility>

#include "renderer/gpu_scene.h"
#include "renderer/slant.h"

namespace relievo {
namespace {

std::array<glm::vec2, 3> face_uvs(const Mesh& mesh, std::uint32_t face) {
    const auto& uv = mesh.faces[face].uv;
    return {mesh.uvs[uv[0]], mesh.uvs[uv[1]], mesh.uvs[uv[2]]};
}

}  // namespace

void GpuScene::set_bounds(const Object& object, std::uint32_t face, gpu::Primitive& primitive) const {
    if (meets_surface_) set_shell(primitive, primitive_normals(object.mesh, face), object.ranges[face]);
    else set_heights(primitive, object.ranges[face]);
}

DisplacementRange GpuScene::range_of(const Object& object, std::uint32_t face) const {
    double low, high;
    if (object.source) {
        const auto range = object.source->range(object.mesh, face);
        low = range.low, high = range.high;
    } else {
        const HeightRange counts = object.bounds->range(object.mesh, face);
        low = counts.low / 65535.0, high = counts.high / 65535.0;
    }
    const double a = object.amplitude * (low - object.midlevel), b = object.amplitude * (high - object.midlevel);
    return {std::min(a, b), std::max(a, b)};
}

Box GpuScene::box_of(const gpu::Primitive& p) const {
    if (!meets_surface_) return prism_box(p);
    const MappedTriangle triangle = triangle_of(p);
    const Object& object = objects_[p.object];
    return has_close_bounds(object) ? box_within(object.close[p.face], triangle)
                                    : surface_box(p, triangle.normals, triangle.range);
}

SurfaceHull GpuScene::hull_of(const gpu::Primitive& p) const {
    if (hits_ == HitPlace::in_prism) return (p.flags & gpu::kPrimitiveSearched) != 0 ? SurfaceHull{} : prism_hull(p);
    const MappedTriangle triangle = triangle_of(p);
    const Object& object = objects_[p.object];
    return has_close_bounds(object) ? hull_within(object.close[p.face], triangle, surface_of(object))
                                    : surface_hull(p, triangle.normals, triangle.range);
}

MappedTriangle GpuScene::triangle_of(const gpu::Primitive& p) const {
    const Object& object = objects_[p.object];
    return {p, primitive_normals(object.mesh, p.face), face_uvs(object.mesh, p.face), object.ranges[p.face]};
}

bool GpuScene::has_close_bounds(const Object& object) const {
    return hits_ == HitPlace::on_surface && object.pyramid && !object.source;
}

MapSurface GpuScene::surface_of(const Object& object) const {
    return {object.heights, *object.pyramid, object.amplitude, object.midlevel};
}

bool GpuScene::bound_closely(const gpu::Primitive& p) {
    Object& object = objects_[p.object];
    if (!has_close_bounds(object)) return false;
    const CloseBounds fresh = close_bounds(triangle_of(p), surface_of(object));
    return std::exchange(object.close[p.face], fresh) != fresh;
}

// Bounds that shrank would still be true, but what rays meet must not depend, by a rounding, on what the map was before:
// picks place dabs, and journals replay them.
bool GpuScene::bound_anew(Object& object, std::uint32_t face) {
    bool moved = micro_.has_value();
    if (const DisplacementRange fresh = range_of(object, face); fresh != object.ranges[face]) {
        object.ranges[face] = fresh;
        moved = true;
    }
    return bound_closely(primitives_[object.primitive_of[face]]) || moved;
}

void GpuScene::write_primitives(std::span<const SurfaceHull> hulls) {
    std::vector<gpu::Primitive> slanted;
    if (hits_ == HitPlace::on_surface) {
        slanted.reserve(primitives_.size());
        for (std::size_t i = 0; i < primitives_.size(); ++i) slanted.push_back(with_slant(triangle_of(primitives_[i]), hulls[i]));
        any_slanted_ = 2 * std::ranges::count_if(slanted, is_slanted) >= std::ssize(slanted);
    }
    std::ranges::copy(any_slanted_ ? slanted : primitives_, primitive_buffer_.as<gpu::Primitive>());
}

void GpuScene::update_primitive(const Object& object, std::uint32_t face) {
    const std::uint32_t i = object.primitive_of[face];
    gpu::Primitive& p = primitives_[i];
    set_bounds(object, face, p);
    const SurfaceHull hull = hits_ != HitPlace::in_box ? hull_of(p) : SurfaceHull{};
    primitive_buffer_.as<gpu::Primitive>()[i] = any_slanted_ ? with_slant(triangle_of(p), hull) : p;
    any_searched_ = any_searched_ || (p.flags & gpu::kPrimitiveSearched) != 0;
    if (micro_) micro_->move(i, p, micro_object(object).displacement, tree_);
    else {
        tree_.set_box(i, box_of(p));
        if (hits_ != HitPlace::in_box) tree_.set_hull(i, hull);
    }
}

}  // namespace relievo
