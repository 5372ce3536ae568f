// See features.h.
#include "renderer/features.h"

#include <algorithm>
#include <string>

namespace relievo {
namespace {

bool any_light(const Scene& scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.intensity > 0; });
}

bool any_sky(const Scene& scene) { return scene.environment.intensity > 0; }

bool any_opacity(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const SceneObject& o) { return !o.opacity_map.empty(); });
}

bool any_gloss(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const SceneObject& o) { return o.material.specular > 0; });
}

}  // namespace

Features derive_features(const Scene& scene, const FeatureRequest& request) {
    const bool all = request.everything;
    Features f;
    f.shadows = all || any_light(scene) || any_sky(scene);
    f.opacity = all || any_opacity(scene);
    f.gloss = all || any_gloss(scene);
    f.sky = all || any_sky(scene);
    f.mended_creases = request.has_creases && request.method->geometry == GeometryKind::parallel_prisms;
    f.pyramid = request.method->needs_pyramid;
    f.true_shell = request.method->geometry == GeometryKind::surface_bounds;
    f.by_pipeline = request.by_pipeline;
    return f;
}

FeatureReport describe_features(const Scene& scene, const FeatureRequest& request, const Features& f) {
    const std::string method(request.method->name);
    const auto reason = [&](bool needed, const char* yes, const char* no) {
        return std::string(needed ? yes : request.everything ? "everything was asked for" : no);
    };
    FeatureReport report;
    const auto add = [&](const char* name, bool built, std::string why) {
        report.features.push_back({name, built, std::move(why), 0});
    };
    add("base mesh prisms", true, "every triangle is met as one box in one acceleration structure");
    add("displacement maps", true, "the surface itself, 16 bits a texel");
    add("height bounds", true, "each triangle's box is as high as its own part of the map (kept on the processor)");
    add("min-max pyramid", f.pyramid,
        "method " + method + (f.pyramid ? " bounds the map by it" : " samples heights and needs no bounds of the map"));
    add("shadows", f.shadows, reason(any_light(scene) || any_sky(scene), "the scene has light", "the scene has no light"));
    add("sky light", f.sky, reason(any_sky(scene), "the environment shines", "the environment is dark"));
    add("gloss", f.gloss, reason(any_gloss(scene), "a material has specular > 0", "no material has specular > 0"));
    add("opacity maps", f.opacity,
        reason(any_opacity(scene), "an object has an opacity map", "no object has an opacity map"));
    add("several objects", scene.objects.size() > 1,
        scene.objects.size() > 1 ? "textures are indexed by object" : "one object: textures are not indexed");
    add("mended creases", f.mended_creases,
        request.method->geometry != GeometryKind::parallel_prisms
            ? "method " + method + " does not offset triangles in parallel"
            : (request.has_creases ? "edges are folded below 5 degrees" : "no edge is folded below 5 degrees"));
    add("ray query", !f.by_pipeline,
        f.by_pipeline ? "the ray tracing pipeline is used" : "compute shaders trace");
    add("ray tracing pipeline", f.by_pipeline,
        f.by_pipeline ? "asked for, or the device has no ray query" : "the ray query does its work");
    add("image", true, "sum of samples, their number, and the tone-mapped picture");
    add("layers", false, "depth, normals, uv and id are traced only when asked for");
    add("picking", false, "compiled at the first pick");
    add("counters", false, "what rays cost is counted only when asked for");
    add("ray log", false, "compiled when the first ray is asked about");
    add("bounces and refraction", false, "this version traces camera and shadow rays");
    return report;
}

}  // namespace relievo
