// Single things (crater, rivet, star), links of a chain along a stroke (stitch, link), and rough grounds that
// fade out (cracks, pores, ridges).
#include "assets/generator/sample_alphas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

double radius(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// 1 in the middle, 0 from the inscribed circle on.
double fade(double x, double y) {
    return smooth_step(0.97, 0.55, radius(x, y));
}

double crater(double x, double y) {
    const double bend = 0.06 * noise({2.2 * x, 2.2 * y, 0.5}, 3), r = radius(x, y) + bend;
    const double rim = exponential(-(r - 0.6) * (r - 0.6) / (r < 0.6 ? 0.012 : 0.03));
    const double rays = 0.25 * ridged_noise({3.0 * x / (r + 0.2), 3.0 * y / (r + 0.2), 0.0}, 3, 5);
    return clamp01(rim * (0.75 + rays)) * smooth_step(0.97, 0.75, radius(x, y));
}

double rivet(double x, double y) {
    const double r = radius(x, y);
    const double washer = 0.35 * smooth_step(0.88, 0.82, r),
                 bead = r < 0.6 ? 0.65 * std::sqrt(1 - r * r / 0.36) : 0.0;
    return washer + bead;
}

double star(double x, double y) {
    const double sector = 2 * kPi / 5, turned = arc_tangent(x, y) + 20 * sector;
    const double angle = turned - sector * std::floor(turned / sector + 0.5), r = radius(x, y);
    // Distance inside the edge between a tip at 0.9 and a notch at 0.36.
    const double px = r * cosine(angle), py = r * std::abs(sine(angle));
    const double nx = 0.36 * cosine(sector / 2), ny = 0.36 * sine(sector / 2);
    const double inside = (ny * (0.9 - px) - (0.9 - nx) * py) / radius(0.9 - nx, ny);
    return clamp01(inside / 0.29);
}

double stitch(double x, double y) {
    const double along = std::max(0.0, std::abs(x) - 0.62);
    const double across = radius(along, y) / 0.3;
    const double thread = 0.85 + 0.15 * cosine(30 * (x + 0.7 * y));
    return across < 1 ? std::sqrt(1 - across * across) * thread : 0.0;
}

double link(double x, double y) {
    const double along = std::max(0.0, std::abs(x) - 0.38);
    const double tube = (radius(along, y) - 0.4) / 0.16;
    return std::abs(tube) < 1 ? std::sqrt(1 - tube * tube) : 0.0;
}

double cracks(double x, double y) {
    const double wx = x + 0.12 * fractal_noise({2.5 * x, 2.5 * y, 3.0}, 3, 17);
    const double wy = y + 0.12 * fractal_noise({2.5 * x, 2.5 * y, 9.0}, 3, 18);
    const Cells cells = cellular_noise({3.1 * wx, 3.1 * wy, 0.5}, 19);
    return smooth_step(0.16, 0.02, cells.second - cells.nearest) * fade(x, y);
}

double pores(double x, double y) {
    const Cells cells = cellular_noise({6.5 * x, 6.5 * y, 0.5}, 23);
    return dome(std::min(1.0, cells.nearest / 0.62)) * fade(x, y);
}

double ridges(double x, double y) {
    const double bend = 0.25 * noise({1.5 * x, 1.5 * y, 2.0}, 29);
    return clamp01(ridged_noise({1.6 * x, 5.5 * (y + bend), 0.0}, 5, 31)) * fade(x, y);
}

constexpr std::array kAlphas{SampleAlpha{"crater", crater}, SampleAlpha{"rivet", rivet},
                             SampleAlpha{"star", star},     SampleAlpha{"stitch", stitch},
                             SampleAlpha{"link", link},     SampleAlpha{"cracks", cracks},
                             SampleAlpha{"pores", pores},   SampleAlpha{"ridges", ridges}};

}  // namespace

std::span<const SampleAlpha> sample_alphas() {
    return kAlphas;
}

}  // namespace relievo::assets
