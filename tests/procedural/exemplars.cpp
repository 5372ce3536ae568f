// See exemplars.h.
#include "tests/procedural/exemplars.h"

#include <cmath>
#include <numbers>
#include <random>

namespace relievo {
namespace {

template <typename Value>
Exemplar make(int width, int height, Value value) {
    Exemplar e{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) e.texels.push_back(value(x, y));
    return e;
}

}  // namespace

Exemplar rough_exemplar(int width, int height) {
    std::mt19937 random(7);
    struct Wave {
        double u, v, phase, size;
    };
    std::vector<Wave> waves;
    for (int i = 0; i < 24; ++i) {
        const auto frequency = [&] { return static_cast<double>(static_cast<int>(random() % 15) - 7); };
        waves.push_back({frequency(), frequency(), static_cast<double>(random() % 1000) * 0.00628, 1});
    }
    return make(width, height, [&](int x, int y) {
        double sum = 0;
        for (const Wave& w : waves)
            sum += std::sin(2 * std::numbers::pi * (w.u * x / width + w.v * y / height) + w.phase);
        return static_cast<std::uint16_t>(std::lround(65535 / (1 + std::exp(1.5 - 0.5 * sum))));
    });
}

Exemplar noise_exemplar(int width, int height) {
    std::mt19937 random(11);
    return make(width, height, [&](int, int) { return static_cast<std::uint16_t>(random() & 0xffffu); });
}

Exemplar constant_exemplar(int width, int height, std::uint16_t value) {
    return make(width, height, [&](int, int) { return value; });
}

Exemplar two_valued_exemplar(int width, int height) {
    return make(width, height,
                [](int x, int y) { return static_cast<std::uint16_t>((x + y) % 2 == 0 ? 0 : 65535); });
}

}  // namespace relievo
