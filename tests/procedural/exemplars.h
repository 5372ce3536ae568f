// Exemplars that tests make.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/procedural/procedural_source.h"

namespace relievo {

struct Exemplar {
    int width = 0, height = 0;
    std::vector<std::uint16_t> texels;

    ProceduralSource source(const Procedural& settings) const {
        return {settings, width, height, texels.data()};
    }
};

// Smooth noise that repeats, its histogram far from Gaussian: most of it low, few high places.
Exemplar rough_exemplar(int width, int height);
// Every texel a value of its own, at random.
Exemplar noise_exemplar(int width, int height);
Exemplar constant_exemplar(int width, int height, std::uint16_t value);
// 0 and 65535 by turns.
Exemplar two_valued_exemplar(int width, int height);

}  // namespace relievo
