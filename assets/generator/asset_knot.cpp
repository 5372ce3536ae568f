// A trefoil knot in the dragon's place: a scaly tube with a crest of plates along its outer side.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr Tube kKnotTube{39, 286, 3, 2, 2};
constexpr double kKnotRadius = 0.235;
constexpr double kKnotCore = 0.82, kSwing = 0.4;  // of the torus that the knot winds around, world units
constexpr int kScalesAlong = 168,
              kScalesAround = 12;  // the first even: every other row is shifted by half a scale

glm::dvec3 knot_point(double turn) {
    const double around = 4.0 * kPi * turn, swing = 6.0 * kPi * turn;
    const double r = kKnotCore + kSwing * cosine(swing);
    return {r * cosine(around), r * sine(around), kSwing * sine(swing)};
}

TubeFrame knot_frame(double turn) {
    const double around = 4.0 * kPi * turn, swing = 6.0 * kPi * turn;
    const glm::dvec3 out{cosine(swing) * cosine(around), cosine(swing) * sine(around), sine(swing)};
    const glm::dvec3 tangent = glm::normalize(knot_point(turn + 1e-5) - knot_point(turn - 1e-5));
    const glm::dvec3 first = glm::normalize(out - tangent * glm::dot(out, tangent));
    return {knot_point(turn), first, glm::cross(tangent, first)};
}

// Turns at equal steps of arc length, so that scales keep their size.
std::vector<double> even_turns(int count) {
    constexpr int kSteps = 1 << 15;
    std::vector<double> length{0.0};
    for (int i = 1; i <= kSteps; ++i)
        length.push_back(length.back() + glm::distance(knot_point((i - 1.0) / kSteps),
                                                       knot_point(static_cast<double>(i) / kSteps)));
    std::vector<double> turns;
    std::size_t i = 0;
    for (int k = 0; k < count; ++k) {
        const double wanted = length.back() * k / count;
        while (length[i + 1] <= wanted) ++i;
        turns.push_back((static_cast<double>(i) + (wanted - length[i]) / (length[i + 1] - length[i])) /
                        kSteps);
    }
    return turns;
}

// One scale: a shield that rises to its tip, keeled and rounded off at its rim. `across` in [-1, 1] at its
// widest, `forward` 0 at the root and 1 at the tip. Negative outside.
double scale_height(double across, double forward, double lift) {
    const double taper = forward < 0.45 ? 0.0 : (forward - 0.45) / 0.55;
    const double r = across * across + taper * taper;
    if (r >= 1.0 || forward < 0.0) return -1.0;
    const double keel = 0.16 * dome(across / 0.3) * smooth_step(0.15, 0.6, forward);
    return (0.1 + 0.62 * forward) * lift + keel + 0.28 * std::sqrt(1.0 - r);
}

double scaly_height(double along, double around, glm::dvec3 point) {
    const double row_at = along * kScalesAlong, column_at = around * kScalesAround;
    const int row = static_cast<int>(std::floor(row_at));
    double best = 0.0;
    for (int r = row; r > row - 3; --r) {
        const double shift = (r & 1) ? 0.5 : 0.0;
        const double column = std::floor(column_at - shift);
        for (int c = -1; c <= 1; ++c) {
            const auto wrapped_row = static_cast<std::uint32_t>((r + kScalesAlong) % kScalesAlong);
            const int index = static_cast<int>(column) + c + kScalesAround;
            const auto wrapped_column = static_cast<std::uint32_t>(index % kScalesAround);
            const double lift = 0.85 + 0.3 * hash01(wrapped_row, wrapped_column, 0, 301);
            const double across = (column_at - shift - column - c - 0.5) / 0.56;
            best = std::max(best, scale_height(across, (row_at - r) / 2.1, lift));
        }
    }
    // The crest: plates on the tube's outer side, one every four rows.
    const double from_crest = around < 0.5 ? around : around - 1.0;
    const double plate = row_at / 4.0 - std::floor(row_at / 4.0);
    const double crest =
        dome(from_crest / 0.045) * smooth_step(0.0, 0.75, plate) * smooth_step(1.0, 0.78, plate);
    const double rough = 0.012 * fractal_noise(point * 30.0, 3, 311);
    return 0.3 + 0.3 * best + rough + 0.22 * crest;
}

}  // namespace

Sculpture make_knot() {
    const std::vector<double> turns = even_turns(kKnotTube.along);
    const auto row_frame = [&](double along) {
        return knot_frame(turns[static_cast<std::size_t>(std::floor(along * kKnotTube.along + 0.5))]);
    };
    return {make_tube(kKnotTube, kKnotRadius, row_frame), [](const Sample& p) {
                const double along = kKnotTube.along01(p), around = kKnotTube.around01(p);
                const double a = 2.0 * kPi * along, b = 2.0 * kPi * around;
                const glm::dvec3 point{cosine(a) * (2.0 + 0.3 * cosine(b)), sine(a) * (2.0 + 0.3 * cosine(b)),
                                       0.3 * sine(b)};
                return scaly_height(along, around, point);
            }};
}

}  // namespace relievo::assets
