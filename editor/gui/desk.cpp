// The commands that panels, keys and dialogs give the session.
#include "editor/gui/desk.h"

#include <algorithm>
#include <array>
#include <exception>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>
#include <utility>

#include "editor/gui/camera_control.h"
#include "editor/session/preferences.h"
#include "editor/session/settings.h"
#include "editor/session/stroke_input.h"
#include "editor/session/text.h"
#include "renderer/methods/registry.h"

namespace relievo::gui {
namespace {

constexpr double kFlatFovDeg = 2;
constexpr float kLeastRadius = 0.002f, kMostRadius = 2.0f;  // of the mesh's

// What is built for a method, and its programs, which the driver compiles.
std::string preparing(const std::string& method) { return "Preparing the method " + std::string(find_method(method).name); }

glm::dmat3 turn_about(const glm::dvec3& axis, double degrees) {
    return glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(degrees), glm::normalize(axis)));
}

}  // namespace

bool Desk::attempt(const std::function<void()>& command) {
    if (session.in_stroke()) {
        toasts.info("A stroke is still being worked out: wait for its end, or cancel it with Esc");
        return false;
    }
    try {
        command();
        return true;
    } catch (const std::exception& error) {
        toasts.error(error.what());
        return false;
    }
}

void Desk::set(const std::string& key, const SetValue& value) {
    const bool of_method = key == "method" || key.starts_with("method."), of_heights = key.starts_with("procedural.");
    const auto* name = std::get_if<std::string>(&value);
    const std::string method = of_method && name ? *name : session.scene().method.name;
    attempt([&] {
        if (!view.work) finish_work();
        work = LongWork{of_method    ? preparing(method)
                        : of_heights ? "Changing the heights"
                                     : "Preparing the picture",
                        [this, key, value](const Advance& advance) { session.set(key, value, advance); },
                        [this] { live.in_motion(); }};
    });
}

// Settings may come in one frame, each of which builds on those before it.
void Desk::finish_work() {
    const auto waiting = std::exchange(work, std::nullopt);
    if (!waiting) return;
    waiting->run({});
    if (waiting->done) waiting->done();
}

// Named from the scene's folder, so that the journal can move with the scene.
void Desk::set_exemplar(const std::filesystem::path& path) {
    set("procedural.exemplar", path.lexically_proximate(session.scene().path.parent_path()).generic_string());
}

void Desk::set_camera(const Camera& camera) {
    if (attempt([&] { session.set_camera(camera); })) live.in_motion();
}

void Desk::take_step(bool forth) {
    attempt([&] {
        if (!(forth ? session.can_redo() : session.can_undo()))
            return toasts.info(forth ? "Nothing to redo" : "Nothing to undo");
        const std::uint64_t before = session.surface_revision();
        work = LongWork{forth ? "Redoing" : "Undoing",
                        [this, forth](const Advance& advance) { forth ? session.redo(advance) : session.undo(advance); },
                        [this, before] {
                            if (session.surface_revision() != before) live.restart();
                        }};
    });
}

void Desk::bake(const ImageSize& size) {
    const std::string texels = std::to_string(size.width) + " x " + std::to_string(size.height);
    attempt([&] {
        work = LongWork{"Baking " + texels + " texels",
                        [this, size](const Advance& advance) { session.bake(size, advance); },
                        [this, texels] {
                            live.in_motion();
                            toasts.info("Baked into a map of " + texels + " texels: save it to keep it");
                        }};
    });
}

void Desk::scale_radius(double factor) {
    StrokeSettings& settings = session.stroke_settings();
    const auto scaled = [&](float& value, float low, float high) {
        value = std::clamp(value * static_cast<float>(factor), low, high);
    };
    if (settings.unit == RadiusUnit::world)
        scaled(session.brush().radius, kLeastRadius * mesh_radius(), kMostRadius * mesh_radius());
    for (const StrokeParameter& parameter : stroke_parameters()) {
        const bool counted =
            (parameter.value == &StrokeSettings::radius_px && settings.unit == RadiusUnit::screen) ||
            (parameter.value == &StrokeSettings::radius_texels && settings.unit == RadiusUnit::texel);
        if (counted) scaled(settings.*parameter.value, parameter.low, parameter.high);
    }
}

