// Noise and random numbers from hashes of counters.
#include "brushes/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo {
namespace {

// The finaliser of SplitMix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014).
std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

// The dot product with one of the twelve directions to a cube's edges.
double gradient(std::uint64_t hash, double x, double y, double z) {
    const unsigned h = static_cast<unsigned>(hash % 12);
    const double a = h < 8 ? x : y, b = h < 4 ? y : z;
    return ((h & 1u) != 0 ? -a : a) + ((h & 2u) != 0 ? -b : b);
}

double blend(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace

double gradient_noise(glm::dvec3 place, std::uint32_t seed) {
    constexpr double kFar = 1e15;
    if (!(std::abs(place.x) < kFar && std::abs(place.y) < kFar && std::abs(place.z) < kFar)) return 0.0;
    const std::array<double, 3> whole{std::floor(place.x), std::floor(place.y), std::floor(place.z)};
    const double x = place.x - whole[0], y = place.y - whole[1], z = place.z - whole[2];
    std::array<double, 8> corner;
    for (unsigned c = 0; c < 8; ++c) {
        std::uint64_t hash = seed;
        for (unsigned k = 0; k < 3; ++k)
            hash =
                mixed(hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(whole[k]) + (c >> k & 1u)));
        corner[c] = gradient(hash, x - (c & 1u), y - (c >> 1 & 1u), z - (c >> 2 & 1u));
    }
    const auto lerp = [](double t, double a, double b) { return a + t * (b - a); };
    const double u = blend(x), v = blend(y), w = blend(z);
    const double sum = lerp(w, lerp(v, lerp(u, corner[0], corner[1]), lerp(u, corner[2], corner[3])),
                            lerp(v, lerp(u, corner[4], corner[5]), lerp(u, corner[6], corner[7])));
    return std::clamp(sum, -1.0, 1.0);
}

double random_number(std::uint32_t seed, std::uint32_t counter, std::uint32_t dimension) {
    const std::uint64_t hash = mixed(mixed(std::uint64_t{seed} << 32 | counter) ^ dimension);
    return static_cast<double>(hash >> 11) * 0x1p-53;
}

}  // namespace relievo
