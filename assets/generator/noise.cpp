// Hashed gradient, fractal and cellular noise.
#include "assets/generator/noise.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

std::uint32_t lattice(double x) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(x));
}

// Dot product with one of 16 gradients: Perlin's twelve edge directions, four of them twice.
double slope(std::uint32_t h, double x, double y, double z) {
    const std::uint32_t k = h >> 28;
    const double u = k < 8 ? x : y;
    const double v = k < 4 ? y : (k == 12 || k == 14) ? x : z;
    return ((k & 1) ? -u : u) + ((k & 2) ? -v : v);
}

double fade(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9e3779b9u + 0x7f4a7c15u;
    for (const std::uint32_t word : {x, y, z}) {
        h ^= word * 0xcc9e2d51u;
        h = (h << 13 | h >> 19) * 0x1b873593u + 0xe6546b64u;
    }
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return h ^ h >> 16;
}

double hash01(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed) {
    return static_cast<double>(hash(x, y, z, seed)) / 4294967296.0;
}

double noise(glm::dvec3 p, std::uint32_t seed) {
    const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
    const std::uint32_t ix = lattice(fx), iy = lattice(fy), iz = lattice(fz);
    const double x = p.x - fx, y = p.y - fy, z = p.z - fz;
    double corner[8];
    for (std::uint32_t k = 0; k < 8; ++k) {
        const std::uint32_t dx = k & 1, dy = k >> 1 & 1, dz = k >> 2;
        corner[k] = slope(hash(ix + dx, iy + dy, iz + dz, seed), x - dx, y - dy, z - dz);
    }
    const double u = fade(x), v = fade(y), w = fade(z);
    const double low = mix(mix(corner[0], corner[1], u), mix(corner[2], corner[3], u), v);
    const double high = mix(mix(corner[4], corner[5], u), mix(corner[6], corner[7], u), v);
    return mix(low, high, w);
}

double fractal_noise(glm::dvec3 p, int octaves, std::uint32_t seed) {
    double sum = 0.0, weight = 0.5;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * noise(p, seed + static_cast<std::uint32_t>(i));
        p = p * 2.0 + glm::dvec3(0.37, 0.61, 0.13);  // no lattice point stays one in every octave
        weight *= 0.5;
    }
    return sum * 1.4;
}

double ridged_noise(glm::dvec3 p, int octaves, std::uint32_t seed) {
    double sum = 0.0, weight = 0.5, total = 0.0;
    for (int i = 0; i < octaves; ++i) {
        const double crest = 1.0 - std::fabs(noise(p, seed + static_cast<std::uint32_t>(i)));
        sum += weight * crest * crest;
        total += weight;
        p = p * 2.0 + glm::dvec3(0.37, 0.61, 0.13);
        weight *= 0.5;
    }
    return clamp01(sum / total);
}

Cells cellular_noise(glm::dvec3 p, std::uint32_t seed) {
    const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
    double nearest = 1e9, second = 1e9;
    std::uint32_t id = 0;
    for (int k = 0; k < 27; ++k) {
        const double cx = fx + k % 3 - 1, cy = fy + k / 3 % 3 - 1, cz = fz + k / 9 - 1;
        const std::uint32_t h = hash(lattice(cx), lattice(cy), lattice(cz), seed);
        const double x = cx + (h & 1023) / 1024.0 - p.x;
        const double y = cy + (h >> 10 & 1023) / 1024.0 - p.y;
        const double z = cz + (h >> 20 & 1023) / 1024.0 - p.z;
        const double d = x * x + y * y + z * z;
        if (d < nearest) {
            second = nearest;
            nearest = d;
            id = h;
        } else if (d < second) {
            second = d;
        }
    }
    return {std::sqrt(nearest), std::sqrt(second), id};
}

namespace {

std::uint32_t wrapped(double x, std::uint32_t period) {
    return static_cast<std::uint32_t>(x - std::floor(x / period) * period) % period;
}

}  // namespace

double tiled_noise(double x, double y, std::uint32_t period, std::uint32_t seed) {
    const double fx = std::floor(x), fy = std::floor(y), px = x - fx, py = y - fy;
    double corner[4];
    for (int k = 0; k < 4; ++k) {
        const double dx = k & 1, dy = k >> 1;
        const std::uint32_t h = hash(wrapped(fx + dx, period), wrapped(fy + dy, period), period, seed);
        corner[k] = slope(h, px - dx, py - dy, 0.0);
    }
    return mix(mix(corner[0], corner[1], fade(px)), mix(corner[2], corner[3], fade(px)), fade(py));
}

Cells tiled_cellular_noise(double x, double y, std::uint32_t period, std::uint32_t seed) {
    const double fx = std::floor(x), fy = std::floor(y);
    double nearest = 1e9, second = 1e9;
    std::uint32_t id = 0;
    for (int k = 0; k < 9; ++k) {
        const double cx = fx + k % 3 - 1, cy = fy + k / 3 - 1;
        const std::uint32_t h = hash(wrapped(cx, period), wrapped(cy, period), period, seed);
        const double dx = cx + (h & 1023) / 1024.0 - x, dy = cy + (h >> 10 & 1023) / 1024.0 - y;
        const double d = dx * dx + dy * dy;
        if (d < nearest) {
            second = nearest;
            nearest = d;
            id = h;
        } else if (d < second) {
            second = d;
        }
    }
    return {std::sqrt(nearest), std::sqrt(second), id};
}

glm::dvec3 scattered_direction(int i, int count, std::uint32_t seed) {
    const auto n = static_cast<std::uint32_t>(i);
    const double golden_turn = 2.39996322972865332;
    const double jitter = 0.9 * (hash01(n, 1, 0, seed) - 0.5);
    const double y = 1.0 - 2.0 * clamp01((i + 0.5 + jitter) / count);
    const double angle = i * golden_turn + 1.5 * hash01(n, 2, 0, seed);
    const double r = std::sqrt(1.0 - y * y);
    return {r * cosine(angle), y, r * sine(angle)};
}

}  // namespace relievo::assets
