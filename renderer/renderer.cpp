// See renderer.h. The way of a ray: Renderer::render -> vulkan/passes.cpp (dispatch) -> shaders/trace/beauty.glsl
// (camera ray, shading) -> trace/bvh.glsl, query.glsl or pipeline.glsl (boxes) -> methods/<name>/intersect.glsl (the surface).
#include "renderer/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "renderer/albedo_file.h"
#include "renderer/bindings.h"
#include "renderer/features.h"
#include "renderer/film.h"
#include "renderer/gpu_scene.h"
#include "renderer/mended_meshes.h"
#include "renderer/methods/registry.h"
#include "renderer/single_rays.h"
#include "renderer/stopwatch.h"
#include "renderer/view.h"
#include "renderer/vulkan/device_clock.h"
#include "renderer/vulkan/functions.h"
#include "renderer/vulkan/passes.h"

namespace relievo {
namespace {

constexpr double kLeastRayOffset = 1e-4;  // of an object's radius

void check_size(const vulkan::Context& context, int width, int height, const char* what) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(context.physical_device(), &properties);
    const auto limit = static_cast<int>(properties.limits.maxImageDimension2D);
    if (width < 1 || height < 1 || width > limit || height > limit)
        throw std::invalid_argument(std::string(what) + " of " + std::to_string(width) + " x " +
                                    std::to_string(height) + ": the device takes 1 to " + std::to_string(limit) +
                                    " a side");
}

// The values that what is built depends on.
std::vector<double> built_by(const Method& method, const std::map<std::string, double>& parameters) {
    std::vector<double> values;
    for (const MethodParameter& p : method.parameters)
        if (p.shapes_build) values.push_back(parameters.at(std::string(p.name)));
    return values;
}

// Of a method that samples along the ray, in bounding-sphere radii; 0 for others. A sampled surface is off by part of a
// step: shadow rays start beyond that.
double sampling_step(const std::map<std::string, double>& parameters) {
    if (const auto dt = parameters.find("dt"); dt != parameters.end()) return dt->second;
    if (const auto steps = parameters.find("steps"); steps != parameters.end()) return 2 / steps->second;
    return 0;
}

}  // namespace

struct Renderer::State {
    vulkan::Context& context;
    vulkan::Commands commands;
    vulkan::DeviceClock clock;
    Scene scene;  // as rendered now: camera, lights and materials follow the setters
    RenderSettings settings;
    const Method* method;
    std::map<std::string, double> parameters;
    MendedMeshes mended;
    FeatureRequest request;
    Features features;
    std::optional<GpuScene> gpu_scene;
    Film film;
    vulkan::Buffer frame;
    SingleRays single_rays;
    vulkan::SetLayoutHandle set_layout;
    vulkan::DescriptorPoolHandle pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    vulkan::Passes passes;
    FeatureReport report;
    std::vector<AlbedoFile> albedo_files;  // of the objects that were given no colours; another method uploads them again
    std::vector<ColourView> colours;       // one an object; empty: none
    std::vector<HeightView> maps;  // as last uploaded: another method may need other structures over them
    int samples = 0;
    bool aov_is_fresh = false, counts_are_fresh = false;

    State(vulkan::Context& c, const Scene& s, const RenderSettings& r)
        : context(c), commands(c), clock(c), scene(s), settings(r), method(&find_method(r.method)),
          parameters(resolve_parameters(*method, r.parameters)), mended(scene) {}

    gpu::FrameData& frame_data() { return *frame.as<gpu::FrameData>(); }
    PixelRect whole() const { return {0, 0, film.width(), film.height()}; }
    PixelRect inside(const PixelRect& window) const {
        return {std::max(0, window.x0), std::max(0, window.y0), std::min(film.width(), window.x1),
                std::min(film.height(), window.y1)};
    }
    void build();
    void build_scene();
    void load_albedo_files();
    void rebuild_for(const Method& method);
    void write_addresses();
    void make_set();
    void make_passes();
    void follow_search();
    void apply_parameters();
    void write_own_bindings() const;
    void run(vulkan::Pass pass, const gpu::PushData& push, int width, int height);
    void run_unjittered(vulkan::Pass pass, const gpu::PushData& push, int width, int height);
    void count_bytes();
    void restart();
};

