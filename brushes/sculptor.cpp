// A stroke from begin to end: dabs to tools, seams after every dab, one quantised state, one undo step.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "brushes/copy_changes.h"
#include "brushes/copy_shares.h"
#include "brushes/dab_cost.h"
#include "brushes/dab_tools.h"
#include "brushes/sculptor_state.h"
#include "brushes/shared_work.h"
#include "brushes/tile_rects.h"

namespace relievo {

std::vector<TexelRect> Sculptor::State::shown(std::vector<TexelRect> rects, Layer which) {
    if (which == Layer::height) return merge_rects(std::move(rects));
    if (!rects.empty()) ++mask_revision;
    return {};
}

void Sculptor::State::start(const Brush& the_brush, std::shared_ptr<const Alpha> the_alpha) {
    if (the_brush.tool == Tool::stamp && !the_alpha)
        throw std::invalid_argument("stamp: there is no image to press into the surface; choose one first");
    const std::vector<glm::dmat4> copies = symmetry_copies(the_brush, surface.world_from_object());
    brush = the_brush;
    alpha = std::move(the_alpha);
    branches.clear();
    for (const glm::dmat4& copy : copies) {
        branches.emplace_back();
        if (copies.size() > 1) branches.back().turned = std::make_unique<TurnedSurface>(surface, copy);
    }
    last_drag = glm::vec3(0);
    at_once.reset();
    stroke.emplace(map_of(layer()));
    paint.reset();
    if (paints(brush))
        paint.emplace(brush, brush.tool == Tool::stamp ? alpha.get() : nullptr, *colours, seams);
}

void Sculptor::State::apply(const Dab& dab, Points copies, Points sources) {
    if (brush.tool != Tool::grab) return apply_step(dab, copies, sources, glm::vec3(0));
    constexpr float kLongestStep = 0.4f;  // of the radius
    constexpr int kMostSteps = 1000;
    const float unit = brush.radius / static_cast<float>(Dab::kDragOne);
    const glm::vec3 from = last_drag;
    const glm::vec3 to = unit * glm::vec3(dab.drag[0], dab.drag[1], dab.drag[2]);
    const float radius = brush.radius * (static_cast<float>(dab.size) / static_cast<float>(Dab::kSizeOne));
    const float way = glm::length(to - from) / (kLongestStep * radius);
    const int steps = static_cast<int>(std::clamp(std::ceil(way), 1.0f, static_cast<float>(kMostSteps)));
    for (int i = 1; i <= steps; ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(steps);
        apply_step(dab, copies, sources, i == steps ? to : from + part * (to - from));
    }
    last_drag = to;
}

void Sculptor::State::apply_step(const Dab& dab, Points copies, Points sources, glm::vec3 drag) {
    constexpr float kJump = 2.0f;  // radii between dabs beyond which the hand has jumped
    const float radius = brush.radius * (static_cast<float>(dab.size) / static_cast<float>(Dab::kSizeOne));
    const float pressure =
        std::min(static_cast<float>(dab.pressure) / static_cast<float>(Dab::kPressureOne), 1.0f);
    std::vector<SurfacePoint> centres;
    std::vector<MovingCopy> places;
    for (std::size_t i = 0; i < branches.size(); ++i) {
        const FacePoint point = i == 0 ? FacePoint{dab.face, dab.b1, dab.b2} : copies[i - 1];
        centres.push_back(seen(branches[i], point));
        const glm::dvec3 place(seen({}, point).position);
        glm::dvec3 motion(0);
        if (const auto& last = branches[i].last_in_world; last && shares_by_motion(brush.tool))
            motion = place - *last;
        branches[i].last_in_world = place;
        places.push_back({place, motion});
        branches[i].move_to(centres[i].position, kJump * brush.radius);
    }
    if (!at_once) {
        const bool copied = branches.size() > 1;
        at_once =
            copies_at_once(brush.tool, copied ? surface.count_in_ball(centres[0].position, brush.radius) : 0);
    }
    const glm::vec3 hand =
        glm::vec3(dab.drag[0], dab.drag[1], dab.drag[2]) / static_cast<float>(Dab::kDragOne);
    if (paint) {
        std::vector<PaintStroke::Place> hands;
        for (std::size_t i = 0; i < branches.size(); ++i)
            hands.push_back({surface_of(branches[i]), centres[i], radius, branches[i].motion, hand});
        paint->dab(hands, pressure, protection(), *at_once);
        note_painted(paint->take_dirty());
    }
    if (!sculpts(brush)) return;
    const bool add_up = adds_up(brush);
    const std::vector<float> share =
        add_up ? copy_shares(places, double{radius}) : std::vector<float>(branches.size(), 1.0f);
    // Each reads the stroke as the last dab left it.
    CopyChanges wanted(branches.size(), add_up, *stroke);
    const auto work_out = [&](std::size_t i) {
        Branch& branch = branches[i];
        DabPlace place{centres[i], pressure, radius, branch.motion, drag, share[i], branch.hold};
        place.hand = hand;
        place.alpha = alpha.get();
        place.saved = &saved;
        const SurfacePoint source = sources.empty() ? SurfacePoint() : seen(branch, sources[i]);
        if (!sources.empty()) place.source = &source;
        wanted.add(i, dab_changes(brush, place, surface_of(branch), seams, *stroke, protection()));
    };
    share_work(branches.size(), work_out, *at_once);
    wanted.apply();
    seams.follow(*stroke, across());
}

std::vector<TexelRect> Sculptor::State::take(bool redo) {
    const LayerMaps maps = [this](Layer which) -> HeightMap& { return map_of(which); };
    for (const auto& [which, rect] : redo ? undo.redo_rects() : undo.undo_rects())
        if (which == Layer::height) saved.keep(rect);
    std::vector<TexelRect> heights, masks;
    for (const auto& [which, rect] : redo ? undo.redo(maps) : undo.undo(maps))
        (which == Layer::height ? heights : which == Layer::mask ? masks : painted).push_back(rect);
    if (!heights.empty()) clipped = 0;  // no longer of the map's last change
    shown(std::move(masks), Layer::mask);
    return shown(std::move(heights), Layer::height);
}

void Sculptor::State::finish_stroke() {
    stroke.reset();
    paint.reset();
    branches.clear();  // grab's hold hundreds of bytes a texel
}

void Sculptor::State::push_step() {
    if (layer() == Layer::height) saved.keep(*stroke);
    std::vector<LayerStroke> parts{{*stroke, map_of(layer()), layer()}};
    constexpr Layer kPlanes[] = {Layer::red, Layer::green, Layer::blue};
    for (std::size_t k = 0; paint && k < std::size(kPlanes); ++k)
        parts.push_back({paint->plane(k), colours->plane(k), kPlanes[k]});
    undo.push(parts);
}

Sculptor::Sculptor(HeightMap& map, const Surface& surface, std::size_t undo_budget)
    : state_(std::make_unique<State>(map, surface, undo_budget)) {}

Sculptor::~Sculptor() = default;

void Sculptor::begin(const Brush& brush, std::shared_ptr<const Alpha> alpha) {
    state_->require_stroke(false, "begin");
    check_brush(brush);
    if (paints(brush) && !state_->colours)
        throw std::invalid_argument("painting needs a colour map: make one first");
    state_->start(brush, std::move(alpha));
}

std::vector<TexelRect> Sculptor::dab(const Dab& dab, std::span<const FacePoint> copies,
                                     std::span<const FacePoint> sources) {
    state_->require_stroke(true, "dab");
    const std::uint32_t faces = state_->surface.face_count();
    check_dab(dab, faces);
    if (copies.size() + 1 != state_->branches.size())
        throw std::out_of_range("dab with " + std::to_string(copies.size()) +
                                " copies: the brush's symmetry makes " +
                                std::to_string(state_->branches.size() - 1));
    const std::size_t wanted = state_->brush.tool == Tool::clone ? copies.size() + 1 : 0;
    if (sources.size() != wanted)
        throw std::out_of_range("dab with " + std::to_string(sources.size()) + " sources: the tool needs " +
                                std::to_string(wanted));
    for (const FacePoint& copy : copies) check_point(copy, faces);
    for (const FacePoint& source : sources) check_point(source, faces);
    state_->apply(dab, copies, sources);
    return state_->shown(state_->stroke->take_dirty(), state_->layer());
}

std::vector<TexelRect> Sculptor::end() {
    state_->require_stroke(true, "end");
    StrokeTiles& stroke = *state_->stroke;
    const Layer layer = state_->layer();
    state_->seams.settle(stroke, state_->across(), state_->protection());
    std::vector<TexelRect> rects = state_->shown(stroke.take_dirty(), layer);
    if (state_->paint) {
        state_->paint->settle(state_->protection());
        state_->note_painted(state_->paint->take_dirty());
    }
    state_->push_step();
    state_->clipped = layer == Layer::height ? stroke.clipped_texels() : 0;
    state_->finish_stroke();
    return rects;
}

std::vector<TexelRect> Sculptor::cancel() {
    state_->require_stroke(true, "cancel");
    std::vector<TexelRect> rects = state_->shown(state_->stroke->restore(), state_->layer());
    if (state_->paint) state_->note_painted(state_->paint->restore());
    state_->clipped = 0;
    state_->finish_stroke();
    return rects;
}

void Sculptor::set_colours(ColourMap& colours) {
    state_->require_stroke(false, "set_colours");
    if (state_->colours) throw std::logic_error("Sculptor::set_colours: there is a colour map already");
    const HeightMap& map = state_->map;
    if (colours.width() != map.width() || colours.height() != map.height())
        throw std::invalid_argument("the colour map has " + std::to_string(colours.width()) + " x " +
                                    std::to_string(colours.height()) + " texels, the displacement map " +
                                    std::to_string(map.width()) + " x " + std::to_string(map.height()) +
                                    ": to be painted, it must have as many");
    state_->colours = &colours;
}

std::vector<TexelRect> Sculptor::take_painted() {
    const TileGrid grid(state_->map.width(), state_->map.height());
    return merge_rects(joined_by_tile(std::exchange(state_->painted, {}), grid));
}

bool Sculptor::in_stroke() const {
    return state_->stroke.has_value();
}

void Sculptor::mark_saved() {
    state_->require_stroke(false, "mark_saved");
    state_->saved.mark_saved();
}

bool Sculptor::can_undo() const {
    return state_->undo.can_undo();
}
bool Sculptor::can_redo() const {
    return state_->undo.can_redo();
}

std::vector<TexelRect> Sculptor::undo() {
    state_->require_stroke(false, "undo");
    return state_->take(false);
}

std::vector<TexelRect> Sculptor::redo() {
    state_->require_stroke(false, "redo");
    return state_->take(true);
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
    if (!state_->stroke) return state_->clipped;
    return state_->layer() == Layer::height ? state_->stroke->clipped_texels() : 0;
}

}  // namespace relievo
