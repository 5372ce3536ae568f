// One editing session: scene, map, brushes and renderer, behind the commands that journals store.
#include "editor/session/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "brushes/sculptor.h"
#include "brushes/symmetry.h"
#include "editor/session/bake.h"
#include "editor/session/mesh_hash.h"
#include "editor/session/recorder.h"
#include "editor/session/scene_input.h"
#include "editor/session/session_colours.h"
#include "editor/session/session_view.h"
#include "editor/session/settings.h"
#include "editor/session/steps.h"
#include "editor/session/surface/clone_source.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/symmetric_dabs.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

// Empty where the heights are a map. Throws where the mesh reaches too far over the exemplar.
std::shared_ptr<const ProceduralSource> source_of(const Mesh& mesh, const Displacement& displacement,
                                                  const HeightMap& exemplar) {
    if (!displacement.procedural) return nullptr;
    auto source = std::make_shared<ProceduralSource>(*displacement.procedural, exemplar.width(), exemplar.height(),
                                                     exemplar.texels().data());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) source->texels_at(corner_uvs(mesh, face));
    return source;
}

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

struct Session::State {
    State(const fs::path& scene_file, const SessionOptions& given)
        : options(given),
          scene(open_scene(scene_file, options.method, options.parameters)),
          start_map(options.map.empty() ? displacement().map : options.map),
          file(open_map(displacement(), start_map, traced_by())),
          source(source_of(scene.objects.front().mesh, displacement(), file.map)),
          colours(options.colour_map.empty() ? albedo_map() : options.colour_map, albedo_map(),
                  options.with_renderer) {
        if (source && !options.map.empty())
            throw std::invalid_argument(options.map.string() +
                                        ": the scene's heights are procedural; there is no map to put this in place of");
        make_surface();
        brush.radius = scene.objects.front().mesh.sphere_radius * 0.1f;
        if (!displacement().map.empty()) map_path = displacement().map;
        const bool recording = !options.journal.empty() || options.recovery;
        header.version = std::string(RELIEVO_VERSION);
        header.scene = scene.path;
        header.map_width = file.map.width();
        header.map_height = file.map.height();
        header.midlevel = displacement().midlevel;
        header.amplitude = displacement().amplitude;
        header.undo_budget = options.undo_budget;
        header.mesh_hash = mesh_hash(scene.objects.front().mesh);
        if (recording) header.map_hash = file.map.hash();  // 512 MiB of texels take a while
        if (colours.there()) header.colour_map = fs::absolute(colours.start_file());
        if (recording && colours.there()) header.colour_hash = colours.map().hash();
        if (options.with_renderer) open_view();
        recorder = std::make_unique<Recorder>(header, options.journal, options.recovery);
        recorder->set_start_files(options.map, options.colour_map);
    }

    const fs::path& albedo_map() const { return scene.objects.front().material.albedo_map; }

    const Displacement& displacement() const { return scene.objects.front().displacement; }

    const MethodChoice* traced_by() const { return options.with_renderer ? &scene.method : nullptr; }

    void open_view() {
        others.reserve(scene.objects.size());
        for (std::size_t i = 1; i < scene.objects.size(); ++i) {
            const Displacement& other = scene.objects[i].displacement;
            others.push_back(open_map(other, other.map, traced_by()));
            other_sources.push_back(source_of(scene.objects[i].mesh, other, others.back().map));
        }
        view = std::make_unique<SessionView>(scene, maps(), colours.view(), options);
    }

    std::vector<const HeightMap*> maps() const {
        std::vector<const HeightMap*> all{&file.map};
        for (const LoadedMap& other : others) all.push_back(&other.map);
        return all;
    }

    // Other heights for the edited object: another map or exemplar where `fresh` holds one. Undo steps end there.
    // Throws before anything has changed.
    void take_heights(const Displacement& wanted, std::optional<LoadedMap> fresh) {
        SceneObject& object = scene.objects.front();
        auto made = source_of(object.mesh, wanted, fresh ? fresh->map : file.map);
        object.displacement = wanted;
        source = std::move(made);
        if (fresh) {
            symmetric.reset();
            sculptor.reset();
            surface.reset();
            file = std::move(*fresh);
            make_surface();
        }
        ++revision;
        if (view) view->set_heights(displacement(), file.map);
    }