void Renderer::State::load_albedo_files() {
    albedo_files.reserve(colours.size());  // views point into them
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const std::filesystem::path& file = scene.objects[i].material.albedo_map;
        if (!colours[i].empty() || file.empty()) continue;
        albedo_files.push_back(load_albedo_file(file));
        colours[i] = albedo_files.back().view();
    }
}

void Renderer::State::build_scene() {
    request.has_searched = false;
    const auto density = parameters.find("density");
    request.density = density == parameters.end() ? 0 : density->second;
    features = derive_features(scene, request);
    const std::vector<Mesh> meshes = mended.traced(features.mended_creases);
    if (features.micro_triangles) {  // may be refused: then what was there must not be gone
        GpuScene fresh(context, commands, scene, maps, colours, features, meshes);
        gpu_scene.emplace(std::move(fresh));
    } else {
        gpu_scene.emplace(context, commands, scene, maps, colours, features, meshes);
    }
    request.has_searched = gpu_scene->any_searched();
    features = derive_features(scene, request);
}

void Renderer::State::rebuild_for(const Method& m) {
    method = request.method = &m;
    build_scene();
    write_addresses();
    gpu_scene->write_bindings(set);
    make_passes();
}

void Renderer::State::build() {
    request = {method, settings.everything, mended.any(),
               resolve_trace_path(settings.path, context.info()), settings.path != TracePath::automatic};
    request.has_colours = std::any_of(colours.begin(), colours.end(), [](const ColourView& c) { return !c.empty(); });
    build_scene();
    film = Film(context, commands, settings.width, settings.height);
    frame = vulkan::Buffer(context, sizeof(gpu::FrameData), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, vulkan::Access::host);
    single_rays = SingleRays(context);
    frame_data() = {};
    frame_data().object_count = static_cast<std::uint32_t>(scene.objects.size());
    fill_view(frame_data(), scene.camera, scene.origin, settings.width, settings.height);
    fill_lights(frame_data(), scene.lights, scene.environment, scene.origin);
    write_addresses();
    make_set();
    make_passes();
    apply_parameters();
}

void Renderer::State::write_addresses() {
    frame_data().bvh = vulkan::address_words(gpu_scene->bvh_address());
    frame_data().primitives = vulkan::address_words(gpu_scene->primitive_address());
    frame_data().micro_vertices = vulkan::address_words(gpu_scene->micro_vertices());
    frame_data().micro_triangles = vulkan::address_words(gpu_scene->micro_triangles());
}

void Renderer::State::make_set() {
    const std::size_t objects = scene.objects.size();
    set_layout = make_set_layout(context, objects, features.path);
    pool = make_pool(context, objects, features.path);
    const VkDescriptorSetLayout layout = set_layout.get();
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, nullptr, pool.get(), 1, &layout};
    vulkan::check(vkAllocateDescriptorSets(context.device(), &info, &set), "allocating a descriptor set");
    gpu_scene->write_bindings(set);
    film.write_bindings(context.device(), set);
    write_own_bindings();
}

