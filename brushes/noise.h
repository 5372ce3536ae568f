// Gradient noise over space, after K. Perlin, "Improving Noise", SIGGRAPH 2002: quintic blending of gradients
// at the corners of a lattice. Deviation: gradients come from a counter-based hash, not from a table, so that
// it never repeats and the seed is free.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace relievo {

// In [-1, 1], 0 at every whole place, features of size 1. 0 where the place is not finite.
double gradient_noise(glm::dvec3 place, std::uint32_t seed);

// A number of [0, 1) for a counter: the same on every machine.
double random_number(std::uint32_t seed, std::uint32_t counter, std::uint32_t dimension);

}  // namespace relievo
