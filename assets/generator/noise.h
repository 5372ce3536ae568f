// Deterministic noise over 3D points: hashes of integer lattice points, so the same everywhere and for any
// thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace relievo::assets {

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed);
double hash01(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed);  // [0, 1)

// Gradient noise with features of size 1 (Perlin, "Improving noise", 2002, with hashed gradients): about [-1,
// 1], 0 at lattice points, C2.
double noise(glm::dvec3 p, std::uint32_t seed);

// Octaves of noise, each of twice the frequency and half the height: about [-1, 1].
double fractal_noise(glm::dvec3 p, int octaves, std::uint32_t seed);

// Fractal noise with sharp crests, [0, 1].
double ridged_noise(glm::dvec3 p, int octaves, std::uint32_t seed);

// Cellular noise (Worley 1996), one hashed point in each unit cell.
struct Cells {
    double nearest, second;  // distances to the nearest and second nearest point
    std::uint32_t id;        // hash of the nearest point's cell
};
Cells cellular_noise(glm::dvec3 p, std::uint32_t seed);

// The same two in the plane, with the whole number `period` as their period along both axes.
double tiled_noise(double x, double y, std::uint32_t period, std::uint32_t seed);
Cells tiled_cellular_noise(double x, double y, std::uint32_t period, std::uint32_t seed);

// The i-th of `count` points spread evenly and irregularly over the unit sphere.
glm::dvec3 scattered_direction(int i, int count, std::uint32_t seed);

}  // namespace relievo::assets
