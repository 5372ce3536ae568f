// See renderer.h. The way of a ray: Renderer::render -> vulkan/passes.cpp (dispatch) -> shaders/trace/beauty.glsl
// (camera ray, shading) -> trace/bundle.glsl, bvh.glsl, query.glsl or pipeline.glsl (boxes, or a driver's
// triangles) -> methods/<name>/intersect.glsl (the surface).
#include "renderer/renderer.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "renderer/give_memory_back.h"
#include "renderer/renderer_state.h"
#include "renderer/stopwatch.h"
#include "renderer/view.h"
#include "renderer/vulkan/functions.h"

namespace relievo {
namespace {

void check_size(const vulkan::Context& context, int width, int height, const char* what) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(context.physical_device(), &properties);
    const auto limit = static_cast<int>(properties.limits.maxImageDimension2D);
    if (width < 1 || height < 1 || width > limit || height > limit)
        throw std::invalid_argument(std::string(what) + " of " + std::to_string(width) + " x " +
                                    std::to_string(height) + ": the device takes 1 to " + std::to_string(limit) +
                                    " a side");
}

// Some drivers compile at a program's first dispatch only.
void dispatch_first(Renderer& renderer, const PassList& compiled) {
    constexpr PixelRect kPixel{0, 0, 1, 1};
    const Ray ray = renderer.camera_ray(0.5, 0.5);
    for (const vulkan::Pass pass : compiled) {
        switch (pass) {
            case vulkan::Pass::beauty:
                renderer.render(kPixel, Quality::preview);
                renderer.restart();
                break;
            case vulkan::Pass::aov:
            case vulkan::Pass::counts:
                renderer.trace_layers(kPixel, pass == vulkan::Pass::counts);
                break;
            case vulkan::Pass::pick:
                renderer.pick(std::span(&ray, 1));
                break;
            case vulkan::Pass::notes:
                renderer.trace_notes(ray);
                break;
        }
        give_memory_back();
    }
}

// The values that what is built depends on.
std::vector<double> built_by(const Method& method, const std::map<std::string, double>& parameters) {
    std::vector<double> values;
    for (const MethodParameter& p : method.parameters)
        if (p.shapes_build) values.push_back(parameters.at(std::string(p.name)));
    return values;
}

}  // namespace

Renderer::Renderer(vulkan::Context& context, const Scene& scene, std::span<const HeightView> maps,
                   const RenderSettings& settings, std::span<const ColourView> colours, const WorkProgress& progress)
    : state_(std::make_unique<State>(context, scene, settings)) {
    if (maps.size() != scene.objects.size()) throw std::logic_error("one map per object");
    if (!colours.empty() && colours.size() != maps.size()) throw std::logic_error("one albedo map per object, or none");
    check_size(context, settings.width, settings.height, "an image");
    Film::check_size(context, settings.width, settings.height);
    for (const HeightView& map : maps) check_size(context, map.width, map.height, "a map");
    state_->colours.assign(colours.begin(), colours.end());
    state_->colours.resize(maps.size());
    state_->load_albedo_files();
    for (const ColourView& c : state_->colours)
        if (!c.empty()) check_size(context, c.width, c.height, "an albedo map");
    state_->maps.assign(maps.begin(), maps.end());
    state_->build(progress);
    dispatch_first(*this, settings.ready);
}

Renderer::~Renderer() { state_->context.wait_idle(); }

UploadStats Renderer::upload(std::size_t object, const HeightView& map, std::span<const TexelRegion> regions) {
    state_->aov_is_fresh = state_->counts_are_fresh = false;
    state_->maps[object] = map;
    const UploadStats stats = state_->gpu_scene->upload(object, map, regions);
    state_->follow_search();
    return stats;
}

void Renderer::upload_colours(std::size_t object, const ColourView& colours, std::span<const TexelRegion> regions) {
    state_->colours.at(object) = colours;
    state_->gpu_scene->upload_colours(object, colours, regions);
}

void Renderer::set_colours(std::size_t object, const ColourView& colours, const WorkProgress& progress) {
    State& s = *state_;
    if (!colours.empty()) check_size(s.context, colours.width, colours.height, "an albedo map");
    std::vector<ColourView> all = s.colours;
    all.at(object) = colours;
    FeatureRequest request = s.request;
    request.has_colours = any_colours(all);
    const Features fresh = derive_features(s.scene, request);
    struct Made {
        std::shared_ptr<AlbedoImage> image;
        std::optional<vulkan::Passes> passes;
    };
    Made made = run_beside(progress, [&](const WorkPart& part) {
        Made m{s.gpu_scene->colour_image(object, colours, part.within(0, 0.7)), {}};
        if (fresh != s.features) m.passes = s.make_passes(*s.method, fresh, s.programs_in_use(), part.within(0.7, 1));
        return m;
    });
    s.colours = std::move(all);
    s.request = request;
    s.features = fresh;
    s.gpu_scene->set_colours(object, std::move(made.image));
    s.gpu_scene->write_bindings(s.set);
    if (made.passes) s.passes = std::move(*made.passes);
    s.restart();
    if (progress) dispatch_first(*this, s.programs_in_use());
}

void Renderer::make_ready(vulkan::Pass pass, const WorkProgress& progress) {
    State& s = *state_;
    if (s.passes.is_made(pass)) return;
    PassList wanted = s.programs_in_use();
    wanted.push_back(pass);
    s.use_features(s.features, wanted, progress);
    dispatch_first(*this, {pass});
}

std::vector<vulkan::Pass> Renderer::ready() const { return state_->programs_in_use(); }

void Renderer::set_camera(const Camera& camera) {
    state_->scene.camera = camera;
    fill_view(state_->frame_data(), camera, state_->scene.origin, width(), height());
    state_->restart();
}