    // What brushes work on, over file.map.
    void make_surface() {
        surface.emplace(scene.objects.front().mesh, displacement(), file.map);
        glm::dmat4 rebased(1.0);
        rebased[3] = glm::dvec4(-scene.origin, 1.0);
        surface->set_world_from_object(rebased * scene.objects.front().transform);
        sculptor.emplace(file.map, *surface, options.undo_budget);
        can_paint = false;
    }

    // Hands the colour map to the sculptor, once. Throws where it has another size than the map.
    void allow_painting() {
        if (!colours.there() || can_paint) return;
        sculptor->set_colours(colours.map());
        can_paint = true;
    }

    void require_no_stroke() const {
        if (sculptor->in_stroke()) throw std::logic_error("end the stroke first");
    }

    // Runs one edit of the map, books it, then shows it: what happened to the map is recorded even if the
    // device fails to show it.
    template <typename Edit, typename Book>
    void apply(Edit edit, Book book) {
        const auto start = Clock::now();
        const std::vector<TexelRect> rects = edit();
        times = {};
        times.edit_ms = milliseconds_since(start);
        const std::vector<TexelRect> painted = sculptor->take_painted();
        if (!rects.empty()) ++revision;
        if (!painted.empty()) ++colour_revision;
        book();
        if (!view) return;
        view->upload(file.map, rects, times);
        view->upload_colours(colours.view(), painted, times);
    }

    // The finder of the copies of a stroke under way.
    const SymmetricDabs& symmetry() {
        if (!symmetric)
            symmetric.emplace(scene.objects.front().mesh, *surface,
                              symmetry_copies(stroke.brush, surface->world_from_object()));
        return *symmetric;
    }

    // On the base mesh, and within its face.
    bool exists(const FacePoint& point) const {
        return point.face < surface->face_count() && point.b1 <= Dab::kBarycentricOne &&
               point.b2 <= Dab::kBarycentricOne - point.b1;
    }
    void add_step(bool changes_map, bool changes_colours) {
        steps.add(changes_map);
        colour_steps.add(changes_colours);
    }

    void restart_image() {
        if (view) view->restart();
    }

    SessionOptions options;
    Scene scene;
    fs::path start_map;  // empty: a new flat map
    LoadedMap file;
    std::vector<LoadedMap> others;  // of the objects that are not edited, where there is a renderer
    std::vector<std::shared_ptr<const ProceduralSource>> other_sources;
    std::uint64_t revision = 0;     // of file.map
    std::shared_ptr<const ProceduralSource> source;  // of file.map as the exemplar; empty: it is the heights
    SessionColours colours;
    std::uint64_t colour_revision = 0;
    bool can_paint = false;  // the sculptor has the colours
    std::optional<MeshSurface> surface;
    std::optional<Sculptor> sculptor;
    std::unique_ptr<SessionView> view;
    JournalHeader header;
    std::unique_ptr<Recorder> recorder;
    std::optional<fs::path> map_path;
    Steps steps, colour_steps;  // of both maps, and of the colours alone
    Brush brush;
    StrokeSettings stroke_settings;
    std::shared_ptr<const Alpha> alpha;  // of stamp
    CloneSource clone_source;
    StrokeOp stroke;                         // under way
    std::size_t copies = 0;                  // of each of its dabs
    std::optional<SymmetricDabs> symmetric;  // made at a stroke's first dab that needs it
    std::optional<Touched> touched;
    StageTimes times;
};

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
bool Session::has_renderer() const {
    return state_->view != nullptr;
}

Renderer& Session::renderer() {
    if (!state_->view) throw std::logic_error("this session has no renderer");
    return state_->view->renderer();
}

vulkan::Context& Session::context() {
    if (!state_->view) throw std::logic_error("this session has no renderer");
    return state_->view->context();
}

