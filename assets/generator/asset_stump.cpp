// A tree stump: bark and flaring roots on four rectangular islands, year rings on a cap. The cap is a disc
// whose seam is slanted and about 4/5 of the sides' scale, on purpose: the one asset whose seams no copied
// texel can make exact.
#include <algorithm>
#include <array>
#include <cmath>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr int kAround = 72, kRows = 44, kRings = 10,
              kCell = 4;  // kAround * (2 * kRows + 2 * kRings - 1) triangles
constexpr int kPieces = 4, kPiece = kAround / kPieces;
constexpr double kCapX = 218, kCapY = 218, kCapRadius = 36;  // of the cap's island, lattice units
constexpr double kTall = 1.15, kWide = 0.62;                 // world units: height, radius under the cap

// Radius of the trunk at a height in [0, 1]: seven roots, each of its own length, that merge upwards.
double trunk_radius(double turns, double up) {
    const double angle = 2.0 * kPi * turns;
    const glm::dvec3 on_circle{cosine(angle), sine(angle), 0.0};
    const double warp = 0.35 * noise(on_circle * 1.3, 501);
    const double lobe = 0.5 + 0.5 * cosine(7.0 * angle + 4.0 * warp);
    const double length = 0.75 + 0.5 * noise(on_circle * 1.6 + glm::dvec3(0, 0, 4.5), 502);
    const double low = 1.0 - up;
    const double flare = 0.12 * low * low + 0.62 * length * lobe * lobe * low * low * low * low * low;
    const double uneven = 0.06 * noise(glm::dvec3(on_circle.x, on_circle.y, up) * 1.4, 503);
    const double waist = 0.05 * low;
    const double rounding = 0.035 * smooth_step(0.93, 1.0, up);  // the sawn edge is not sharp
    return kWide + flare + uneven + waist - rounding;
}

// World height of the grid row `up` in [0, 1]. The cap is sawn at a slight slant.
double trunk_height(double up, double x, double z) {
    return kTall * up + up * (0.05 * x - 0.03 * z);
}

glm::dvec3 side_point(double turns, double up) {
    const double angle = 2.0 * kPi * turns, r = trunk_radius(turns, up);
    // Columns run against the angle, so that columns x rows points outwards with y up.
    const double x = r * cosine(angle), z = -r * sine(angle);
    return {x, trunk_height(up, x, z), z};
}

glm::dvec3 cap_point(double turns, double rho) {
    const glm::dvec3 rim = side_point(turns, 1.0);
    const double x = rim.x * rho, z = rim.z * rho;
    return {x, trunk_height(1.0, x, z) + 0.02 * dome(rho), z};
}

// The map's range is kept narrow, at a large amplitude, for rocks to be raised on the stump.
double squeezed(double height) {
    return 0.5 + 0.6 * (height - 0.5);
}

// What bark and wood share at the rim.
double rim_height(double turns) {
    const double angle = 2.0 * kPi * turns;
    return 0.56 + 0.05 * noise({6.0 * cosine(angle), 6.0 * sine(angle), 0.5}, 511);
}

// Thick plates between deep cracks, longer than wide, fibrous along the trunk.
double bark_height(double turns, double up) {
    const double angle = 2.0 * kPi * turns;
    const glm::dvec3 ring{cosine(angle), sine(angle), 0.0};
    const glm::dvec3 low_p{ring.x * 2.0, ring.y * 2.0, up * 2.0};
    const glm::dvec3 warp{noise(low_p * 2.0, 521), noise(low_p * 2.0, 522), 2.0 * noise(low_p * 2.0, 523)};
    const glm::dvec3 p = glm::dvec3(ring.x * 6.5, ring.y * 6.5, up * 3.4) + 0.35 * warp;
    const Cells plates = cellular_noise(p, 531);
    const Cells flakes = cellular_noise(p * glm::dvec3(2.6, 2.6, 2.0), 532);
    const double crack = smooth_step(0.02, 0.3, plates.second - plates.nearest);
    const double flake = smooth_step(0.0, 0.3, flakes.second - flakes.nearest);
    const double fibre = ridged_noise({ring.x * 16.0, ring.y * 16.0, up * 3.0}, 4, 541);
    const double uneven = static_cast<double>(plates.id >> 24) / 255.0;
    const double bark = 0.34 + crack * (0.17 + 0.08 * uneven) + 0.05 * flake * crack + 0.1 * (fibre - 0.5);
    return squeezed(mix(bark, rim_height(turns), smooth_step(0.93, 0.995, up)));
}

// Year rings that follow the outline, check cracks that run out from the heart, saw marks.
double wood_height(double turns, double rho) {
    const double angle = 2.0 * kPi * turns;
    const double x = rho * cosine(angle), z = rho * sine(angle);
    const double warp =
        0.02 * noise({x * 3.0, z * 3.0, 0.0}, 551) + 0.05 * noise({x * 1.1, z * 1.1, 2.0}, 552) * rho;
    const double year = 26.0 * (rho + warp);
    const double phase = year - std::floor(year);
    const double rings = 0.035 * (smooth_step(0.0, 0.75, phase) - smooth_step(0.8, 1.0, phase));
    double cracks = 0.0;
    constexpr double kTurns[] = {0.07, 0.31, 0.52, 0.78};
    constexpr double kReach[] = {0.85, 0.5, 0.72, 0.4};
    for (int i = 0; i < 4; ++i) {
        double off = turns - kTurns[i] + 0.012 * noise({rho * 6.0, i * 3.1, 0.0}, 553);
        off -= std::floor(off + 0.5);
        const double width = 0.004 + 0.016 * rho * (1.0 - rho / kReach[i]);
        if (rho < kReach[i]) cracks = std::max(cracks, dome(off * 2.0 * kPi * rho / width));
    }
    const double saw = 0.008 * noise({x * 3.0 + z * 60.0, z * 2.0, 1.0}, 561);
    const double bark_edge = 0.09 * smooth_step(0.86, 0.93, rho);
    const double wood = 0.45 + rings - 0.16 * cracks + saw + bark_edge;
    return squeezed(mix(wood, rim_height(turns), smooth_step(0.9, 0.99, rho)));
}

