// Strokes of a session: what a dab takes with it (copies by symmetry, clone's sources, stamp's image), and
// what the journal gets of it.
#include <algorithm>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "brushes/symmetry.h"
#include "editor/session/session_state.h"

namespace relievo {

const std::shared_ptr<const Alpha>& Session::alpha() const {
    return state_->alpha;
}

void Session::set_alpha(std::shared_ptr<const Alpha> alpha) {
    state_->alpha = std::move(alpha);
}

void Session::set_clone_source(const FacePoint& source) {
    if (!state_->exists(source)) throw std::out_of_range("the source of clone lies on no face of the mesh");
    state_->clone_source.set(source);
}

std::optional<FacePoint> Session::clone_source(const FacePoint& target) const {
    const State& s = *state_;
    if (!s.clone_source.is_set() || !s.exists(target)) return std::nullopt;
    return s.clone_source.foreseen(*s.surface, target).point;
}

float Session::world_radius(const PickHit& hit, const Ray& ray, const Ray& next_ray) const {
    const State& s = *state_;
    const StrokeSettings& settings = s.stroke_settings;
    const Mesh& mesh = s.scene.objects.front().mesh;
    double radius = static_cast<double>(s.brush.radius);
    if (settings.unit == RadiusUnit::screen) {
        const double distance = hit.hit ? static_cast<double>(hit.distance)
                                        : static_cast<double>(glm::length(mesh.sphere_centre - ray.origin));
        radius = static_cast<double>(settings.radius_px) * distance *
                 static_cast<double>(
                     glm::length(glm::normalize(next_ray.direction) - glm::normalize(ray.direction)));
    } else if (settings.unit == RadiusUnit::texel) {
        double size = hit.hit && hit.object == 0 ? s.surface->texel_size(hit.face) : 0;
        for (std::uint32_t face = 0; face < s.surface->face_count() && !(size > 0); ++face)
            size = s.surface->texel_size(face);
        radius = static_cast<double>(settings.radius_texels) * size;
    }
    const BrushParameter& limits = brush_parameters().front();
    return std::clamp(static_cast<float>(radius), limits.low, limits.high);
}

void Session::begin_stroke() {
    State& s = *state_;
    s.require_no_stroke();
    require_map("sculpt");
    check_brush(s.brush);
    const bool clones = s.brush.tool == Tool::clone;
    if (clones && !s.clone_source.is_set())
        throw std::invalid_argument("clone: set first where the relief is to come from");
    if (paints(s.brush)) s.allow_painting();
    s.sculptor->begin(s.brush, s.alpha);
    if (clones) s.clone_source.begin(s.stroke_settings.aligned);
    s.copies = symmetry_copies(s.brush, s.surface->world_from_object()).size() - 1;
    s.symmetric.reset();
    s.stroke = {s.brush, {}, std::vector<std::vector<FacePoint>>(s.copies)};
    if (s.brush.tool == Tool::stamp) s.stroke.alpha = AlphaRef{s.alpha->path(), s.alpha->hash()};
    if (clones) s.stroke.sources.resize(s.copies + 1);
    s.touched.reset();
}

void Session::dab(const Dab& dab) {
    State& s = *state_;
    const FacePoint point{dab.face, dab.b1, dab.b2};
    if (!s.sculptor->in_stroke() || !s.exists(point)) return this->dab(dab, {});  // which says what is wrong
    const auto with_copies = [&](const FacePoint& of) {
        return s.copies > 0 ? s.symmetry().copies_of(of) : std::vector<FacePoint>();
    };
    if (s.stroke.brush.tool != Tool::clone) return this->dab(dab, with_copies(point));
    const CloneSource::Place place = s.clone_source.at(*s.surface, point);
    Dab turned = dab;
    turned.drag = place.turn;
    std::vector<FacePoint> sources = with_copies(place.point);
    sources.insert(sources.begin(), place.point);
    this->dab(turned, with_copies(point), sources);
}

void Session::dab(const Dab& dab, std::span<const FacePoint> copies, std::span<const FacePoint> sources) {
    State& s = *state_;
    s.apply([&] { return s.sculptor->dab(dab, copies, sources); },
            [&] {
                s.stroke.dabs.push_back(dab);
                for (std::size_t i = 0; i < copies.size(); ++i) s.stroke.copies[i].push_back(copies[i]);
                for (std::size_t i = 0; i < sources.size(); ++i) s.stroke.sources[i].push_back(sources[i]);
            });
    constexpr auto kOne = static_cast<float>(Dab::kBarycentricOne);
    const glm::vec3 centre =
        s.surface->at(dab.face, static_cast<float>(dab.b1) / kOne, static_cast<float>(dab.b2) / kOne)
            .position;
    s.touched = Touched{centre, s.stroke.brush.radius};
    if (s.stroke.brush.tool == Tool::grab) {  // what it left and where it took it
        const float unit = s.stroke.brush.radius / static_cast<float>(Dab::kDragOne);
        const glm::vec3 drag = unit * glm::vec3(dab.drag[0], dab.drag[1], dab.drag[2]);
        s.touched->centre += 0.5f * drag;
        s.touched->radius = 1.6f * s.touched->radius + 0.5f * glm::length(drag);
    }
}

void Session::end_stroke() {
    State& s = *state_;
    if (s.stroke.dabs.empty()) return cancel_stroke();
    const std::uint64_t steps_before = s.sculptor->steps_made();
    s.apply([&] { return s.sculptor->end(); },
            [&] {
                if (s.sculptor->steps_made() > steps_before)
                    s.add_step(sculpts(s.stroke.brush) && !s.masks(), paints(s.stroke.brush), s.masks());
                if (s.stroke.alpha) s.recorder->keep_alpha(*s.alpha);
                s.recorder->record(s.stroke);
            });
    s.show_edits();
    if (!s.masks()) s.restart_image();
}

void Session::cancel_stroke() {
    State& s = *state_;
    s.apply([&] { return s.sculptor->cancel(); }, [] {});
    s.show_edits();
    if (s.stroke.brush.tool == Tool::clone) s.clone_source.cancel();
    if (!s.stroke.dabs.empty() && !s.masks()) s.restart_image();
}

}  // namespace relievo
