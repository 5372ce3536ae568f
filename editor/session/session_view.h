// The session's renderer, and a second one to compare with: they follow the map and the settings; stages are
// timed.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "brushes/advance.h"
#include "brushes/height_map.h"
#include "brushes/texel_rect.h"
#include "editor/session/session.h"
#include "editor/session/settings.h"

namespace relievo {

inline constexpr const char *kAllAsItWas = "Stopped: all is as it was", *kOpeningStopped = "Opening was stopped";
// For work of a renderer.
WorkProgress told_to(const Advance& advance, const std::string& stopped = kAllAsItWas);

class SessionView {
  public:
    // `maps`: one a scene object, and `colours`: of objects[0], read during the call only. `scene` outlives
    // the view. `ready`: as RenderSettings has it. Throws as Renderer does. `advance` here and below: what it stops leaves
    // both renderers as they were.
    SessionView(const Scene& scene, std::span<const HeightMap* const> maps, const ColourView& colours,
                const SessionOptions& options, const std::vector<vulkan::Pass>& ready, const Advance& advance);
    ~SessionView();

    Renderer& renderer() { return *renderer_; }
    // The second renderer, made or told its method.
    Renderer& compare_with(const Scene& scene, std::span<const HeightMap* const> maps,
                           const ColourView& colours, const MethodChoice& method, const Advance& advance);
    void stop_comparing() { second_.reset(); }
    void make_ready(vulkan::Pass pass, const Advance& advance);  // both
    vulkan::Context& context() { return *context_; }

    // Texels of objects[0] that changed. Fills upload_ms, bounds_ms and refit_ms, of both renderers together.
    void upload(const HeightMap& map, std::span<const TexelRect> rects, StageTimes& times);
    // The same of its colours; adds to upload_ms.
    void upload_colours(const ColourView& colours, std::span<const TexelRect> rects, StageTimes& times);
    void set_colours(const ColourView& colours, const Advance& advance);  // there were none
    void follow(SettingScope scope, const Scene& scene, const Advance& advance);  // all but heights
    // What objects[0] is displaced by.
    struct Heights {
        const Displacement& displacement;
        const HeightMap& map;
    };
    void set_heights(const Heights& wanted, const Heights& before, const Advance& advance);
    void restart();
    void trace(const PixelRect& window, StageTimes& times);

  private:
    // Both, one after the other; where the second throws, the first gets `undo`.
    void change_both(const Advance& advance, const std::function<void(Renderer&, const WorkProgress&)>& change,
                     const std::function<void(Renderer&)>& undo);

    std::unique_ptr<vulkan::Context> context_;
    TracePath path_;
    std::unique_ptr<Renderer> renderer_, second_;
};

}  // namespace relievo
