// See primitives.h.
#include "renderer/primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace relievo {
namespace {

using glm::dvec2;
using glm::dvec3;

// Above it the parallel prism says too little about where the surface is.
constexpr float kMostShellMargin = 0.5f;

int floor_mod(double value, int size) {
    const double wrapped = std::fmod(value, size);
    return static_cast<int>(wrapped < 0 ? wrapped + size : wrapped);
}

// Texel coordinates relative to the footprint's lower left texel; the base itself is wrapped (repeat) or kept
// within the range that 16 bits hold (clamp: far outside everything is the border texel anyway).
void set_texels(gpu::Primitive& p, const std::array<dvec2, 3>& uv, const MapSize& map, bool clamp) {
    std::array<dvec2, 3> tx;
    dvec2 low(1e300);
    for (int i = 0; i < 3; ++i) {
        tx[static_cast<std::size_t>(i)] =
            uv[static_cast<std::size_t>(i)] * dvec2(map.width, map.height) - 0.5;
        low = glm::min(low, tx[static_cast<std::size_t>(i)]);
    }
    dvec2 base(std::floor(low.x), std::floor(low.y));
    if (clamp) base = glm::clamp(base, dvec2(0), dvec2(map.width - 1, map.height - 1));
    p.tx0 = glm::vec2(tx[0] - base);
    p.tx1 = glm::vec2(tx[1] - base);
    p.tx2 = glm::vec2(tx[2] - base);
    const auto x =
        static_cast<std::uint32_t>(clamp ? static_cast<int>(base.x) : floor_mod(base.x, map.width));
    const auto y =
        static_cast<std::uint32_t>(clamp ? static_cast<int>(base.y) : floor_mod(base.y, map.height));
    p.base = x | y << 16;
}

glm::vec2 lateral(const dvec3& normal, const dvec3& tangent, const dvec3& bitangent, const dvec3& ng) {
    const double cosine = std::max(glm::dot(normal, ng), kLeastNormalCosine);
    return glm::vec2(dvec2(glm::dot(normal, tangent), glm::dot(normal, bitangent)) / cosine);
}

// Twice the area of the offset triangle at height w.
double offset_area(const gpu::Primitive& p, double w) {
    const dvec2 q0 = dvec2(p.shift0) * w, q1 = dvec2(p.q1x, 0) + dvec2(p.shift1) * w,
                q2 = dvec2(p.q2) + dvec2(p.shift2) * w;
    const dvec2 a = q1 - q0, b = q2 - q0;
    return a.x * b.y - a.y * b.x;
}

// The least of it over the primitive's heights: a quadratic in w, so at an end or at the vertex.
double least_offset_area(const gpu::Primitive& p) {
    const double f0 = offset_area(p, 0), f1 = offset_area(p, 1), f2 = offset_area(p, -1);
    const double square = (f1 + f2) / 2 - f0, linear = (f1 - f2) / 2;
    double least = std::min(offset_area(p, p.w_low), offset_area(p, p.w_high));
    if (square != 0) {
        const double vertex = -linear / (2 * square);
        if (vertex > p.w_low && vertex < p.w_high) least = std::min(least, offset_area(p, vertex));
    }
    return least;
}

bool turns_over(const gpu::Primitive& p) {
    return !(least_offset_area(p) > 1e-3 * offset_area(p, 0));
}

// How far beside the base triangle the surface may stand: |D| sin of the greatest angle between N_i and ng.
double lateral_reach(const gpu::Primitive& p) {
    double most = 0;
    for (const glm::vec2& shift : {p.shift0, p.shift1, p.shift2})
        most = std::max(most, static_cast<double>(glm::dot(shift, shift)));
    return std::max(std::abs(double{p.w_low}), std::abs(double{p.w_high})) * std::sqrt(most / (1 + most));
}

void split(std::vector<std::uint32_t>& order, const std::vector<glm::vec3>& centres, std::size_t first,
           std::size_t count) {
    if (count <= 2) return;
    glm::vec3 low(1e30f), high(-1e30f);
    for (std::size_t i = first; i < first + count; ++i) {
        low = glm::min(low, centres[order[i]]);
        high = glm::max(high, centres[order[i]]);
    }
    const glm::vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = count / 2;
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half),
                     begin + static_cast<std::ptrdiff_t>(count), [&](std::uint32_t a, std::uint32_t b) {
                         return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis]
                                                                     : a < b;
                     });
    split(order, centres, first, half);
    split(order, centres, first + half, count - half);
}

}  // namespace