// A point of the cap's island as turns and distance from its heart, 1 on the polygon that is its rim. Exact
// along the rim's chords, where the sides' turns are linear too.
double cap_texel(glm::dvec2 point) {
    const glm::dvec2 q{(point.x - kCapX) / kCapRadius, (point.y - kCapY) / kCapRadius};
    const double step = 2.0 * kPi / kAround;
    const double angle = arc_tangent(q.y, q.x);
    const double sector = std::floor(angle / step);
    const double c0 = cosine(sector * step), s0 = sine(sector * step);
    const double c1 = cosine((sector + 1) * step), s1 = sine((sector + 1) * step);
    const double area = c0 * s1 - s0 * c1;
    const double a = (q.x * s1 - q.y * c1) / area, b = (c0 * q.y - s0 * q.x) / area;
    const double rho = a + b;
    if (rho <= 0.0) return wood_height(0.0, 0.0);
    const double turns = (sector + b / rho) / kAround;
    if (rho <= 1.0) return wood_height(turns, rho);
    return bark_height(turns, 1.0 - (rho - 1.0) * 0.5);
}

void add_cap(Shape& shape, const std::vector<std::uint32_t>& rim) {
    const auto ring_uv = [](int ring, int k) {
        const double angle = 2.0 * kPi * k / kAround, r = kCapRadius * ring / kRings;
        return glm::dvec2(kCapX + r * cosine(angle), kCapY + r * sine(angle));
    };
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    for (int ring = 1; ring < kRings; ++ring)
        for (int k = 0; k < kAround; ++k)
            shape.positions.push_back(
                cap_point(static_cast<double>(k) / kAround, static_cast<double>(ring) / kRings));
    const auto heart = static_cast<std::uint32_t>(shape.positions.size());
    shape.positions.push_back(cap_point(0.0, 0.0));
    const auto vertex = [&](int ring, int k) {
        const int wrapped = k % kAround;
        if (ring == kRings) return rim[static_cast<std::size_t>(wrapped)];
        return first + static_cast<std::uint32_t>((ring - 1) * kAround + wrapped);
    };
    for (int k = 0; k < kAround; ++k) {
        shape.free_triangles.push_back(
            {{heart, vertex(1, k), vertex(1, k + 1)},
             {glm::dvec2(kCapX, kCapY), ring_uv(1, k), ring_uv(1, (k + 1) % kAround)}});
        for (int ring = 1; ring < kRings; ++ring) {
            const std::array<std::uint32_t, 4> p{vertex(ring, k), vertex(ring + 1, k),
                                                 vertex(ring + 1, k + 1), vertex(ring, k + 1)};
            const int next = (k + 1) % kAround;
            const std::array<glm::dvec2, 4> uv{ring_uv(ring, k), ring_uv(ring + 1, k),
                                               ring_uv(ring + 1, next), ring_uv(ring, next)};
            shape.free_triangles.push_back({{p[0], p[1], p[2]}, {uv[0], uv[1], uv[2]}});
            shape.free_triangles.push_back({{p[0], p[2], p[3]}, {uv[0], uv[2], uv[3]}});
        }
    }
}

Shape stump_shape() {
    Shape shape;
    for (int row = 0; row <= kRows; ++row)
        for (int k = 0; k < kAround; ++k)
            shape.positions.push_back(
                side_point(static_cast<double>(k) / kAround, static_cast<double>(row) / kRows));
    constexpr int kWidth = kPiece * kCell, kHeight = kRows * kCell;
    const std::array<Place, kPieces> places{
        {{2, 2}, {2 + kWidth + kGap, 2}, {2 + 2 * (kWidth + kGap), 2}, {2, 2 + kHeight + kGap, true}}};
    for (int piece = 0; piece < kPieces; ++piece) {
        const Place& place = places[static_cast<std::size_t>(piece)];
        shape.add_island(
            {kPiece, kRows, place.x, place.y, kCell, kCell, place.turned}, [&](int column, int row) {
                return static_cast<std::uint32_t>(row * kAround + (piece * kPiece + column) % kAround);
            });
    }
    std::vector<std::uint32_t> rim;
    for (int k = 0; k < kAround; ++k) rim.push_back(static_cast<std::uint32_t>(kRows * kAround + k));
    add_cap(shape, rim);
    shape.rows_continue = true;
    shape.make_normals();
    return shape;
}

}  // namespace

Sculpture make_stump() {
    return {stump_shape(),
            [](const Sample& p) {
                const double turns = (p.island * kPiece + p.s) / kAround, up = p.t / kRows;
                if (up <= 1.0) return bark_height(turns, up);
                return wood_height(turns, 1.0 - (p.t - kRows) * kCell / kCapRadius);
            },
            cap_texel};
}

}  // namespace relievo::assets