void Desk::start_drag(BrushDrag drag) {
    if (session.in_stroke()) return;
    if (drag == BrushDrag::rotation && session.brush().tool != Tool::stamp)
        return toasts.info("The stamp alone has a rotation");
    view.brush_drag = drag;
}

void Desk::set_alpha(const std::filesystem::path& path) {
    attempt([&] {
        const auto& alpha = alphas.add(path).alpha;
        session.set_alpha(alpha);
        if (alpha->largest() > 1)
            toasts.info(path.filename().string() + " holds values beyond 1: all are divided by the largest, " +
                        formatted("%.4g", static_cast<double>(alpha->largest())) + ", which counts as white");
    });
}

void Desk::set_clone_source(double x_px, double y_px) {
    attempt([&] {
        const Ray ray = session.renderer().camera_ray(x_px, y_px);
        const PickHit hit = session.renderer().pick(std::span(&ray, 1)).front();
        if (!hit.hit || hit.object != 0)
            return toasts.info("The relief can come from the edited object alone");
        const Dab point = quantised_dab(hit, 0, 1);
        session.set_clone_source({point.face, point.b1, point.b2});
        toasts.info("Relief is copied from there; drag where it is to go");
    });
}

void Desk::keep_camera(int number) {
    const std::string key = camera_key(session.scene().path, number);
    const auto value = std::get<std::vector<double>>(camera_value(session.scene().camera));
    if (attempt([&] { change_preferences([&](Preferences& p) { p.cameras[key] = value; }); }))
        toasts.info("View " + std::to_string(number) + " is kept; Ctrl + " + std::to_string(number) +
                    " goes back to it");
}

void Desk::go_to_camera(int number) {
    const Preferences kept = load_preferences();
    const auto found = kept.cameras.find(camera_key(session.scene().path, number));
    if (found == kept.cameras.end())
        return toasts.info("No view " + std::to_string(number) + " yet; Ctrl + Shift + " +
                           std::to_string(number) + " keeps the one you see");
    set("camera", found->second);
}

void Desk::place_lights(const std::vector<Light>& lights, const glm::dvec3& sky_up) {
    set("lights", lights_value(lights, sky_up));
}

void Desk::turn_light(const glm::dmat3& turn) {
    const Scene& scene = session.scene();
    std::vector<Light> lights = scene.lights;
    for (Light& light : lights) {
        light.direction = turn * light.direction;
        light.position = scene.camera.look_at + turn * (light.position - scene.camera.look_at);
    }
    // Most turns are about the sky's own axis, and leave it as it is.
    const glm::dvec3 now = scene.environment.up, turned = turn * now;
    place_lights(lights, glm::length(turned - now) > 1e-9 ? turned : now);
}

void Desk::turn_light(double degrees, const glm::dvec3& axis) {
    turn_light(turn_about(axis, degrees));
}

void Desk::turn_light(double across_deg, double down_deg) {
    const Camera& camera = session.scene().camera;
    turn_light(turn_about(glm::cross(camera.look_at - camera.eye, camera.up), down_deg) *
               turn_about(camera.up, across_deg));
}

void Desk::flatten_view() {
    const Camera& camera = session.scene().camera;
    const bool flat = camera.fov_deg <= kFlatFovDeg * 1.01;
    if (!flat) view.full_fov_deg = camera.fov_deg;
    set_camera(with_fov(camera, flat ? view.full_fov_deg : kFlatFovDeg));
}

void Desk::toggle_symmetry(std::size_t axis) {
    constexpr std::array kFlags{&Brush::mirror_x, &Brush::mirror_y, &Brush::mirror_z};
    bool& on = session.brush().*kFlags.at(axis);
    on = !on;
    toasts.info(std::string("Symmetry across ") + std::string(axis_names()[axis]) +
                (on ? " is on" : " is off"));
}

void Desk::choose_tool(std::size_t index) {
    if (index >= tools().size()) return;
    session.brush().tool = tools()[index].tool;
    if (session.brush().tool == Tool::stamp && !session.alpha() && !alphas.entries().empty())
        session.set_alpha(alphas.entries().front().alpha);
}

