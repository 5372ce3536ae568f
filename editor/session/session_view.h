// The session's renderer: follows the map and the settings, and times each stage.
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
    // `maps`: one a scene object, read during the call only. `scene` outlives the view. Throws as Renderer
    // does.
    SessionView(const Scene& scene, std::span<const HeightMap* const> maps, const SessionOptions& options);
    ~SessionView();

    Renderer& renderer() { return *renderer_; }
    vulkan::Context& context() { return *context_; }

    // Texels of objects[0] that changed. Fills upload_ms, bounds_ms and refit_ms.
    void upload(const HeightMap& map, std::span<const TexelRect> rects, StageTimes& times);
    void follow(SettingScope scope, const Scene& scene);
    void trace(const PixelRect& window, StageTimes& times);

  private:
    std::unique_ptr<vulkan::Context> context_;
    std::unique_ptr<Renderer> renderer_;
};

}  // namespace relievo
