// What a renderer tells of its image, pixel by pixel or ray by ray: layers, picks, and a ray's log.
#include <algorithm>

#include "renderer/renderer_state.h"
#include "renderer/stopwatch.h"

namespace relievo {

std::vector<float> Renderer::read_back(Layer layer) {
    State& s = *state_;
    if (layer == Layer::beauty) return traced_layer(layer, s.whole());
    const bool counting = layer == Layer::counts;
    if (counting ? !s.counts_are_fresh : !s.aov_is_fresh) {
        trace_layers(s.whole(), counting);
        s.aov_is_fresh = true;
        s.counts_are_fresh = s.counts_are_fresh || counting;
    }
    return traced_layer(layer, s.whole());
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
    State& s = *state_;
    const PixelRect w = s.inside(window);
    if (layer == Layer::beauty) return s.film.beauty(s.context, s.commands, w);
    return layer == Layer::counts ? s.film.ray_counts(s.context, s.commands, w) : s.film.layer(layer, w);
}

double Renderer::trace_layers() {
    const double ms = trace_layers(state_->whole());
    state_->aov_is_fresh = true;
    return ms;
}

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
        s.single_rays.take(s.mended, rays.subspan(first, count), std::span(hits).subspan(first, count));
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

}  // namespace relievo
