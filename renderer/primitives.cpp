// See primitives.h.
#include "renderer/primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "renderer/scene/cross2.h"

namespace relievo {
namespace {

using glm::dvec2;
using glm::dvec3;

// Beyond these the parallel prism says too little about where the surface is: barycentric, and the least
// cosine of a vertex normal to ng.
constexpr double kMostShellMargin = 0.25;
constexpr double kLeastShellCosine = 0.15;
// Beyond these the way back from a point to shell coordinates rounds too much: the shell's volume, of what it
// has on the base triangle; and the triangle's altitude, of the coordinates' size.
constexpr double kLeastShellVolume = 0.1;
constexpr double kLeastAltitude = 1e-5;

int floor_mod(double value, int size) {
    const double wrapped = std::fmod(value, size);
    return static_cast<int>(wrapped < 0 ? wrapped + size : wrapped);
}

// Texel coordinates relative to the footprint's lower left texel; the base itself is wrapped (repeat), kept
// within the range that 16 bits hold (clamp: far outside everything is the border texel anyway), or whole
// (procedural: nothing repeats).
void set_texels(gpu::Primitive& p, const std::array<dvec2, 3>& uv, const TexelSpace& texels) {
    const MapSize& map = texels.size;
    std::array<dvec2, 3> tx;
    if (texels.source) tx = texels.source->texels_at(uv);
    else for (std::size_t i = 0; i < 3; ++i) tx[i] = uv[i] * dvec2(map.width, map.height) - 0.5;
    const dvec2 low = glm::min(glm::min(tx[0], tx[1]), tx[2]);
    dvec2 base(std::floor(low.x), std::floor(low.y));
    if (texels.clamp) base = glm::clamp(base, dvec2(0), dvec2(map.width - 1, map.height - 1));
    p.tx0 = glm::vec2(tx[0] - base);
    p.tx1 = glm::vec2(tx[1] - base);
    p.tx2 = glm::vec2(tx[2] - base);
    const bool wrap = !texels.clamp && !texels.source;
    const auto whole = [&](double value, int size) {
        return static_cast<std::uint32_t>(wrap ? floor_mod(value, size) : static_cast<int>(value));
    };
    const std::uint32_t x = whole(base.x, map.width), y = whole(base.y, map.height);
    p.base = (x & 0xffffu) | y << 16;
    p.base_high = x >> 16 | (y & 0xffff0000u);
}

glm::vec2 lateral(const dvec3& normal, const dvec3& tangent, const dvec3& bitangent, const dvec3& ng) {
    const double cosine = std::max(glm::dot(normal, ng), kLeastNormalCosine);
    return glm::vec2(dvec2(glm::dot(normal, tangent), glm::dot(normal, bitangent)) / cosine);
}

// Twice the area of the offset triangle at height w.
double offset_area(const gpu::Primitive& p, double w) {
    const dvec2 q0 = dvec2(p.shift0) * w, q1 = dvec2(p.q1x, 0) + dvec2(p.shift1) * w,
                q2 = dvec2(p.q2) + dvec2(p.shift2) * w;
    return cross2(q1 - q0, q2 - q0);
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

// What rounding may do to heights.
double height_slack(const gpu::Primitive& p, const DisplacementRange& range) {
    return 2e-6 * (std::max(std::abs(range.low), std::abs(range.high)) + std::max<double>(p.q1x, p.q2.y));
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
                                             const TexelSpace& texels) {
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
    if (has_no_area(mesh, f) || !std::isfinite(area)) return std::nullopt;
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
    set_texels(p, uv, texels);
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
    const double slack = height_slack(p, range);
    p.w_low = static_cast<float>((range.low > 0 ? range.low / longest : range.low) - slack);
    p.w_high = static_cast<float>((range.high < 0 ? range.high / longest : range.high) + slack);
    p.flags = (p.flags & ~gpu::kPrimitiveFolded) | (turns_over(p) ? gpu::kPrimitiveFolded : 0u);
}

namespace {

// At height w the surface's lateral shift is sum b'_i shift_i, b'_i = b_i k_i / k(b), against the prism's
// sum b_i shift_i; |b'_i - b_i| <= b_i (largest k / least k - 1), and the shifts' differences count.
double shell_margin(const gpu::Primitive& p) {
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
    return reach * (edge + height * apart) / area;
}

// The least volume element of the shell P(b) + h N(b)/|N(b)| over the range's ends, sampled at corners,
// middles of edges and the centre, as a part of what it is at h = 0 and N along ng.
double least_shell_volume(const gpu::Primitive& p, const gpu::PrimitiveNormals& n,
                          const DisplacementRange& range) {
    constexpr dvec2 kSamples[] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0, 0.5}, {0.5, 0.5}, {1 / 3.0, 1 / 3.0}};
    const dvec3 tangent = p.tangent, bitangent = glm::cross(dvec3(p.ng), tangent);
    const dvec3 e1 = tangent * double{p.q1x}, e2 = tangent * double{p.q2.x} + bitangent * double{p.q2.y};
    const dvec3 n0 = n.n0, n1 = dvec3(n.n1) - n0, n2 = dvec3(n.n2) - n0;
    double least = 1;
    for (const dvec2& b : kSamples) {
        const dvec3 normal = n0 + n1 * b.x + n2 * b.y;
        const double length = glm::length(normal);
        if (!(length > 0)) return 0;
        const dvec3 unit = normal / length;
        for (const double h : {range.low, range.high}) {
            const dvec3 s1 = e1 + (n1 - unit * glm::dot(unit, n1)) * (h / length);
            const dvec3 s2 = e2 + (n2 - unit * glm::dot(unit, n2)) * (h / length);
            least = std::min(least, glm::dot(glm::cross(s1, s2), unit) / offset_area(p, 0));
        }
    }
    return least;
}

// The least altitude over the size of the coordinates.
double relative_altitude(const gpu::Primitive& p) {
    const double edge = std::max<double>({p.q1x, glm::length(p.q2), glm::length(p.q2 - glm::vec2(p.q1x, 0))});
    const double size =
        std::max<double>({edge, std::abs(p.origin.x), std::abs(p.origin.y), std::abs(p.origin.z)});
    return offset_area(p, 0) / (edge * size);
}

}  // namespace

Box with_rounding(const Box& box) {
    const glm::vec3 margin = glm::vec3(glm::length(box.high - box.low) * kRoundingOfSize) +
                             glm::max(glm::abs(box.low), glm::abs(box.high)) * kRoundingOfCoordinates;
    return {box.low - margin, box.high + margin};
}

void set_shell(gpu::Primitive& p, const gpu::PrimitiveNormals& n, const DisplacementRange& range) {
    set_heights(p, range);
    p.flags &= ~gpu::kPrimitiveSearched;
    const double margin = shell_margin(p);
    double cosine = 1;
    for (const glm::vec3& normal : {n.n0, n.n1, n.n2})
        cosine = std::min<double>(cosine, glm::dot(normal, p.ng));
    p.shell_margin = static_cast<float>(std::min(margin, 1.0));
    const bool folded = (p.flags & gpu::kPrimitiveFolded) != 0;
    if (!folded && margin <= kMostShellMargin && cosine >= kLeastShellCosine &&
        least_shell_volume(p, n, range) >= kLeastShellVolume && relative_altitude(p) >= kLeastAltitude)
        return;
    p.flags |= gpu::kPrimitiveSearched;
    const double slack = height_slack(p, range);
    p.w_low = static_cast<float>(range.low - slack);
    p.w_high = static_cast<float>(range.high + slack);
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
