// The way of the hand since its last dab. Where a stroke keeps the strongest of its dabs, rather than their sum, each
// ball alone would leave a rib behind: half way to the next one, even the best weight is less than in the middle. So
// distances are those from the way between the two, and a stroke weighs as its line does.
//
// Dabs further apart than half the radius are meant to be seen one by one; from a quarter on the trail grows shorter.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace relievo {

class DabTrail {
  public:
    // `motion`: from the last dab's centre to this one's.
    DabTrail(glm::vec3 centre, glm::vec3 motion, float radius) : centre_(centre) {
        constexpr float kWhole = 0.25f, kNone = 0.5f;  // of the radius
        const float way = glm::length(motion) / radius;
        if (!(way > 0.0f && way < kNone)) return;
        back_ = -std::min(1.0f, (kNone - way) * (kWhole / ((kNone - kWhole) * way))) * motion;
    }

    bool is_point() const { return back_ == glm::vec3(0); }
    float distance(glm::vec3 place) const {
        const glm::vec3 offset = place - centre_;
        const float part = std::clamp(glm::dot(offset, back_) / glm::dot(back_, back_), 0.0f, 1.0f);
        return glm::length(offset - part * back_);
    }
    // A ball that holds all that is nearer than `radius`.
    glm::vec3 middle() const { return centre_ + 0.5f * back_; }
    float reach(float radius) const { return radius + 0.5f * glm::length(back_); }

  private:
    glm::vec3 centre_, back_{0};
};

}  // namespace relievo
