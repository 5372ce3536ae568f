// The stamp's frame and the clone tool's source.
#include "editor/gui/tool_marks.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "brushes/tangent_frame.h"
#include "editor/gui/brush_cursor.h"
#include "editor/gui/theme.h"
#include "editor/session/stroke_input.h"
#include "editor/session/view_window.h"

namespace relievo::gui {
namespace {

struct Pen {
    ImDrawList& list;
    const Session& session;
    PixelSize picture;
    double x, y;

    std::optional<ImVec2> on_screen(glm::dvec3 point) const {
        const Scene& scene = session.scene();
        const auto px = project(scene.camera, scene.origin, picture.width, picture.height, glm::vec3(point));
        if (!px) return std::nullopt;
        return ImVec2(static_cast<float>(px->x + x), static_cast<float>(px->y + y));
    }
    void line(glm::dvec3 from, glm::dvec3 to, ImU32 colour) const {
        const auto a = on_screen(from), b = on_screen(to);
        if (!a || !b) return;
        list.AddLine(*a, *b, kRingShadow, points(2.6f));
        list.AddLine(*a, *b, colour, points(1.2f));
    }
};

// The image's outline as a click would put it, with a mark at its upper side.
void stamp_frame(const Pen& pen, const BrushCursor::Look& look) {
    const Alpha& alpha = *pen.session.alpha();
    const glm::dvec3 across =
        glm::normalize(glm::dvec3(look.next_ray.direction)) - glm::normalize(glm::dvec3(look.ray.direction));
    const TangentFrame frame = turned(tangent_frame(glm::dvec3(look.normal), glm::normalize(across)),
                                      static_cast<double>(pen.session.brush().rotation));
    const double unit = static_cast<double>(look.radius) / std::max(alpha.width(), alpha.height());
    const glm::dvec3 centre(look.centre.position);
    const auto corner = [&](double u, double v) {
        return centre + unit * (u * alpha.width() * frame.right + v * alpha.height() * frame.up);
    };
    const std::array corners{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    for (std::size_t i = 0; i < corners.size(); ++i) pen.line(corners[i], corners[(i + 1) % 4], kRing);
    const glm::dvec3 top = corner(0, 1);
    pen.line(top, top + 0.12 * static_cast<double>(look.radius) * frame.up, kAccent);
}

// A cross at the source, and a line from there to the brush.
void clone_mark(const Pen& pen, const BrushCursor::Look& look) {
    const Dab target = quantised_dab(look.centre, 0, 1);
    const auto source = pen.session.clone_source({target.face, target.b1, target.b2});
    if (!source) return;
    constexpr auto kOne = static_cast<float>(Dab::kBarycentricOne);
    const SurfacePoint point = pen.session.surface().at(source->face, static_cast<float>(source->b1) / kOne,
                                                        static_cast<float>(source->b2) / kOne);
    const TangentFrame frame = tangent_frame(glm::dvec3(point.base_normal));
    const glm::dvec3 centre(point.position);
    const double reach = 0.3 * static_cast<double>(look.radius);
    pen.line(centre - reach * frame.right, centre + reach * frame.right, kAccent);
    pen.line(centre - reach * frame.up, centre + reach * frame.up, kAccent);
    if (const auto px = pen.on_screen(centre)) pen.list.AddCircle(*px, points(5), kAccent, 0, points(1.4f));
}

}  // namespace

void draw_tool_marks(ImDrawList& list, const Session& session, const BrushCursor& cursor, PixelSize picture,
                     double x, double y) {
    const auto look = cursor.look();
    if (!look) return;
    const Pen pen{list, session, picture, x, y};
    const Tool tool = session.brush().tool;
    if (tool == Tool::stamp && session.alpha()) stamp_frame(pen, *look);
    if (tool == Tool::clone) clone_mark(pen, *look);
}

}  // namespace relievo::gui
