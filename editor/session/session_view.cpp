// The session's renderer: follows the map and the settings, and times each stage.
#include "editor/session/session_view.h"

#include "renderer/stopwatch.h"
#include "renderer/vulkan/context.h"

namespace relievo {
namespace {

HeightView view_of(const HeightMap& map) {
    return {map.width(), map.height(), map.texels().data()};
}

std::vector<HeightView> views_of(std::span<const HeightMap* const> maps) {
    std::vector<HeightView> views;
    for (const HeightMap* map : maps) views.push_back(view_of(*map));
    return views;
}

// One an object; the others' files are the renderer's to read.
std::vector<ColourView> colours_of(const Scene& scene, const ColourView& first) {
    std::vector<ColourView> views(scene.objects.size());
    views.front() = first;
    return views;
}

std::vector<TexelRegion> regions_of(std::span<const TexelRect> rects) {
    std::vector<TexelRegion> regions;
    for (const TexelRect& rect : rects) regions.push_back({rect.x0, rect.y0, rect.x1, rect.y1});
    return regions;
}

void follow_with(Renderer& renderer, SettingScope scope, const Scene& scene, const WorkProgress& progress) {
    const SceneObject& object = scene.objects.front();
    switch (scope) {
        case SettingScope::camera:
            return renderer.set_camera(scene.camera);
        case SettingScope::lights:
            return renderer.set_lights(scene.lights, scene.environment, progress);
        case SettingScope::material:
            return renderer.set_material(0, object.material, progress);
        case SettingScope::displacement:
            return renderer.set_displacement(0, object.displacement.amplitude, object.displacement.midlevel, progress);
        case SettingScope::heights:
            return;
        case SettingScope::method:
            return renderer.set_method(scene.method.name, scene.method.parameters, progress);
    }
}

}  // namespace

WorkProgress told_to(const Advance& advance, const std::string& stopped) {
    if (!advance) return {};
    return [advance, stopped](double part) { tell(advance, part, stopped); };
}

SessionView::SessionView(const Scene& scene, std::span<const HeightMap* const> maps,
                         const ColourView& colours, const SessionOptions& options, const std::vector<vulkan::Pass>& ready,
                         const Advance& advance)
    : context_(std::make_unique<vulkan::Context>(
          vulkan::ContextOptions{options.device, options.validation, options.for_window})),
      path_(options.path) {
    RenderSettings settings;
    settings.width = options.width > 0 ? options.width : scene.image.width;
    settings.height = options.height > 0 ? options.height : scene.image.height;
    settings.method = scene.method.name;
    settings.parameters = scene.method.parameters;
    settings.path = options.path;
    settings.ready = ready;
    renderer_ = std::make_unique<Renderer>(*context_, scene, views_of(maps), settings, colours_of(scene, colours),
                                           told_to(advance, kOpeningStopped));
}

SessionView::~SessionView() = default;

Renderer& SessionView::compare_with(const Scene& scene, std::span<const HeightMap* const> maps,
                                    const ColourView& colours, const MethodChoice& method, const Advance& advance) {
    if (second_) {
        second_->set_method(method.name, method.parameters, told_to(advance));
        return *second_;
    }
    RenderSettings settings;
    settings.width = renderer_->width();
    settings.height = renderer_->height();
    settings.method = method.name;
    settings.parameters = method.parameters;
    settings.path = path_;
    if (advance) settings.ready = renderer_->ready();
    second_ = std::make_unique<Renderer>(*context_, scene, views_of(maps), settings, colours_of(scene, colours),
                                         told_to(advance));
    return *second_;
}

void SessionView::upload(const HeightMap& map, std::span<const TexelRect> rects, StageTimes& times) {
    times.upload_ms = times.bounds_ms = times.refit_ms = 0;
    if (rects.empty()) return;
    const std::vector<TexelRegion> regions = regions_of(rects);
    const UploadStats stats = renderer_->upload(0, view_of(map), regions);
    times.upload_ms = stats.copy_ms;
    times.bounds_ms = stats.bounds_ms;
    times.refit_ms = stats.refit_ms;
    if (!second_) return;
    const UploadStats more = second_->upload(0, view_of(map), regions);
    times.upload_ms += more.copy_ms;
    times.bounds_ms += more.bounds_ms;
    times.refit_ms += more.refit_ms;
}

void SessionView::upload_colours(const ColourView& colours, std::span<const TexelRect> rects,
                                 StageTimes& times) {
    if (rects.empty()) return;
    Stopwatch watch;
    renderer_->upload_colours(0, colours, regions_of(rects));
    if (second_) second_->upload_colours(0, colours, regions_of(rects));
    times.upload_ms += watch.lap_ms();
}

void SessionView::change_both(const Advance& advance, const std::function<void(Renderer&, const WorkProgress&)>& change,
                              const std::function<void(Renderer&)>& undo) {
    const double first = second_ ? 0.5 : 1;
    change(*renderer_, told_to(within(advance, 0, first)));
    if (!second_) return;
    try {
        change(*second_, told_to(within(advance, first, 1)));
    } catch (...) {
        undo(*renderer_);
        throw;
    }
}

void SessionView::make_ready(vulkan::Pass pass, const Advance& advance) {
    change_both(
        advance, [pass](Renderer& r, const WorkProgress& progress) { r.make_ready(pass, progress); }, [](Renderer&) {});
}

void SessionView::set_colours(const ColourView& colours, const Advance& advance) {
    change_both(
        advance, [&](Renderer& r, const WorkProgress& progress) { r.set_colours(0, colours, progress); },
        [](Renderer& r) { r.set_colours(0, {}); });
}

void SessionView::follow(SettingScope scope, const Scene& scene, const Advance& advance) {
    const bool both = second_ && scope != SettingScope::method;
    const double first = both ? 0.5 : 1;
    follow_with(*renderer_, scope, scene, told_to(within(advance, 0, first)));
    if (both) follow_with(*second_, scope, scene, told_to(within(advance, first, 1)));
}

void SessionView::set_heights(const Heights& wanted, const Heights& before, const Advance& advance) {
    change_both(
        advance,
        [&](Renderer& r, const WorkProgress& progress) {
            r.set_heights(0, wanted.displacement, view_of(wanted.map), progress);
        },
        [&](Renderer& r) { r.set_heights(0, before.displacement, view_of(before.map)); });
}

void SessionView::restart() {
    renderer_->restart();
    if (second_) second_->restart();
}

void SessionView::trace(const PixelRect& window, StageTimes& times) {
    times.trace_ms = renderer_->render(window, Quality::preview);
}

}  // namespace relievo
