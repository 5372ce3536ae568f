// The session's renderer, and a second one to compare with: they follow the map and the settings; stages are
// timed.
#pragma once

#include <memory>
#include <span>

#include "brushes/height_map.h"
#include "brushes/texel_rect.h"
#include "editor/session/session.h"
#include "editor/session/settings.h"

namespace relievo {

class SessionView {
  public:
    // `maps`: one a scene object, and `colours`: of objects[0], read during the call only. `scene` outlives
    // the view. Throws as Renderer does.
    SessionView(const Scene& scene, std::span<const HeightMap* const> maps, const ColourView& colours,
                const SessionOptions& options);
    ~SessionView();

    Renderer& renderer() { return *renderer_; }
    // The second renderer, made or told its method.
    Renderer& compare_with(const Scene& scene, std::span<const HeightMap* const> maps,
                           const ColourView& colours, const MethodChoice& method);
    void stop_comparing() { second_.reset(); }
    vulkan::Context& context() { return *context_; }

    // Texels of objects[0] that changed. Fills upload_ms, bounds_ms and refit_ms, of both renderers together.
    void upload(const HeightMap& map, std::span<const TexelRect> rects, StageTimes& times);
    // The same of its colours; adds to upload_ms.
    void upload_colours(const ColourView& colours, std::span<const TexelRect> rects, StageTimes& times);
    void set_colours(const ColourView& colours);          // there were none
    void follow(SettingScope scope, const Scene& scene);  // all but heights
    // objects[0] has other heights.
    void set_heights(const Displacement& displacement, const HeightMap& map);
    void restart();
    void trace(const PixelRect& window, StageTimes& times);

  private:
    std::unique_ptr<vulkan::Context> context_;
    TracePath path_;
    std::unique_ptr<Renderer> renderer_, second_;
};

}  // namespace relievo