Renderer& Session::compare_with(const MethodChoice& method) {
    renderer();
    return state_->view->compare_with(state_->scene, state_->maps(), state_->colours.view(), method);
}

void Session::stop_comparing() {
    if (state_->view) state_->view->stop_comparing();
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

StrokeSettings& Session::stroke_settings() {
    return state_->stroke_settings;
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
    if (s.source)
        throw std::invalid_argument("the heights are procedural: bake them into a map first, then sculpt that");
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
        s.surface->at(dab.face, static_cast<float>(dab.b1) / kOne, static_cast<float>(dab.b2) / kOne).position;
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
                    s.add_step(s.stroke.brush.tool != Tool::mask, paints(s.stroke.brush));
                if (s.stroke.alpha) s.recorder->keep_alpha(*s.alpha);
                s.recorder->record(s.stroke);
            });
    s.restart_image();
}

void Session::cancel_stroke() {
    State& s = *state_;
    s.apply([&] { return s.sculptor->cancel(); }, [] {});
    if (s.stroke.brush.tool == Tool::clone) s.clone_source.cancel();
    if (!s.stroke.dabs.empty()) s.restart_image();
}

bool Session::in_stroke() const {
    return state_->sculptor->in_stroke();
}

bool Session::undo() {
    State& s = *state_;
    s.require_no_stroke();
    if (!s.sculptor->can_undo()) return false;
    s.apply([&] { return s.sculptor->undo(); },
            [&] {
                s.steps.undo();
                s.colour_steps.undo();
                s.recorder->record(UndoOp{});
            });
    s.restart_image();
    return true;
}

bool Session::redo() {
    State& s = *state_;
    s.require_no_stroke();
    if (!s.sculptor->can_redo()) return false;
    s.apply([&] { return s.sculptor->redo(); },
            [&] {
                s.steps.redo();
                s.colour_steps.redo();
                s.recorder->record(RedoOp{});
            });
    s.restart_image();
    return true;
}

void Session::change_mask(MaskCommand command) {
    State& s = *state_;
    s.require_no_stroke();
    const std::uint64_t steps_before = s.sculptor->steps_made();
    switch (command) {
        case MaskCommand::clear:
            s.sculptor->clear_mask();
            break;
        case MaskCommand::invert:
            s.sculptor->invert_mask();
            break;
        case MaskCommand::blur:
            s.sculptor->blur_mask();
            break;
    }
    if (s.sculptor->steps_made() > steps_before) s.add_step(false, false);
    s.recorder->record(MaskOp{command});
}

void Session::set(const std::string& key, const SetValue& value) {
    State& s = *state_;
    s.require_no_stroke();
    Displacement wanted;
    const SettingScope scope = apply_setting(s.scene, key, value, wanted);
    if (scope == SettingScope::heights) {
        const bool other = wanted.procedural->exemplar != s.displacement().procedural->exemplar;
        s.take_heights(wanted, other ? std::optional(open_map(wanted, {}, s.traced_by())) : std::nullopt);
    } else if (scope == SettingScope::displacement) {
        s.surface->set_displacement(static_cast<float>(s.displacement().amplitude),
                                    static_cast<float>(s.displacement().midlevel));
    }
    if (s.view) s.view->follow(scope, s.scene);
    s.recorder->record(SetOp{key, value});
}

void Session::set_camera(const Camera& camera) {
    set("camera", camera_value(camera));
}

void Session::bake(const ImageSize& size) {
    State& s = *state_;
    s.require_no_stroke();
    if (!s.source) throw std::invalid_argument("the heights are a map already; there is nothing to bake");
    check_bakeable(s.scene.objects.front());
    HeightMap map = relievo::bake(*s.source, size);
    s.take_heights(baked_displacement(s.displacement(), {}), LoadedMap{std::move(map), {}, MapFormat::tiff16, nullptr});
    s.add_step(true, false);
    s.recorder->record(BakeOp{size});
}