void Desk::next_paint() {
    Brush& brush = session.brush();
    const auto next = (static_cast<std::size_t>(brush.paint) + 1) % paint_names().size();
    brush.paint = static_cast<Paint>(next);
    constexpr std::array kMessages{"Tools change heights", "Tools that raise or lower paint colour alone",
                                   "Tools that raise or lower paint colour as well"};
    toasts.info(kMessages[next]);
}

void Desk::pick_colour() {
    const auto hit = cursor.hit();
    if (!hit) return toasts.info("Point at the surface to take its colour");
    set_colour(session.brush(), session.colour_at(*hit));
}

void Desk::prepare_stroke(const Brush& brush, const std::function<void()>& then) {
    if (paints(brush) && !session.colours()) {
        work = LongWork{"Making a colour map",
                        [this](const Advance& advance) { session.make_colours(view.colour_bits, advance); },
                        [this, then] {
                            live.restart();
                            attempt(then);
                        }};
    } else if (brush.tool == Tool::mask && unready_for_mask()) {
        prepare_for_mask([this, then] { attempt(then); });
    } else {
        then();
    }
}

bool Desk::unready_for_mask() const {
    if (!live.mask_shown() || !live.view_shows_mask()) return false;
    const auto ready = session.renderer().ready();
    return std::ranges::find(ready, vulkan::Pass::aov) == ready.end();
}

void Desk::prepare_for_mask(const std::function<void()>& then) {
    work = LongWork{"Preparing the picture",
                    [this](const Advance& advance) { session.make_ready(vulkan::Pass::aov, advance); }, then,
                    [this](const std::string& trouble) {
                        toasts.error(trouble);
                        show_mask(false);
                    }};
}

void Desk::prepare_picture() {
    if (!work && !session.in_stroke() && session.mask() && unready_for_mask()) prepare_for_mask({});
}

void Desk::keep_colour(const Brush& brush) {
    if (!paints(brush)) return;
    if (!holds(kColouringTools, brush.tool)) return;
    constexpr std::size_t kMostRecent = 8;
    auto& recent = view.recent_colours;
    std::erase(recent, colour_of(brush));
    recent.insert(recent.begin(), colour_of(brush));
    recent.resize(std::min(recent.size(), kMostRecent));
}

void Desk::set_view(View wanted) {
    attempt([&] {
        work = LongWork{"Preparing the view",
                        [this, wanted](const Advance& advance) { live.set_view(wanted, advance); }};
    });
}

void Desk::ask_why(Renderer& renderer, const std::string& method, const glm::ivec2& pixel) {
    attempt([&] {
        work = LongWork{"Preparing the ray's log",
                        [this](const Advance& advance) { session.make_ready(vulkan::Pass::notes, advance); },
                        [this, &renderer, method, pixel] {
                            attempt([&] { why.ask(renderer, reference, method, pixel); });
                        }};
    });
}

void Desk::show_mask(bool wanted) {
    live.set_mask_shown(wanted);
    toasts.info(wanted ? "The mask is shown darker" : "The mask is hidden; it protects all the same");
}

void Desk::change_mask(MaskCommand command) {
    attempt([&] {
        session.require_map("mask");
        work = LongWork{"Changing the mask",
                        [this, command](const Advance& advance) { session.change_mask(command, advance); }};
    });
}

void Desk::split(bool wanted) {
    if (!wanted) {
        attempt([&] { live.compare_with(std::nullopt); });
        return;
    }
    const std::string_view first = find_method(session.scene().method.name).name;
    if (view.second.name.empty())
        for (const Method* method : methods())
            if (method->name != first && view.second.name.empty()) view.second.name = method->name;
    set_second(view.second);
}

void Desk::set_second(const MethodChoice& method) {
    attempt([&] {
        work = LongWork{preparing(method.name),
                        [this, method](const Advance& advance) { live.compare_with(method, advance); },
                        [this, method] { view.second = method; }};
    });
}

}  // namespace relievo::gui