void Renderer::set_lights(const std::vector<Light>& lights, const Environment& environment, const WorkProgress& progress) {
    State& s = *state_;
    std::vector<Light> lights_before = std::exchange(s.scene.lights, lights);
    const Environment environment_before = std::exchange(s.scene.environment, environment);
    bool compiled = false;
    try {
        compiled = s.follow_features(derive_features(s.scene, s.request), progress);
    } catch (...) {
        s.scene.lights = std::move(lights_before);
        s.scene.environment = environment_before;
        throw;
    }
    fill_lights(s.frame_data(), lights, environment, s.scene.origin);
    s.restart();
    if (compiled && progress) dispatch_first(*this, s.programs_in_use());
}

void Renderer::set_material(std::size_t object, const Material& material, const WorkProgress& progress) {
    State& s = *state_;
    const Material before = std::exchange(s.scene.objects[object].material, material);
    bool compiled = false;
    try {
        compiled = s.follow_features(derive_features(s.scene, s.request), progress);
    } catch (...) {
        s.scene.objects[object].material = before;
        throw;
    }
    s.gpu_scene->set_material(object, material);
    s.restart();
    if (compiled && progress) dispatch_first(*this, s.programs_in_use());
}

void Renderer::set_displacement(std::size_t object, double amplitude, double midlevel, const WorkProgress& progress) {
    State& s = *state_;
    Displacement& displacement = s.scene.objects[object].displacement;
    const double amplitude_before = std::exchange(displacement.amplitude, amplitude);
    const double midlevel_before = std::exchange(displacement.midlevel, midlevel);
    bool moved = false, compiled = false;
    try {
        run_beside(progress, [&](const WorkPart& part) {
            s.gpu_scene->set_displacement(object, amplitude, midlevel, part);
            return moved = true;
        });
        compiled = s.follow_search(progress);
    } catch (...) {
        displacement.amplitude = amplitude_before;
        displacement.midlevel = midlevel_before;
        if (moved) s.gpu_scene->set_displacement(object, amplitude_before, midlevel_before, {});
        throw;
    }
    s.restart();
    if (compiled && progress) dispatch_first(*this, s.programs_in_use());
}

void Renderer::set_heights(std::size_t object, const Displacement& displacement, const HeightView& heights,
                           const WorkProgress& progress) {
    State& s = *state_;
    const Displacement displacement_before = std::exchange(s.scene.objects.at(object).displacement, displacement);
    const HeightView heights_before = std::exchange(s.maps[object], heights);
    try {
        s.make_anew(*s.method, s.parameters, {&*s.gpu_scene, object}, progress);
    } catch (...) {
        s.scene.objects[object].displacement = displacement_before;
        s.maps[object] = heights_before;
        throw;
    }
}

void Renderer::set_method(const std::string& name, const std::map<std::string, double>& parameters, const WorkProgress& progress) {
    State& s = *state_;
    const Method& method = find_method(name);
    const auto values = resolve_parameters(method, parameters);
    if (&method != s.method || built_by(method, values) != built_by(method, s.parameters)) {
        s.make_anew(method, values, {&*s.gpu_scene, {}}, progress);
        if (progress) dispatch_first(*this, s.programs_in_use());
        return;
    }
    s.parameters = values;
    s.apply_parameters();
    s.restart();
}

void Renderer::resize(int width, int height) {
    State& s = *state_;
    check_size(s.context, width, height, "an image");
    Film::check_size(s.context, width, height);
    s.settings.width = width;
    s.settings.height = height;
    s.film = Film(s.context, s.commands, width, height);
    s.film.write_bindings(s.context.device(), s.set);
    fill_view(s.frame_data(), s.scene.camera, s.scene.origin, width, height);
    s.samples = 0;
    s.aov_is_fresh = s.counts_are_fresh = false;
}

void Renderer::restart() { state_->restart(); }

void Renderer::restart(const PixelRect& window) {
    state_->samples = 0;
    state_->film.clear(state_->commands, window);
}

double Renderer::render(const PixelRect& window, Quality quality) {
    State& s = *state_;
    const PixelRect w = s.inside(window);
    if (w.x0 >= w.x1 || w.y0 >= w.y1) return 0;
    Stopwatch watch;
    gpu::PushData push{};
    push.offset = {w.x0, w.y0};
    push.extent = {w.x1 - w.x0, w.y1 - w.y0};
    push.sample_index = static_cast<std::uint32_t>(s.samples);
    push.preview = quality == Quality::preview ? 1 : 0;
    s.run(vulkan::Pass::beauty, push, push.extent.x, push.extent.y);
    const PixelRect all = s.whole();
    if (quality == Quality::full && w.x0 == 0 && w.y0 == 0 && w.x1 == all.x1 && w.y1 == all.y1) ++s.samples;
    return watch.lap_ms();
}

double Renderer::render() { return render(state_->whole(), Quality::full); }

void Renderer::end_pass() { ++state_->samples; }

int Renderer::samples() const { return state_->samples; }
int Renderer::width() const { return state_->film.width(); }
int Renderer::height() const { return state_->film.height(); }
const Camera& Renderer::camera() const { return state_->scene.camera; }

double Renderer::last_device_ms() const { return state_->clock.last_ms(); }

Ray Renderer::camera_ray(double x_px, double y_px) const { return ray_through(state_->frame_data(), x_px, y_px); }

const FeatureReport& Renderer::features() const {
    state_->count_bytes();
    return state_->report;
}

Renderer::DisplayImage Renderer::display_image() const {
    return {state_->film.display().get(), width(), height()};
}

}  // namespace relievo
