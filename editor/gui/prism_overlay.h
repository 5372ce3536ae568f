// Draws the base mesh and its prisms over the picture.
#pragma once

#include "editor/gui/layout.h"
#include "editor/gui/prism_lines.h"

struct ImDrawList;

namespace relievo::gui {

class PrismOverlay {
  public:
    // `box`: the picture on screen; `pointer` in its pixels.
    void draw(ImDrawList& list, const Session& session, const Box& box,
              const std::optional<glm::dvec2>& pointer);
    const std::string& note() const { return note_; }  // of the last draw

  private:
    PrismLines prisms_;
    std::string note_;
};

}  // namespace relievo::gui
