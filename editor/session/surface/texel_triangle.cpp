#include "editor/session/surface/texel_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace relievo {
namespace {

constexpr double kMostRepeats = 64;

}  // namespace

TexelTriangle texel_triangle(const Mesh& mesh, std::uint32_t face, const MapGrid& grid) {
    const auto& uv = mesh.faces[face].uv;
    return {{grid.texel_from_uv(mesh.uvs[uv[0]]), grid.texel_from_uv(mesh.uvs[uv[1]]),
             grid.texel_from_uv(mesh.uvs[uv[2]])}};
}

double TexelTriangle::doubled_area() const {
    return (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
}

bool can_rasterise(const TexelTriangle& triangle, const MapGrid& grid) {
    const auto [low_x, high_x] = std::minmax({triangle.p[0].x, triangle.p[1].x, triangle.p[2].x});
    const auto [low_y, high_y] = std::minmax({triangle.p[0].y, triangle.p[1].y, triangle.p[2].y});
    // Past 2^40 texels from the map a double no longer tells texel centres apart.
    constexpr double kFar = 1099511627776.0;
    // A sliver thinner than this share of its length has no barycentrics to speak of, and its neighbours hold
    // its texels.
    constexpr double kSliver = 1e-9;
    const double length = std::max(high_x - low_x, high_y - low_y);
    const bool near = low_x > -kFar && high_x < kFar && low_y > -kFar && high_y < kFar;
    return near && high_x - low_x <= kMostRepeats * grid.width &&
           high_y - low_y <= kMostRepeats * grid.height &&
           std::abs(triangle.doubled_area()) > kSliver * length * length;
}

TexelSpan TexelTriangle::rows() const {
    return {static_cast<std::int64_t>(std::ceil(std::min({p[0].y, p[1].y, p[2].y}))),
            static_cast<std::int64_t>(std::floor(std::max({p[0].y, p[1].y, p[2].y})))};
}

TexelSpan TexelTriangle::columns(std::int64_t row) const {
    const auto y = static_cast<double>(row);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto meet = [&](double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        glm::dvec2 a = p[i], b = p[(i + 1) % 3];
        if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
        if (y < a.y || y > b.y) continue;
        if (y == a.y) meet(a.x);
        if (y == b.y) meet(b.x);
        if (y > a.y && y < b.y) meet(a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y));
    }
    if (low > high) return {0, -1};
    return {static_cast<std::int64_t>(std::ceil(low)), static_cast<std::int64_t>(std::floor(high))};
}

glm::dmat2x3 space_from_texels(const Mesh& mesh, std::uint32_t face, const TexelTriangle& triangle) {
    const auto& corner = mesh.faces[face].position;
    const glm::dvec3 origin(mesh.positions[corner[0]]);
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[corner[1]]) - origin,
                     e2 = glm::dvec3(mesh.positions[corner[2]]) - origin;
    const glm::dvec2 t1 = triangle.p[1] - triangle.p[0], t2 = triangle.p[2] - triangle.p[0];
    return {(t2.y * e1 - t1.y * e2) / triangle.doubled_area(), (t1.x * e2 - t2.x * e1) / triangle.doubled_area()};
}

TexelSpan clipped(TexelSpan span, int size, Wrap wrap) {
    if (wrap == Wrap::repeat) return span;
    return {std::max<std::int64_t>(span.first, 0), std::min<std::int64_t>(span.last, size - 1)};
}

}  // namespace relievo
