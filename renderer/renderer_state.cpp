// See renderer_state.h: building what a scene and a method need, and running the passes.
#include "renderer/renderer_state.h"

#include <array>
#include <filesystem>

#include "renderer/bindings.h"
#include "renderer/give_memory_back.h"
#include "renderer/view.h"
#include "renderer/vulkan/functions.h"

namespace relievo {
namespace {

constexpr double kLeastRayOffset = 1e-4;  // of an object's radius

// Of a method that samples along the ray, in bounding-sphere radii; 0 for others. A sampled surface is off by part of a
// step: shadow rays start beyond that.
double sampling_step(const std::map<std::string, double>& parameters) {
    if (const auto dt = parameters.find("dt"); dt != parameters.end()) return dt->second;
    if (const auto steps = parameters.find("steps"); steps != parameters.end()) return 2 / steps->second;
    return 0;
}

}  // namespace

void Renderer::State::load_albedo_files() {
    albedo_files.reserve(colours.size());  // views point into them
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const std::filesystem::path& file = scene.objects[i].material.albedo_map;
        if (!colours[i].empty() || file.empty()) continue;
        albedo_files.push_back(load_albedo_file(file));
        colours[i] = albedo_files.back().view();
    }
}

Renderer::State::Made Renderer::State::make(const Method& of, const std::map<std::string, double>& values,
                                            const SceneBefore& before, const PassList& compiled, const WorkPart& part) {
    const double scene_made = compiled.empty() ? 1 : 0.6;  // part of the time, about
    FeatureRequest wanted = request;
    wanted.method = &of;
    wanted.has_searched = wanted.has_slants = false;
    const auto density = values.find("density");
    wanted.density = density == values.end() ? 0 : density->second;
    const Features first = derive_features(scene, wanted);
    GpuScene fresh(context, commands, scene, maps, colours, first, mended.traced(first.mended_creases), before,
                   part.within(0, scene_made));
    wanted.has_searched = fresh.any_searched();
    wanted.has_slants = fresh.any_slanted();
    const Features all = derive_features(scene, wanted);
    vulkan::Passes fresh_passes = make_passes(of, all, compiled, part.within(scene_made, 1));
    return {&of, values, wanted, all, std::move(fresh), std::move(fresh_passes)};
}

void Renderer::State::take(Made made) {
    method = made.method;
    parameters = std::move(made.parameters);
    request = made.request;
    features = made.features;
    gpu_scene.emplace(std::move(made.scene));
    passes = std::move(made.passes);
}

void Renderer::State::make_anew(const Method& of, const std::map<std::string, double>& values, const SceneBefore& before,
                                const WorkProgress& progress) {
    take(run_beside(progress, [&](const WorkPart& part) { return make(of, values, before, programs_in_use(), part); }));
    write_addresses();
    gpu_scene->write_bindings(set);
    apply_parameters();
    restart();
}

PassList Renderer::State::programs_in_use() const {
    PassList used;
    for (std::size_t i = 0; i < vulkan::kPassCount; ++i)
        if (const auto pass = static_cast<vulkan::Pass>(i); passes.is_made(pass)) used.push_back(pass);
    return used;
}

void Renderer::State::build(const WorkProgress& progress) {
    request = {method, settings.everything, mended.any(),
               resolve_trace_path(settings.path, context.info()), settings.path != TracePath::automatic};
    request.can_bundle = context.info().bundles;
    request.dense_sheet = is_dense_sheet(scene, settings.width, settings.height);
    request.has_colours = any_colours(colours);
    set_layout = make_set_layout(context, scene.objects.size(), request.path);
    take(run_beside(progress, [&](const WorkPart& part) { return make(*method, parameters, {}, settings.ready, part); }));
    film = Film(context, commands, settings.width, settings.height);
    frame = vulkan::Buffer(context, sizeof(gpu::FrameData), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, vulkan::Access::host);
    single_rays = SingleRays(context);
    frame_data() = {};
    frame_data().object_count = static_cast<std::uint32_t>(scene.objects.size());
    fill_view(frame_data(), scene.camera, scene.origin, settings.width, settings.height);
    fill_lights(frame_data(), scene.lights, scene.environment, scene.origin);
    write_addresses();
    make_set();
    apply_parameters();
}

void Renderer::State::write_addresses() {
    frame_data().bvh = vulkan::address_words(gpu_scene->bvh_address());
    frame_data().primitives = vulkan::address_words(gpu_scene->primitive_address());
    frame_data().micro_vertices = vulkan::address_words(gpu_scene->micro_vertices());
    frame_data().micro_corners = vulkan::address_words(gpu_scene->micro_corners());
    frame_data().micro_primitives = vulkan::address_words(gpu_scene->micro_primitives());
}

void Renderer::State::make_set() {
    const std::size_t objects = scene.objects.size();
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

vulkan::Passes Renderer::State::make_passes(const Method& of, const Features& by, const PassList& compiled,
                                            const WorkPart& part) const {
    vulkan::SpecConstants constants{};
    constants[gpu::kSpecObjects] = static_cast<std::uint32_t>(scene.objects.size());
    constants[gpu::kSpecShadows] = by.shadows ? 1 : 0;
    constants[gpu::kSpecOpacity] = by.opacity ? 1 : 0;
    constants[gpu::kSpecGloss] = by.gloss ? 1 : 0;
    constants[gpu::kSpecSky] = by.sky ? 1 : 0;
    constants[gpu::kSpecSearch] = by.searched ? 1 : 0;
    constants[gpu::kSpecSlants] = by.slants ? 1 : 0;
    constants[gpu::kSpecProcedural] = by.procedural ? 1 : 0;
    constants[gpu::kSpecAlbedo] = by.albedo_maps ? 1 : 0;
    vulkan::Passes made(context, set_layout.get(), of.name, by.path, by.driver_triangles, by.bundles, constants);
    const auto count = static_cast<double>(compiled.size());
    for (std::size_t i = 0; i < compiled.size(); ++i) {
        part.at(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        made.make(compiled[i]);
        give_memory_back();
    }
    return made;
}

void Renderer::State::use_features(const Features& fresh, const PassList& compiled, const WorkProgress& progress) {
    passes = run_beside(progress, [&](const WorkPart& part) { return make_passes(*method, fresh, compiled, part); });
    features = fresh;
}

bool Renderer::State::follow_features(const Features& fresh, const WorkProgress& progress) {
    if (fresh == features) return false;
    use_features(fresh, progress ? programs_in_use() : PassList(), progress);
    return true;
}

// An edit or another amplitude may fold a shell for the first time.
bool Renderer::State::follow_search(const WorkProgress& progress) {
    FeatureRequest wanted = request;
    wanted.has_searched = gpu_scene->any_searched();
    if (wanted.has_searched == request.has_searched) return false;
    const bool other = follow_features(derive_features(scene, wanted), progress);
    request = wanted;
    return other;
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
        if (f.name == "bounds about planes") f.bytes = gpu_scene->slab_bytes();
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

}  // namespace relievo
