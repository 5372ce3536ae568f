// A turned and carved sphere: a belt with a running plait, fluted zones, rings of beads, rosettes at the
// poles.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "assets/generator/builders.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

double window(double x, double low, double high, double soft) {
    return smooth_step(low, low + soft, x) * smooth_step(high, high - soft, x);
}

// A round moulding of the given half width, with flanks that end at a finite slope: a map cannot hold a
// vertical wall.
double moulding(double x, double half_width) {
    const double r = x / half_width, rest = 1.0 - r * r;
    return rest > 0.0 ? 1.2 * rest / (rest + 0.2) : 0.0;
}

// Distance to the nearest whole number.
double to_whole(double x) {
    return std::fabs(x - std::floor(x + 0.5));
}

// Two strands that pass over and under each other, with a bead in every eye. turns in [0, 1).
double plait(double latitude, double turns) {
    constexpr double kWaves = 14.0, kReach = 0.115, kStrand = 0.042;
    const double phase = 2.0 * kPi * kWaves * turns;
    const double swing = kReach * sine(phase), slope = kReach * kWaves * cosine(phase);
    const double across = 1.0 / std::sqrt(1.0 + slope * slope);  // from vertical distance to distance
    const double first = moulding((latitude - swing) * across, kStrand) * (0.8 + 0.2 * cosine(phase));
    const double second = moulding((latitude + swing) * across, kStrand) * (0.8 - 0.2 * cosine(phase));
    const double eye = (to_whole(2.0 * kWaves * turns - 0.5)) / (2.0 * kWaves) * 2.0 * kPi;
    const double bead = moulding(std::sqrt(eye * eye + latitude * latitude), 0.05);
    return std::max(std::max(first, second), 0.95 * bead);
}

// A ring of beads around a parallel.
double beads(double from_parallel, double turns, double count, double cosine_latitude, double radius) {
    const double along = to_whole(count * turns) / count * 2.0 * kPi * cosine_latitude;
    return moulding(std::sqrt(along * along + from_parallel * from_parallel), radius);
}

// Flutes: rounded lobes that end in round tips at both parallels.
double flutes(double latitude, double turns, double count) {
    const double across = 2.0 * to_whole(count * turns);  // 0 on a lobe's crest, 1 between lobes
    const double along = (latitude - 0.66) / 0.25;        // -1 and 1 at its ends
    const double r = across * across + along * along * along * along;
    return r < 1.0 ? 1.15 * (1.0 - r) / (1.15 - r) : 0.0;
}

// Two rows of petals around a boss. `from_pole` in radians.
double rosette(double from_pole, double turns) {
    const double inner = 0.5 + 0.5 * cosine(2.0 * kPi * 8.0 * turns);
    const double outer = 0.5 - 0.5 * cosine(2.0 * kPi * 8.0 * turns);
    const double first = dome(from_pole / (0.16 + 0.11 * inner));
    const double second = dome(from_pole / (0.2 + 0.2 * outer));
    const double boss = moulding(from_pole, 0.085);
    const double vein = 0.25 * dome(to_whole(8.0 * turns) / 0.06) * window(from_pole, 0.1, 0.3, 0.05);
    return std::max(std::max(0.75 * std::sqrt(first) - vein, 0.5 * std::sqrt(second)), boss);
}

double carved_height(glm::dvec3 d) {
    const double level = std::sqrt(d.x * d.x + d.z * d.z);
    const double latitude = std::fabs(arc_tangent(d.y, level));  // both halves alike, but for the plait
    const double signed_latitude = arc_tangent(d.y, level);
    const double turns = arc_tangent(d.z, d.x) / (2.0 * kPi) + 0.5;
    double h = 0.44;
    h += 0.17 * plait(signed_latitude, turns) * smooth_step(0.2, 0.17, latitude);
    h += 0.16 * moulding(latitude - 0.24, 0.032) + 0.09 * moulding(latitude - 0.31, 0.022);
    h += 0.2 * flutes(latitude, turns, 24.0) + 0.05 * window(latitude, 0.36, 0.98, 0.03);
    h += 0.14 * moulding(latitude - 1.0, 0.024);
    h += 0.17 * beads(latitude - 1.085, turns, 36.0, level, 0.04);
    h += 0.12 * moulding(latitude - 1.16, 0.022);
    h += 0.22 * rosette(kPi / 2.0 - latitude, turns) * smooth_step(1.17, 1.2, latitude);
    return h;
}

}  // namespace

Sculpture make_orb() {
    return {make_ball(), [](const Sample& p) { return carved_height(kBall.direction(p.island, p.s, p.t)); }};
}

}  // namespace relievo::assets
