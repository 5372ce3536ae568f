// A torus of fur: hairs one or two texels wide at every map size, the hard case for methods that sample along
// rays.
#include <algorithm>
#include <cmath>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr Tube kFurTube{24, 80, 2, 5, 6};
constexpr double kFurCore = 0.8, kFurRadius = 0.27;          // world units
constexpr double kCellAcross = 3.2, kCellAlong = 7.0;  // texels: one hair in each cell
constexpr std::uint32_t kSeed = 401;

TubeFrame torus_frame(double along) {
    const double angle = 2.0 * kPi * along;
    const glm::dvec3 out{cosine(angle), 0.0, sine(angle)};
    return {kFurCore * out, out, {0.0, 1.0, 0.0}};
}

// The grid of hairs over the whole torus, in texels of the map; it closes around both ways.
struct Hairs {
    double width, length;  // of the torus' surface in the map, texels
    int across, along;     // cells

    explicit Hairs(double pitch)
        : width(kFurTube.around * kFurTube.cell_w / pitch),
          length(kFurTube.along * kFurTube.cell_h / pitch),
          across(std::max(1, static_cast<int>(width / kCellAcross))),
          along(std::max(1, static_cast<int>(length / kCellAlong))) {}

    // Height of the hair of a cell at a texel; 0 where it is not. A hair starts at a jittered root, runs
    // along the torus, bends aside, thins out and rises to its tip.
    double hair(int cell_x, int cell_y, double x, double y) const {
        const auto wx = static_cast<std::uint32_t>((cell_x + across) % across);
        const auto wy = static_cast<std::uint32_t>((cell_y + along) % along);
        const double cell_w = width / across, cell_l = length / along;
        const double root_x = (cell_x + hash01(wx, wy, 0, kSeed)) * cell_w;
        const double root_y = (cell_y + hash01(wx, wy, 1, kSeed)) * cell_l;
        const double reach = cell_l * (1.5 + 1.4 * hash01(wx, wy, 2, kSeed));
        const double forward = (y - root_y) / reach;
        if (forward < 0.0 || forward > 1.0) return 0.0;
        const double bend = cell_w * (2.6 * hash01(wx, wy, 3, kSeed) - 1.3 + comb(root_x, root_y));
        const double aside = std::fabs(x - root_x - bend * forward * forward);
        const double half_width = mix(1.0, 0.5, forward);  // two texels at the root, one at the tip
        if (aside > half_width) return 0.0;
        const double tall = 0.65 + 0.35 * hash01(wx, wy, 4, kSeed);
        return tall * (0.25 + 0.75 * forward);
    }

    // The way the coat is combed: slow waves around the torus.
    double comb(double x, double y) const {
        const double a = 2.0 * kPi * y / length, b = 2.0 * kPi * x / width;
        return 2.2 * sine(5.0 * a + 1.5 * sine(b)) + 1.1 * sine(2.0 * b + 3.0 * a);
    }
};

double fur_height(const Sample& p) {
    const Hairs hairs(p.pitch);
    const double x = p.x / p.pitch;
    const double y = (kFurTube.first_row(p.island) * kFurTube.cell_h + p.y) / p.pitch;
    const int cell_x = static_cast<int>(std::floor(x / hairs.width * hairs.across));
    const int cell_y = static_cast<int>(std::floor(y / hairs.length * hairs.along));
    double best = 0.0;
    for (int j = cell_y - 3; j <= cell_y; ++j)
        for (int i = cell_x - 5; i <= cell_x + 5; ++i) best = std::max(best, hairs.hair(i, j, x, y));
    const double a = 2.0 * kPi * y / hairs.length, b = 2.0 * kPi * x / hairs.width;
    const double tufts =
        0.5 + 0.5 * noise({3.0 * cosine(a) + cosine(b), 3.0 * sine(a), 1.5 * sine(b)}, kSeed + 1);
    return 0.3 + (0.5 + 0.2 * tufts) * best;
}

}  // namespace

Sculpture make_fur() {
    return {make_tube(kFurTube, kFurRadius, torus_frame), fur_height};
}

}  // namespace relievo::assets
