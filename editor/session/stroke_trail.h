// Which way a stroke goes: from a point that follows it as a toy on a string follows the hand, so that the
// direction changes evenly though the path is known only from pixel to pixel.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace relievo {

class StrokeTrail {
  public:
    explicit StrokeTrail(double string) : string_(string) {}  // world units

    void start(glm::dvec3 place) { toy_ = hand_ = place; }
    void go_to(glm::dvec3 place) {
        hand_ = place;
        const glm::dvec3 way = hand_ - toy_;
        const double length = glm::length(way);
        if (length > string_) toy_ = hand_ - way * (string_ / length);
    }
    // How far the hand is from what it pulls, at most the string.
    double stretched() const { return glm::length(hand_ - toy_); }
    // Not unit; zero where the hand has not moved.
    glm::dvec3 direction() const { return hand_ - toy_; }

  private:
    double string_;
    glm::dvec3 toy_{0}, hand_{0};
};

}  // namespace relievo
