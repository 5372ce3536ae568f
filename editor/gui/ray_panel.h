// The panel "why this pixel": what happened to one ray, beside the picture's pixel that was clicked.
#pragma once

#include <optional>
#include <string>

#include "editor/gui/layout.h"
#include "editor/session/ray_report.h"

struct ImDrawList;

namespace relievo::gui {

class RayPanel {
  public:
    // Logs the ray and asks the reference about it.
    void ask(Renderer& renderer, LiveReference& reference, const std::string& method,
             const glm::ivec2& pixel);
    void close() { report_.reset(); }
    bool is_open() const { return report_.has_value(); }
    // Window pixels; what lies under the panel is not for the picture.
    bool holds(double x, double y) const { return is_open() && box_.holds(x, y); }

    void draw(const Session& session, LiveReference& reference, const Box& picture);
    // Marks the point that was asked about.
    void draw_mark(ImDrawList& list, const Session& session, const Box& picture) const;

  private:
    void draw_heading(const Scene& scene);
    void draw_visits(const Scene& scene);

    std::optional<RayReport> report_;
    std::optional<ReferenceVerdict> verdict_;
    Box box_;        // of the panel
    Box placed_in_;  // the picture when it was placed
    bool fresh_ = false, at_left_ = true;
};

}  // namespace relievo::gui
