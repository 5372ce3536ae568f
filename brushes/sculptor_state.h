// What a sculptor holds: map, mask and colours, and of a stroke under way its tiles and its branches. Private to
// sculptor*.cpp.
#pragma once

#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "brushes/paint_stroke.h"
#include "brushes/saved_heights.h"
#include "brushes/sculptor.h"
#include "brushes/seams.h"
#include "brushes/stroke_tiles.h"
#include "brushes/symmetry.h"
#include "brushes/undo_stack.h"

namespace relievo {

struct Hold;  // dab_tools.h

struct Sculptor::State {
    State(HeightMap& the_map, const Surface& the_surface, std::size_t budget)
        : map(the_map),
          surface(the_surface),
          seams(surface, map.width(), map.height()),
          undo(budget),
          saved(map) {}

    void require_stroke(bool wanted, const char* what) const {
        if (stroke.has_value() == wanted) return;
        throw std::logic_error(
            std::string("Sculptor::") + what +
            (wanted ? " needs a stroke: call begin first" : " during a stroke: end it first"));
    }

    // The hand (first) or a copy by symmetry, with what the stroke remembers of it, in its own frame.
    struct Branch {
        std::unique_ptr<TurnedSurface> turned;    // null without symmetry
        std::optional<glm::vec3> last_place;      // of the last dab, world units
        std::optional<glm::dvec3> last_in_world;  // the same in world space, not in its own frame
        glm::vec3 motion{0};                      // from the dab before to the last one; 0 after a jump
        std::shared_ptr<Hold> hold;

        void move_to(glm::vec3 place, float jump) {
            motion = last_place ? place - *last_place : glm::vec3(0);
            if (!(glm::length(motion) < jump)) motion = glm::vec3(0);
            last_place = place;
        }
    };

    const Surface& surface_of(const Branch& branch) const { return branch.turned ? *branch.turned : surface; }
    SurfacePoint seen(const Branch& branch, const FacePoint& point) const {
        constexpr float kUnit = 1.0f / static_cast<float>(Dab::kBarycentricOne);
        return surface_of(branch).at(point.face, static_cast<float>(point.b1) * kUnit,
                                     static_cast<float>(point.b2) * kUnit);
    }

    Layer layer() const { return brush.tool == Tool::mask ? Layer::mask : Layer::height; }
    Across across() const { return layer() == Layer::height ? Across::slopes : Across::values; }
    HeightMap& map_of(Layer which) {
        switch (which) {
            case Layer::height:
                return map;
            case Layer::mask:
                return need_mask();
            default:
                return colours->plane(static_cast<std::size_t>(which) - static_cast<std::size_t>(Layer::red));
        }
    }
    HeightMap& need_mask() {
        if (!mask) mask.emplace(map.width(), map.height(), std::uint16_t{0});
        return *mask;
    }
    // What protects texels from the stroke's tool.
    const HeightMap* protection() const { return layer() == Layer::height && mask ? &*mask : nullptr; }
    std::vector<TexelRect> shown(std::vector<TexelRect> rects, Layer which);
    void note_painted(std::vector<TexelRect> rects) {
        painted.insert(painted.end(), rects.begin(), rects.end());
    }

    void start(const Brush& the_brush, std::shared_ptr<const Alpha> the_alpha);
    // Where each branch's hand is, or takes from.
    using Points = std::span<const FacePoint>;
    // Takes a checked dab in steps of the drag that grab can follow.
    void apply(const Dab& dab, Points copies, Points sources);
    void apply_step(const Dab& dab, Points copies, Points sources, glm::vec3 drag);
    std::vector<TexelRect> take(bool redo);
    void finish_stroke();
    void push_step();
    using MaskChange = std::function<void(HeightMap&, const Advance&)>;
    void change_mask(const MaskChange& change, const Advance& advance);

    HeightMap& map;
    const Surface& surface;
    Seams seams;
    UndoStack undo;
    SavedHeights saved;
    std::optional<HeightMap> mask;
    std::uint64_t mask_revision = 0;
    Brush brush;
    std::shared_ptr<const Alpha> alpha;
    std::optional<StrokeTiles> stroke;  // over the brush's layer
    std::optional<PaintStroke> paint;   // where the stroke paints
    ColourMap* colours = nullptr;
    std::vector<TexelRect> painted;  // since take_painted(), each within one tile
    std::vector<Branch> branches;
    std::optional<std::size_t> at_once;  // copies in work, as the stroke's first dab says; empty before
    glm::vec3 last_drag{0};              // world units
    std::size_t clipped = 0;             // of the last stroke
};

}  // namespace relievo
