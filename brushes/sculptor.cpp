// A stroke from begin to end: dabs to tools, seams after every dab, one quantised state, one undo step.
#include "brushes/sculptor.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "brushes/dab_tools.h"
#include "brushes/seams.h"
#include "brushes/stroke_tiles.h"
#include "brushes/undo_stack.h"

namespace relievo {

struct Sculptor::State {
    State(HeightMap& the_map, const Surface& the_surface, std::size_t budget)
        : map(the_map), surface(the_surface), seams(surface, map.width(), map.height()), undo(budget) {}

    void require_stroke(bool wanted, const char* what) const {
        if (stroke.has_value() == wanted) return;
        throw std::logic_error(
            std::string("Sculptor::") + what +
            (wanted ? " needs a stroke: call begin first" : " during a stroke: end it first"));
    }

    HeightMap& map;
    const Surface& surface;
    Seams seams;
    UndoStack undo;
    // Takes a checked dab in steps of the drag that grab can follow.
    void apply(const Dab& dab);
    void apply_step(const Dab& dab, glm::vec3 drag);

    Brush brush;
    std::optional<StrokeTiles> stroke;
    std::optional<glm::vec3> last_place;  // of the stroke's last dab, world units
    glm::vec3 last_drag{0};               // world units
    std::shared_ptr<Hold> hold;
    std::size_t clipped = 0;  // of the last stroke
};

void Sculptor::State::apply(const Dab& dab) {
    if (brush.tool != Tool::grab) return apply_step(dab, glm::vec3(0));
    constexpr float kLongestStep = 0.4f;  // of the radius
    constexpr int kMostSteps = 1000;
    const float unit = brush.radius / static_cast<float>(Dab::kDragOne);
    const glm::vec3 from = last_drag;
    const glm::vec3 to = unit * glm::vec3(dab.drag[0], dab.drag[1], dab.drag[2]);
    const float radius = brush.radius * (static_cast<float>(dab.size) / static_cast<float>(Dab::kSizeOne));
    const float way = glm::length(to - from) / (kLongestStep * radius);
    const int steps = static_cast<int>(std::clamp(std::ceil(way), 1.0f, static_cast<float>(kMostSteps)));
    for (int i = 1; i <= steps; ++i)
        apply_step(
            dab, i == steps ? to : from + (static_cast<float>(i) / static_cast<float>(steps)) * (to - from));
    last_drag = to;
}

void Sculptor::State::apply_step(const Dab& dab, glm::vec3 drag) {
    constexpr float kUnit = 1.0f / static_cast<float>(Dab::kBarycentricOne);
    constexpr float kJump = 2.0f;  // radii between dabs beyond which the hand has jumped
    const SurfacePoint centre =
        surface.at(dab.face, static_cast<float>(dab.b1) * kUnit, static_cast<float>(dab.b2) * kUnit);
    glm::vec3 motion = last_place ? centre.position - *last_place : glm::vec3(0);
    if (!(glm::length(motion) < kJump * brush.radius)) motion = glm::vec3(0);
    const DabPlace place{
        centre,
        std::min(static_cast<float>(dab.pressure) / static_cast<float>(Dab::kPressureOne), 1.0f),
        brush.radius * (static_cast<float>(dab.size) / static_cast<float>(Dab::kSizeOne)),
        motion,
        drag,
        hold};
    for (const TexelChange& change : dab_changes(brush, place, surface, seams, *stroke))
        stroke->set_change(change.x, change.y, change.to);
    seams.follow(*stroke);
    last_place = centre.position;
}

Sculptor::Sculptor(HeightMap& map, const Surface& surface, std::size_t undo_budget)
    : state_(std::make_unique<State>(map, surface, undo_budget)) {}

Sculptor::~Sculptor() = default;

void Sculptor::begin(const Brush& brush) {
    state_->require_stroke(false, "begin");
    check_brush(brush);
    state_->brush = brush;
    state_->stroke.emplace(state_->map);
    state_->last_place.reset();
    state_->last_drag = glm::vec3(0);
    state_->hold.reset();
}

std::vector<TexelRect> Sculptor::dab(const Dab& dab) {
    state_->require_stroke(true, "dab");
    if (dab.face >= state_->surface.face_count())
        throw std::out_of_range("dab on face " + std::to_string(dab.face) + " of a mesh with " +
                                std::to_string(state_->surface.face_count()) + " faces");
    if (dab.b1 > Dab::kBarycentricOne || dab.b2 > Dab::kBarycentricOne - dab.b1)
        throw std::out_of_range("dab outside its face: barycentrics " + std::to_string(dab.b1) + " and " +
                                std::to_string(dab.b2) + " must add up to at most " +
                                std::to_string(Dab::kBarycentricOne));
    if (dab.size < 1 || dab.size > Dab::kSizeOne)
        throw std::out_of_range("dab of size " + std::to_string(dab.size) + ": it must be 1 to " +
                                std::to_string(Dab::kSizeOne));
    for (const std::int32_t part : dab.drag)
        if (part < -Dab::kLargestDrag || part > Dab::kLargestDrag)
            throw std::out_of_range("dab with a drag of " + std::to_string(part) + ": it must be at most " +
                                    std::to_string(Dab::kLargestDrag) + " either way");
    state_->apply(dab);
    StrokeTiles& stroke = *state_->stroke;
    return merge_rects(stroke.take_dirty());
}

std::vector<TexelRect> Sculptor::end() {
    state_->require_stroke(true, "end");
    StrokeTiles& stroke = *state_->stroke;
    state_->seams.settle(stroke);
    std::vector<TexelRect> rects = merge_rects(stroke.take_dirty());
    state_->undo.push(stroke, state_->map);
    state_->clipped = stroke.clipped_texels();
    state_->stroke.reset();
    return rects;
}

std::vector<TexelRect> Sculptor::cancel() {
    state_->require_stroke(true, "cancel");
    std::vector<TexelRect> rects = merge_rects(state_->stroke->restore());
    state_->clipped = 0;
    state_->stroke.reset();
    return rects;
}

bool Sculptor::in_stroke() const {
    return state_->stroke.has_value();
}

bool Sculptor::can_undo() const {
    return state_->undo.can_undo();
}
bool Sculptor::can_redo() const {
    return state_->undo.can_redo();
}

std::vector<TexelRect> Sculptor::undo() {
    state_->require_stroke(false, "undo");
    state_->clipped = 0;  // no longer of the map's last change
    return merge_rects(state_->undo.undo(state_->map));
}

std::vector<TexelRect> Sculptor::redo() {
    state_->require_stroke(false, "redo");
    state_->clipped = 0;
    return merge_rects(state_->undo.redo(state_->map));
}

std::uint64_t Sculptor::steps_made() const {
    return state_->undo.pushed();
}
std::size_t Sculptor::undo_bytes() const {
    return state_->undo.bytes();
}
std::size_t Sculptor::undo_budget() const {
    return state_->undo.budget();
}

std::size_t Sculptor::clipped_texels() const {
    return state_->stroke ? state_->stroke->clipped_texels() : state_->clipped;
}

}  // namespace relievo