void Session::make_colours(int bits) {
    State& s = *state_;
    s.require_no_stroke();
    if (s.source)
        throw std::invalid_argument(
            "the heights are procedural: bake them into a map first, then paint that");
    s.colours.make(s.file.map.width(), s.file.map.height(), bits, s.scene.objects.front().material.albedo,
                   s.view != nullptr);
    ++s.colour_revision;
    s.recorder->record(ColourMapOp{bits});
    if (s.view) s.view->set_colours(s.colours.view());
}

void Session::save(const fs::path& path, const fs::path& colour_path) {
    State& s = *state_;
    s.require_no_stroke();
    const MapFormat named = format_of(path);
    const bool both_exr = named == MapFormat::exr_float && s.file.format == MapFormat::exr_half;
    const MapFormat format = both_exr ? MapFormat::exr_half : named;
    std::error_code ignored;
    if (!s.start_map.empty() && fs::equivalent(path, s.start_map, ignored))
        s.recorder->keep_base(BaseFile::map, s.start_map);
    if (!colour_path.empty()) {
        if (!s.colours.there())
            throw std::invalid_argument(colour_path.string() + ": there is no colour map to save");
        check_colour_path(colour_path);
        const fs::path& start = s.colours.start_file();
        if (!start.empty() && fs::equivalent(colour_path, start, ignored))
            s.recorder->keep_base(BaseFile::colours, start);
        s.colours.save(colour_path);
    }
    save_map(s.file.map, path, format, s.file.range, format == s.file.format ? s.file.origin.get() : nullptr);
    confirm_saved(path, colour_path);
}

fs::path Session::colour_path_for(const fs::path& map) const {
    const State& s = *state_;
    if (!s.colours.there()) return {};
    std::error_code ignored;
    const bool own_file =
        s.map_path && (fs::absolute(map).lexically_normal() == s.map_path->lexically_normal() ||
                       fs::equivalent(map, *s.map_path, ignored));
    const fs::path& file = s.colours.file();
    if (!own_file || file.empty()) return s.colours.path_beside(map);
    return s.colour_steps.unsaved() ? file : fs::path();
}

void Session::export_map(const fs::path& path, MapFormat format, MapRange range) const {
    state_->require_no_stroke();
    if (format_of(path) != format && format != MapFormat::exr_half)
        throw std::invalid_argument(path.string() +
                                    ": the extension names another format than the one that was chosen");
    save_map(state_->file.map, path, format, range);
}

void Session::export_colours(const fs::path& path) const {
    state_->require_no_stroke();
    if (!state_->colours.there()) throw std::invalid_argument("there is no colour map to export");
    state_->colours.save(path);
}

void Session::confirm_saved(const fs::path& path, const fs::path& colour_path) {
    State& s = *state_;
    s.map_path = fs::absolute(path);
    SaveOp op{*s.map_path, s.file.map.hash()};
    if (!colour_path.empty() && s.colours.there()) {
        s.colours.set_file(fs::absolute(colour_path));
        s.colour_steps.mark_saved();
        op.colour_map = s.colours.file();
        op.colour = s.colours.map().hash();
    }
    if (!s.colour_steps.unsaved()) s.steps.mark_saved();
    s.recorder->record(op);
}

bool Session::revert() {
    const bool ahead = state_->steps.saved_is_ahead();
    if (!ahead && !state_->steps.saved_is_behind()) return false;
    for (int taken = 0; unsaved(); ++taken) {
        if (ahead ? redo() : undo()) continue;
        for (; taken > 0; --taken) ahead ? undo() : redo();  // the way is cut off: leave all as it was
        return false;
    }
    return true;
}

bool Session::unsaved() const {
    return state_->steps.unsaved();
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
std::optional<fs::path> Session::colour_path() const {
    const fs::path& file = state_->colours.file();
    return file.empty() ? std::nullopt : std::optional(file);
}
std::optional<fs::path> Session::map_path() const {
    return state_->map_path;
}
void Session::discard_recovery() {
    state_->recorder->discard_recovery();
}
std::string Session::journal_error() const {
    return state_->recorder->error();
}
std::optional<Session::Touched> Session::last_dab() const {
    return state_->touched;
}

void Session::trace(const PixelRect& window) {
    renderer();
    state_->view->trace(window, state_->times);
}

}  // namespace relievo