std::optional<gpu::Primitive> make_primitive(const Mesh& mesh, std::uint32_t face, std::uint32_t object,
                                             const MapSize& map, bool clamp) {
    const Mesh::Face& f = mesh.faces[face];
    std::array<dvec3, 3> position, normal;
    std::array<dvec2, 3> uv;
    for (std::size_t i = 0; i < 3; ++i) {
        position[i] = mesh.positions[f.position[i]];
        normal[i] = mesh.normals[f.position[i]];
        uv[i] = mesh.uvs[f.uv[i]];
    }
    const dvec3 e1 = position[1] - position[0], e2 = position[2] - position[0], cross = glm::cross(e1, e2);
    const double area = glm::length(cross), length = glm::length(e1);
    gpu::Primitive p{};
    if (!(area > 0) || !std::isfinite(area)) return std::nullopt;
    const dvec3 ng = cross / area, tangent = e1 / length, bitangent = glm::cross(ng, tangent);
    p.origin = glm::vec3(position[0]);
    p.tangent = glm::vec3(tangent);
    p.ng = glm::vec3(ng);
    p.q1x = static_cast<float>(length);
    p.q2 = glm::vec2(dvec2(glm::dot(e2, tangent), area / length));
    if (!(p.q1x > 0) || !(p.q2.y > 0)) return std::nullopt;
    p.shift0 = lateral(normal[0], tangent, bitangent, ng);
    p.shift1 = lateral(normal[1], tangent, bitangent, ng);
    p.shift2 = lateral(normal[2], tangent, bitangent, ng);
    set_texels(p, uv, map, clamp);
    p.face = face;
    p.object = object;
    return p;
}

gpu::PrimitiveNormals primitive_normals(const Mesh& mesh, std::uint32_t face) {
    const Mesh::Face& f = mesh.faces[face];
    return {mesh.normals[f.position[0]], mesh.normals[f.position[1]], mesh.normals[f.position[2]]};
}

void set_heights(gpu::Primitive& p, const DisplacementRange& range) {
    // The surface stands at w = D / |M(b)| with 1 <= |M(b)| <= the largest |m_i| (|M| is convex in b).
    double longest = 1;
    for (const glm::vec2& shift : {p.shift0, p.shift1, p.shift2})
        longest = std::max(longest, std::sqrt(1 + static_cast<double>(glm::dot(shift, shift))));
    const double slack =
        2e-6 * (std::max(std::abs(range.low), std::abs(range.high)) + std::max<double>(p.q1x, p.q2.y));
    extend_heights(p, static_cast<float>((range.low > 0 ? range.low / longest : range.low) - slack),
                   static_cast<float>((range.high < 0 ? range.high / longest : range.high) + slack));
}

void extend_heights(gpu::Primitive& p, float w_low, float w_high) {
    p.w_low = w_low;
    p.w_high = w_high;
    p.flags = (p.flags & ~gpu::kPrimitiveFolded) | (turns_over(p) ? gpu::kPrimitiveFolded : 0u);
}

void set_shell_margin(gpu::Primitive& p) {
    // At height w the surface's lateral shift is sum b'_i shift_i, b'_i = b_i k_i / k(b), against the prism's
    // sum b_i shift_i; |b'_i - b_i| <= b_i (largest k / least k - 1), and the shifts' differences count.
    const std::array<glm::vec2, 3> shifts{p.shift0, p.shift1, p.shift2};
    double least = 1, most = 0, apart = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double k = 1 / std::sqrt(1 + static_cast<double>(glm::dot(shifts[i], shifts[i])));
        least = std::min(least, k);
        most = std::max(most, k);
        apart = std::max(apart, static_cast<double>(glm::length(shifts[i] - shifts[(i + 1) % 3])));
    }
    const double height = std::max(std::abs(double{p.w_low}), std::abs(double{p.w_high}));
    const double reach = height * (most / least - 1) * apart;
    // As the clipping wants it: of the base triangle's area. As barycentrics of the smallest offset triangle
    // no less.
    const double base = offset_area(p, 0), area = std::clamp(least_offset_area(p), 1e-3 * base, base);
    const double edge = std::max<double>({p.q1x, glm::length(p.q2), glm::length(p.q2 - glm::vec2(p.q1x, 0))});
    p.shell_margin = static_cast<float>(reach * (edge + height * apart) / area);
    if (p.shell_margin > kMostShellMargin) p.flags |= gpu::kPrimitiveFolded;
}

Box prism_box(const gpu::Primitive& p) {
    const glm::vec3 bitangent = glm::cross(p.ng, p.tangent);
    // Where the parallel prism says little about the surface, the base triangle with room to every side does.
    const bool by_reach = p.shell_margin > 0 && (p.flags & gpu::kPrimitiveFolded) != 0;
    const float lean = by_reach ? 0.0f : 1.0f;
    Box box{glm::vec3(1e30f), glm::vec3(-1e30f)};
    for (const float w : {p.w_low, p.w_high}) {
        const float shift = lean * w;
        for (const glm::vec2& q :
             {p.shift0 * shift, glm::vec2(p.q1x, 0) + p.shift1 * shift, p.q2 + p.shift2 * shift}) {
            const glm::vec3 corner = p.origin + p.tangent * q.x + bitangent * q.y + p.ng * w;
            box.low = glm::min(box.low, corner);
            box.high = glm::max(box.high, corner);
        }
    }
    const float sides = by_reach ? 0.0f : 2 * p.shell_margin;
    const glm::vec3 margin = (box.high - box.low) * (2e-5f + sides) +
                             glm::max(glm::abs(box.low), glm::abs(box.high)) * 1e-6f +
                             (by_reach ? static_cast<float>(lateral_reach(p)) : 0.0f);
    return {box.low - margin, box.high + margin};
}

std::vector<std::uint32_t> spatial_order(const std::vector<Box>& boxes) {
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<glm::vec3> centres;
    centres.reserve(boxes.size());
    for (const Box& b : boxes) centres.push_back((b.low + b.high) * 0.5f);
    split(order, centres, 0, order.size());
    return order;
}

}  // namespace relievo