void Renderer::State::write_own_bindings() const {
    const VkDescriptorBufferInfo buffer{frame.get(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.dstBinding = gpu::kBindFrame;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    write.pBufferInfo = &buffer;
    vkUpdateDescriptorSets(context.device(), 1, &write, 0, nullptr);
    single_rays.write_bindings(context.device(), set);
}

void Renderer::State::make_passes() {
    vulkan::SpecConstants constants{};
    constants[gpu::kSpecObjects] = static_cast<std::uint32_t>(scene.objects.size());
    constants[gpu::kSpecShadows] = features.shadows ? 1 : 0;
    constants[gpu::kSpecOpacity] = features.opacity ? 1 : 0;
    constants[gpu::kSpecGloss] = features.gloss ? 1 : 0;
    constants[gpu::kSpecSky] = features.sky ? 1 : 0;
    constants[gpu::kSpecSearch] = features.searched ? 1 : 0;
    constants[gpu::kSpecProcedural] = features.procedural ? 1 : 0;
    constants[gpu::kSpecAlbedo] = features.albedo_maps ? 1 : 0;
    passes = vulkan::Passes(context, set_layout.get(), method->name, features.path, constants);
}

// An edit may fold a shell for the first time.
void Renderer::State::follow_search() {
    if (gpu_scene->any_searched() == request.has_searched) return;
    request.has_searched = gpu_scene->any_searched();
    features = derive_features(scene, request);
    make_passes();
}

void Renderer::State::apply_parameters() {
    std::array<float, 8> values{};
    for (std::size_t i = 0; i < method->parameters.size(); ++i)
        values[i] = static_cast<float>(parameters.at(std::string(method->parameters[i].name)));
    frame_data().parameters0 = {values[0], values[1], values[2], values[3]};
    frame_data().parameters1 = {values[4], values[5], values[6], values[7]};
    gpu_scene->set_ray_offset(std::max(kLeastRayOffset, 0.5 * sampling_step(parameters)));
}

void Renderer::State::run(vulkan::Pass pass, const gpu::PushData& push, int width, int height) {
    commands.run([&](VkCommandBuffer cmd) {
        vulkan::memory_barrier(cmd);
        if (pass == vulkan::Pass::counts) film.clear_ray_counts(cmd, push.offset.y, push.offset.y + push.extent.y);
        clock.begin(cmd);
        passes.record(cmd, pass, set, push, width, height);
        clock.end(cmd);
        vulkan::memory_barrier(cmd);
    });
}

// Layers and picks show the method's own answer without the noise of its jitter, where it has one.
void Renderer::State::run_unjittered(vulkan::Pass pass, const gpu::PushData& push, int width, int height) {
    const auto saved = parameters;
    const auto jitter = parameters.find("jitter");
    if (jitter != parameters.end()) jitter->second = 0;
    apply_parameters();
    run(pass, push, width, height);
    parameters = saved;
    apply_parameters();
}

void Renderer::State::restart() {
    samples = 0;
    aov_is_fresh = counts_are_fresh = false;
    film.clear(commands, whole());
}

void Renderer::State::count_bytes() {
    report = describe_features(scene, request, features, parameters);
    for (Feature& f : report.features) {
        if (f.name == "base mesh prisms") f.bytes = gpu_scene->primitive_bytes();
        if (f.name == trace_path_words(features.path)) f.bytes = gpu_scene->tree_bytes();
        if (f.name == "micro-triangles") f.bytes = gpu_scene->micro_bytes();
        if (f.name == "displacement maps") f.bytes = gpu_scene->map_bytes();
        if (f.name == "procedural heights" && f.built) f.bytes = gpu_scene->procedural_bytes();
        if (f.name == "min-max pyramid") f.bytes = gpu_scene->pyramid_bytes();
        if (f.name == "opacity maps" && f.built) f.bytes = gpu_scene->opacity_bytes();
        if (f.name == "albedo maps" && f.built) f.bytes = gpu_scene->albedo_bytes();
        if (f.name == "image") f.bytes = film.image_bytes();
        const auto on_demand = [&](const char* name, bool built, const char* reason, std::uint64_t bytes) {
            if (!built || f.name != name) return;
            f.built = true;
            f.reason = reason;
            f.bytes = bytes;
        };
        on_demand("layers", film.has_aov(), "layers were asked for", film.aov_bytes());
        on_demand("picking", single_rays.has_picks(), "rays were picked", single_rays.pick_bytes());
        on_demand("counters", film.has_ray_counts(), "counts were asked for", film.ray_counts_bytes());
        on_demand("ray log", single_rays.has_notes(), "a ray was logged", single_rays.note_bytes());
        on_demand("upload staging", gpu_scene->staging_bytes() > 0, "the map was edited", gpu_scene->staging_bytes());
        report.bytes_total += f.bytes;
    }
}

Renderer::Renderer(vulkan::Context& context, const Scene& scene, std::span<const HeightView> maps,
                   const RenderSettings& settings, std::span<const ColourView> colours)
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
    state_->build();
}

Renderer::~Renderer() { vkDeviceWaitIdle(state_->context.device()); }

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

void Renderer::set_colours(std::size_t object, const ColourView& colours) {
    State& s = *state_;
    check_size(s.context, colours.width, colours.height, "an albedo map");
    s.colours.at(object) = colours;
    s.gpu_scene->set_colours(object, colours);
    s.gpu_scene->write_bindings(s.set);
    s.request.has_colours = true;
    const Features fresh = derive_features(s.scene, s.request);
    if (fresh != s.features) {
        s.features = fresh;
        s.make_passes();
    }
    s.restart();
}

void Renderer::set_camera(const Camera& camera) {
    state_->scene.camera = camera;
    fill_view(state_->frame_data(), camera, state_->scene.origin, width(), height());
    state_->restart();
}

void Renderer::set_lights(const std::vector<Light>& lights, const Environment& environment) {
    State& s = *state_;
    s.scene.lights = lights;
    s.scene.environment = environment;
    fill_lights(s.frame_data(), lights, environment, s.scene.origin);
    s.features = derive_features(s.scene, s.request);
    s.make_passes();
    s.restart();
}

void Renderer::set_material(std::size_t object, const Material& material) {
    State& s = *state_;
    s.scene.objects[object].material = material;
    s.gpu_scene->set_material(object, material);
    const Features fresh = derive_features(s.scene, s.request);
    if (fresh.gloss != s.features.gloss) {
        s.features = fresh;
        s.make_passes();
    }
    s.restart();
}

void Renderer::set_displacement(std::size_t object, double amplitude, double midlevel) {
    State& s = *state_;
    s.scene.objects[object].displacement.amplitude = amplitude;
    s.scene.objects[object].displacement.midlevel = midlevel;
    s.gpu_scene->set_displacement(object, amplitude, midlevel);
    s.follow_search();
    s.restart();
}

void Renderer::set_heights(std::size_t object, const Displacement& displacement, const HeightView& heights) {
    State& s = *state_;
    const Displacement displacement_before = std::exchange(s.scene.objects.at(object).displacement, displacement);
    const HeightView heights_before = std::exchange(s.maps[object], heights);
    const Features before = s.features;
    const FeatureRequest request_before = s.request;
    try {
        s.build_scene();
    } catch (const std::invalid_argument&) {  // refused
        s.scene.objects[object].displacement = displacement_before;
        s.maps[object] = heights_before;
        s.request = request_before;
        s.features = before;
        throw;
    }
    s.write_addresses();
    s.gpu_scene->write_bindings(s.set);
    if (s.features != before) s.make_passes();
    s.apply_parameters();
    s.restart();
}

void Renderer::set_method(const std::string& name, const std::map<std::string, double>& parameters) {
    State& s = *state_;
    const Method& method = find_method(name);
    const auto before = std::exchange(s.parameters, resolve_parameters(method, parameters));
    if (&method != s.method || built_by(method, before) != built_by(method, s.parameters)) {
        const FeatureRequest request_before = s.request;
        const Features features_before = s.features;
        try {
            s.rebuild_for(method);
        } catch (const std::invalid_argument&) {  // refused
            s.parameters = before;
            s.request = request_before;
            s.method = request_before.method;
            s.features = features_before;
            throw;
        }
    }
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

std::vector<float> Renderer::read_back(Layer layer) {
    State& s = *state_;
    if (layer == Layer::beauty) return s.film.beauty(s.context, s.commands);
    const bool counting = layer == Layer::counts;
    if (counting ? !s.counts_are_fresh : !s.aov_is_fresh) {
        trace_layers(s.whole(), counting);
        s.aov_is_fresh = true;
        s.counts_are_fresh = s.counts_are_fresh || counting;
    }
    return s.film.layer(layer, s.whole());
}

double Renderer::trace_layers(const PixelRect& window, bool with_counts) {
    State& s = *state_;
    const PixelRect w = s.inside(window);
    if (w.x0 >= w.x1 || w.y0 >= w.y1) return 0;
    if (!s.film.has_aov() || (with_counts && !s.film.has_ray_counts())) {
        s.film.make_aov(s.context);
        if (with_counts) s.film.make_ray_counts(s.context);
        s.film.write_bindings(s.context.device(), s.set);
    }
    // Counts of whole rows are cleared, of which the window may be a part.
    if (with_counts) s.counts_are_fresh = false;
    Stopwatch watch;
    const bool whole_fits = s.film.aov_rows() == height();
    for (int y0 = w.y0; y0 < w.y1; y0 += s.film.aov_rows()) {
        const int y1 = std::min(w.y1, y0 + s.film.aov_rows());
        gpu::PushData push{};
        push.offset = {w.x0, y0};
        push.extent = {w.x1 - w.x0, y1 - y0};
        push.first_row = whole_fits ? 0 : static_cast<std::uint32_t>(y0);
        s.run_unjittered(with_counts ? vulkan::Pass::counts : vulkan::Pass::aov, push, push.extent.x, push.extent.y);
        s.film.keep_aov({w.x0, y0, w.x1, y1});
    }
    return watch.lap_ms();
}

std::vector<float> Renderer::traced_layer(Layer layer, const PixelRect& window) const {
    return state_->film.layer(layer, state_->inside(window));
}

double Renderer::trace_layers() {
    const double ms = trace_layers(state_->whole());
    state_->aov_is_fresh = true;
    return ms;
}

double Renderer::last_device_ms() const { return state_->clock.last_ms(); }

std::vector<std::uint8_t> Renderer::read_back_display() {
    return state_->film.display_pixels(state_->context, state_->commands);
}

std::vector<PickHit> Renderer::pick(std::span<const Ray> rays) {
    State& s = *state_;
    std::vector<PickHit> hits(rays.size());
    if (!rays.empty() && s.single_rays.make_picks(s.context)) s.write_own_bindings();
    for (std::size_t first = 0; first < rays.size(); first += SingleRays::kBatch) {
        const std::size_t count = std::min(SingleRays::kBatch, rays.size() - first);
        s.single_rays.put(rays.subspan(first, count));
        gpu::PushData push{};
        push.ray_count = static_cast<std::uint32_t>(count);
        s.run_unjittered(vulkan::Pass::pick, push, static_cast<int>(count), 1);
        s.single_rays.take(s.mended, std::span(hits).subspan(first, count));
    }
    return hits;
}

TraceLog Renderer::trace_notes(const Ray& ray) {
    State& s = *state_;
    const bool picks_made = s.single_rays.make_picks(s.context), notes_made = s.single_rays.make_notes(s.context);
    if (picks_made || notes_made) s.write_own_bindings();
    s.single_rays.put({&ray, 1});
    gpu::PushData push{};
    push.ray_count = 1;
    s.run_unjittered(vulkan::Pass::notes, push, 1, 1);
    return s.single_rays.log(*s.gpu_scene);
}

Ray Renderer::camera_ray(double x_px, double y_px) const { return ray_through(state_->frame_data(), x_px, y_px); }

const FeatureReport& Renderer::features() const {
    state_->count_bytes();
    return state_->report;
}

Renderer::DisplayImage Renderer::display_image() const {
    return {state_->film.display().get(), width(), height()};
}

}  // namespace relievo
