// The surface under the pointer: its height, and the brush's circle lying on it.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "editor/gui/live_picture.h"
#include "editor/session/session.h"

struct ImDrawList;

namespace relievo::gui {

class BrushCursor {
  public:
    struct Spot {
        double height = 0;  // of the surface over its base, world units
        double counts = 0;  // of the map there, [0, 65535]
    };

    // Looks at the surface under (x, y), pixels of the picture on screen.
    void follow(Session& session, const LivePicture& live, double x, double y);
    // The brush's size has changed while the pointer chooses it: the circle stays where it is.
    void resize(Session& session);
    void hide() { centre_.reset(); }

    std::optional<PickHit> hit() const { return centre_; }  // of the surface under the pointer
    // What it stands on, for marks of other tools.
    struct Look {
        PickHit centre;
        glm::vec3 normal;   // of the base surface there, unit
        float radius;       // of the brush, world units
        Ray ray, next_ray;  // through the pointer, and one pixel beside it
    };
    std::optional<Look> look() const;  // empty: the pointer is not over the edited object

    std::optional<Spot> spot() const;  // empty: the pointer is not over the edited object
    // `x`, `y`: the picture's corner on screen. `lit`: while a stroke runs.
    void draw(ImDrawList& list, Session& session, PixelSize picture, double x, double y, bool lit) const;

  private:
    std::optional<PickHit> centre_;
    Ray ray_{}, next_ray_{};  // through the pointer, and one pixel beside it
    glm::vec3 normal_{0};     // of the base surface there, unit
    float radius_ = 0;        // of the ring, world units
    Spot spot_;
    std::vector<glm::vec3> ring_;  // points on the surface, rebased space
};

}  // namespace relievo::gui
