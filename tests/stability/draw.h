// Random numbers that a test draws its cases from: the same for a seed on every machine.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <random>

namespace relievo::stability {

class Draw {
  public:
    explicit Draw(unsigned seed) : generator_(seed) {}

    double between(double low, double high) { return std::uniform_real_distribution(low, high)(generator_); }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    int whole(int low, int high) { return std::uniform_int_distribution(low, high)(generator_); }
    bool coin() { return whole(0, 1) == 1; }
    glm::dvec3 vector(double reach) {
        const double x = between(-reach, reach), y = between(-reach, reach), z = between(-reach, reach);
        return {x, y, z};
    }
    glm::dvec3 direction() {
        const double z = between(-1, 1), angle = between(0, 6.283), flat = std::sqrt(1 - z * z);
        return {flat * std::cos(angle), flat * std::sin(angle), z};
    }

  private:
    std::mt19937 generator_;
};

}  // namespace relievo::stability
