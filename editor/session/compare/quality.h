// The errors of one point after another, against the reference of one scene.
#pragma once

#include <filesystem>
#include <vector>

#include "editor/session/compare/result.h"
#include "editor/session/reference_scene.h"
#include "renderer/judge/judge.h"
#include "renderer/renderer.h"

namespace relievo {

class QualityJudge {
  public:
    // Traces the reference's image. `scene` outlives it.
    QualityJudge(const ReferenceScene& scene, int width, int height);

    const ReferenceImage& image() const { return judge_.image(); }

    struct Measured {
        std::vector<float> beauty;  // linear RGBA
        double frame_ms = 0;        // of a primary and a preview frame, for planning
    };
    // Fills errors, gap, cost and first_frame_ms. Writes `picture` (.jpg) and `error_map` (.png). The
    // renderer has the size of the image.
    Measured measure(Renderer& renderer, ComparedPoint& point, const std::filesystem::path& picture,
                     const std::filesystem::path& error_map) const;

    // What tracing the reference at this size would take, in seconds, from a coarse image of the scene.
    static double estimate_seconds(const ReferenceScene& scene, int width, int height);

  private:
    const ReferenceScene& scene_;
    Judge judge_;
    EdgeProbe probe_;
};

}  // namespace relievo
