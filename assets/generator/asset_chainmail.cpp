// A sheet of mail, four rings in one, draped as if over a ball: holes by an opacity map, wires by
// displacement.
#include <algorithm>
#include <cmath>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr Sheet kSheet{26, 27, 2, 9};
constexpr double kSize = 2.0;  // world units along the columns

// The weave, in ring radii: rings of a row stand kAcross apart, rows kUp apart and shifted by half.
constexpr double kRing = 1.0, kWire = 0.2, kAcross = 2.5, kUp = 1.02;
constexpr int kRingsAcross = 16;
constexpr double kWidth = kRingsAcross * kAcross;  // of the sheet
constexpr double kHeight = kWidth * kSheet.rows / kSheet.columns;
constexpr double kLean = 0.42;  // sine of a ring's tilt: every other row leans the other way

struct Wire {
    double distance;  // from the wire's middle, over its radius: under 1 on a wire
    double height;    // in ring radii
};

// The nearest wire or, where wires overlap, the upper one.
Wire wire_at(double x, double y) {
    Wire best{1e9, 0.0};
    bool solid = false;
    const int row = static_cast<int>(std::floor(y / kUp));
    const int rows = static_cast<int>(std::floor((kHeight - 2.4 * kRing) / kUp));
    for (int j = std::max(0, row - 3); j <= std::min(rows, row + 2); ++j) {
        const bool odd = j & 1;
        const double centre_y = 1.2 + j * kUp;
        const int column = static_cast<int>(std::floor(x / kAcross - (odd ? 0.5 : 0.0)));
        for (int i = std::max(0, column - 1); i <= std::min(kRingsAcross - (odd ? 2 : 1), column + 1); ++i) {
            const double centre_x = (i + (odd ? 1.0 : 0.5)) * kAcross;
            const double dx = x - centre_x, dy = (y - centre_y) / 0.95;
            const double r = std::sqrt(dx * dx + dy * dy);
            const double distance = std::fabs(r - kRing) / kWire;
            const double lean = r > 0.0 ? kLean * (odd ? -dy : dy) / r : 0.0;
            const double round = std::sqrt(std::max(0.0, 1.0 - distance * distance));
            const double height = lean + kWire * (round - 1.0);
            const bool on_wire = distance < 1.0;
            if (on_wire ? !solid || height > best.height : !solid && distance < best.distance)
                best = {distance, height};
            solid = solid || on_wire;
        }
    }
    return best;
}

Wire wire_at(const Sample& p) {
    return wire_at(kSheet.s01(p) * kWidth, kSheet.t01(p) * kHeight);
}

glm::dvec3 draped(double s, double t) {
    const double x = (s - 0.5) * kSize, y = (t - 0.5) * kSize * kSheet.rows / kSheet.columns;
    const double r2 = x * x + y * y;
    const double folds = 0.06 * sine(5.0 * x + 1.2 * y) * smooth_step(0.0, 1.0, 0.5 - t) +
                         0.05 * sine(3.4 * y - 0.7) * smooth_step(0.2, 1.0, std::fabs(x));
    return {x * (1.0 - 0.06 * r2), y * (1.0 - 0.05 * r2), 0.42 * dome(std::sqrt(r2) / 1.5) + folds};
}

}  // namespace

Sculpture make_chainmail() {
    return {make_sheet(kSheet, draped),
            [](const Sample& p) {
                const double rust = 0.012 * noise({p.s * 5.0, p.t * 5.0, 0.5}, 201);
                return 0.52 + 0.42 * wire_at(p).height + rust * 0.5;
            },
            {},
            [](const Sample& p) { return smooth_step(1.2, 0.9, wire_at(p).distance); }};
}

}  // namespace relievo::assets
