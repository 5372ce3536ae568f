// One editing session: scene, map, brushes and renderer, behind the commands that journals store.
#include "editor/session/session.h"

#include <stdexcept>

#include "editor/session/bake.h"
#include "editor/session/session_state.h"
#include "editor/session/settings.h"

namespace relievo {
namespace {

// What a setting changes that the renderers may then refuse, or be stopped at.
class SettingsBefore {
  public:
    explicit SettingsBefore(const Scene& scene)
        : method_(scene.method), lights_(scene.lights), environment_(scene.environment),
          material_(scene.objects.front().material), amplitude_(scene.objects.front().displacement.amplitude),
          midlevel_(scene.objects.front().displacement.midlevel) {}

    void put_back(Scene& scene) const {
        scene.method = method_;
        scene.lights = lights_;
        scene.environment = environment_;
        SceneObject& object = scene.objects.front();
        object.material = material_;
        object.displacement.amplitude = amplitude_;
        object.displacement.midlevel = midlevel_;
    }

  private:
    MethodChoice method_;
    std::vector<Light> lights_;
    Environment environment_;
    Material material_;
    double amplitude_, midlevel_;
};

}  // namespace

Session::Session(const fs::path& scene_file, const SessionOptions& options)
    : state_(std::make_unique<State>(scene_file, options)) {}

Session::~Session() {
    if (!unsaved()) state_->recorder->discard_recovery();
}

const Scene& Session::scene() const {
    return state_->scene;
}
HeightMap& Session::map() {
    return state_->file.map;
}
const HeightMap& Session::map() const {
    return state_->file.map;
}
const Surface& Session::surface() const {
    return *state_->surface;
}
std::shared_ptr<const ProceduralSource> Session::procedural(std::size_t object) const {
    return object == 0 ? state_->source : state_->other_sources.at(object - 1);
}
// Else map() is an exemplar, which is not what is seen.
void Session::require_map(const std::string& then) const {
    if (state_->source)
        throw std::invalid_argument("the heights are procedural: bake them into a map first, then " + then + " that");
}
const HeightMap& Session::map_of(std::size_t object) const {
    return object == 0 ? state_->file.map : state_->others.at(object - 1).map;
}
std::uint64_t Session::map_revision() const {
    return state_->revision;
}
const HeightMap* Session::mask() const {
    return state_->sculptor->mask();
}
std::uint64_t Session::mask_revision() const {
    return state_->sculptor->mask_revision();
}
std::uint64_t Session::mask_hash() const { return state_->mask_hash(); }

std::uint64_t Session::State::mask_hash() const {
    const HeightMap* mask = sculptor->mask();
    return mask ? mask->hash() : HeightMap(file.map.width(), file.map.height(), 0).hash();
}
const ColourMap* Session::colours() const {
    return state_->colours.there() ? &state_->colours.map() : nullptr;
}
std::array<float, 3> Session::colour_at(const PickHit& hit) const {
    const SceneObject& object = state_->scene.objects.at(hit.object);
    if (hit.object > 0 || !state_->colours.there()) return as_floats(encoded_colour(object.material.albedo));
    const auto uv = corner_uvs(object.mesh, hit.face);
    const auto b1 = static_cast<double>(hit.b1), b2 = static_cast<double>(hit.b2);
    return as_floats(state_->colours.at(uv[0] * (1 - b1 - b2) + uv[1] * b1 + uv[2] * b2,
                                        object.displacement.wrap == Wrap::clamp));
}
std::uint64_t Session::colour_revision() const {
    return state_->colour_revision;
}
std::uint64_t Session::surface_revision() const {
    return map_revision() + colour_revision();
}
bool Session::has_renderer() const {
    return state_->view != nullptr;
}

Renderer& Session::renderer() {
    if (!state_->view) throw std::logic_error("this session has no renderer");
    show_edits();
    return state_->view->renderer();
}

void Session::show_edits() {
    state_->show_edits();
}

vulkan::Context& Session::context() {
    if (!state_->view) throw std::logic_error("this session has no renderer");
    return state_->view->context();
}

Renderer& Session::compare_with(const MethodChoice& method, const Advance& advance) {
    renderer();
    return state_->view->compare_with(state_->scene, state_->maps(), state_->colours.view(), method, advance);
}

void Session::stop_comparing() {
    if (state_->view) state_->view->stop_comparing();
}

void Session::make_ready(vulkan::Pass pass, const Advance& advance) {
    if (state_->view) state_->view->make_ready(pass, advance);
}

const StageTimes& Session::times() const {
    return state_->times;
}
const JournalHeader& Session::header() const {
    return state_->header;
}
Brush& Session::brush() {
    return state_->brush;
}
const Brush& Session::brush() const {
    return state_->brush;
}

StrokeSettings& Session::stroke_settings() {
    return state_->stroke_settings;
}

bool Session::in_stroke() const {
    return state_->sculptor->in_stroke();
}

void Session::change_mask(MaskCommand command, const Advance& advance) {
    State& s = *state_;
    s.require_no_stroke();
    const std::uint64_t steps_before = s.sculptor->steps_made();
    switch (command) {
        case MaskCommand::clear:
            s.sculptor->clear_mask(advance);
            break;
        case MaskCommand::invert:
            s.sculptor->invert_mask(advance);
            break;
        case MaskCommand::blur:
            s.sculptor->blur_mask(advance);
            break;
    }
    if (s.sculptor->steps_made() > steps_before) s.add_step(false, false, true);
    s.recorder->record(MaskOp{command});
}

void Session::State::follow(SettingScope scope, const Advance& advance) {
    if (scope == SettingScope::displacement)
        surface->set_displacement(static_cast<float>(displacement().amplitude), static_cast<float>(displacement().midlevel));
    if (view) view->follow(scope, scene, advance);
}

void Session::set(const std::string& key, const SetValue& value, const Advance& advance) {
    State& s = *state_;
    s.require_no_stroke();
    Displacement wanted;
    const SettingsBefore before(s.scene);
    const SettingScope scope = apply_setting(s.scene, key, value, wanted);
    if (scope == SettingScope::heights) {
        const bool other = wanted.procedural->exemplar != s.displacement().procedural->exemplar;
        const double read = other ? 0.4 : 0;  // part of the time, about
        s.take_heights(wanted,
                       other ? std::optional(open_map(wanted, {}, s.traced_by(), within(advance, 0, read))) : std::nullopt,
                       within(advance, read, 1));
    } else {
        try {
            s.follow(scope, advance);
        } catch (...) {
            before.put_back(s.scene);
            s.follow(scope, {});
            throw;
        }
    }
    s.recorder->record(SetOp{key, value});
}

void Session::set_camera(const Camera& camera) {
    set("camera", camera_value(camera));
}

void Session::bake(const ImageSize& size, const Advance& advance) {
    State& s = *state_;
    s.require_no_stroke();
    if (!s.source) throw std::invalid_argument("the heights are a map already; there is nothing to bake");
    check_bakeable(s.scene.objects.front());
    constexpr double kBaked = 0.7;  // part of the time, about
    HeightMap map = relievo::bake(*s.source, size, within(advance, 0, kBaked));
    s.take_heights(baked_displacement(s.displacement(), {}),
                   LoadedMap{std::move(map), {}, MapFormat::tiff16, nullptr}, within(advance, kBaked, 1));
    s.add_step(true, false, false);
    s.recorder->record(BakeOp{size});
}

void Session::make_colours(int bits, const Advance& advance) {
    State& s = *state_;
    s.require_no_stroke();
    require_map("paint");
    constexpr double kFilled = 0.4;  // part of the time, about
    const HeightMap& map = s.file.map;
    auto fresh = run_beside(told_to(within(advance, 0, kFilled)), [&](const WorkPart& part) {
        part.at(0, 1);
        return s.colours.of_one_colour(map.width(), map.height(), bits, s.scene.objects.front().material.albedo, s.view != nullptr);
    });
    if (s.view) s.view->set_colours(view_of(fresh), within(advance, kFilled, 1));
    s.colours.take(std::move(fresh));
    ++s.colour_revision;
    s.recorder->record(ColourMapOp{bits});
}

bool Session::unsaved() const {
    return state_->steps.unsaved();
}
std::uint64_t Session::steps_made() const {
    return state_->sculptor->steps_made();
}
bool Session::can_undo() const {
    return state_->sculptor->can_undo();
}
bool Session::can_redo() const {
    return state_->sculptor->can_redo();
}
std::size_t Session::undo_bytes() const {
    return state_->sculptor->undo_bytes();
}
std::size_t Session::undo_budget() const {
    return state_->sculptor->undo_budget();
}
std::size_t Session::clipped_texels() const {
    return state_->sculptor->clipped_texels();
}
std::optional<Session::Touched> Session::last_dab() const {
    return state_->touched;
}

void Session::trace(const PixelRect& window) {
    renderer();
    state_->view->trace(window, state_->times);
}

}  // namespace relievo
