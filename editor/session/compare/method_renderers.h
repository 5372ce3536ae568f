// One renderer over the same scene for every method, and for every value of what shapes its structures, so that
// rounds can change from point to point without building anything.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "editor/session/compare/points.h"
#include "editor/session/reference_scene.h"
#include "renderer/features.h"
#include "renderer/renderer.h"

namespace relievo {

class MethodRenderers {
  public:
    // `scene` outlives it.
    MethodRenderers(vulkan::Context& context, const ReferenceScene& scene, int width, int height,
                    TracePath path);
    ~MethodRenderers();

    // The renderer with the point's parameters, its image forgotten. Built at first use; std::invalid_argument where
    // the method refuses.
    Renderer& select(const PointChoice& point);
    void resize(int width, int height);

    // What the first use took.
    struct Build {
        double ms = 0;
        FeatureReport features;
    };
    const Build& build_of(const PointChoice& point) const;

  private:
    using Key = std::pair<const Method*, std::map<std::string, double>>;
    static Key key_of(const PointChoice& point);
    struct OfMethod {
        std::unique_ptr<Renderer> renderer;
        Build build;
    };
    vulkan::Context& context_;
    const Scene& scene_;
    std::vector<HeightView> maps_;
    RenderSettings settings_;
    std::map<Key, OfMethod> renderers_;
};

}  // namespace relievo
