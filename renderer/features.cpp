// See features.h.
#include "renderer/features.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

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

// The device's own choice (DeviceInfo::best_path), in words.
const char* why_best(TracePath path) {
    if (path == TracePath::ray_query) return "the device has it, the fastest way on a GPU";
    return "a tree of boxes for compute shaders: the fastest way on a processor, and on a GPU without ray query";
}

bool any_procedural(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const SceneObject& o) { return o.displacement.procedural.has_value(); });
}

bool needs_pyramid(const Scene& scene, const Method& method) {
    return method.map_bounds == MapBounds::heights ||
           (method.map_bounds == MapBounds::planes && any_procedural(scene));
}

bool needs_slabs(const Scene& scene, const Method& method) {
    return method.map_bounds == MapBounds::planes &&
           std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const SceneObject& o) { return !o.displacement.procedural.has_value(); });
}

bool any_albedo_map(const Scene& scene, const FeatureRequest& request) {
    return request.has_colours || std::any_of(scene.objects.begin(), scene.objects.end(), [](const SceneObject& o) {
               return !o.material.albedo_map.empty();
           });
}

}  // namespace

// In such a sheet each ray alone meets few nodes: measured on 512 x 512 pixels, exact, full samples, alone over together: a plane of 12,800 triangles 0.89 to 0.94 (its frame of
// primary rays 0.90 to 0.96), of 25,000 0.83, of 50,000 0.78 to 0.84, pdm and march likewise, dbvh 0.71. On a sphere, a cube and
// a knot of 50,000 it is 1.03 to 1.08, and 1.12 to 1.17 for primary rays.
bool is_dense_sheet(const Scene& scene, int width, int height) {
    constexpr double kPixelsPerTriangle = 16, kFlat = 0.95;
    std::size_t triangles = 0;
    for (const SceneObject& o : scene.objects) triangles += o.mesh.faces.size();
    if (static_cast<double>(triangles) * kPixelsPerTriangle < double(width) * height) return false;
    glm::dvec3 area(0);
    double whole = 0;
    for (const SceneObject& o : scene.objects) {
        for (const Mesh::Face& f : o.mesh.faces) {
            const glm::dvec3 p0 = o.mesh.positions[f.position[0]], p1 = o.mesh.positions[f.position[1]],
                             p2 = o.mesh.positions[f.position[2]];
            const glm::dvec3 twice = glm::cross(p1 - p0, p2 - p0);
            area += twice;
            whole += glm::length(twice);
        }
    }
    return glm::length(area) >= kFlat * whole;
}

Features derive_features(const Scene& scene, const FeatureRequest& request) {
    const bool all = request.everything;
    Features f;
    f.shadows = all || any_light(scene) || any_sky(scene);
    f.opacity = all || any_opacity(scene);
    f.gloss = all || any_gloss(scene);
    f.sky = all || any_sky(scene);
    f.mended_creases = request.has_creases && request.method->geometry == GeometryKind::parallel_prisms;
    f.slabs = needs_slabs(scene, *request.method);
    f.pyramid = all || needs_pyramid(scene, *request.method);
    f.true_shell = request.method->geometry == GeometryKind::surface_bounds;
    f.hits = request.method->hits;
    f.procedural = all || any_procedural(scene);
    f.albedo_maps = all || any_albedo_map(scene, request);
    f.micro_triangles = request.method->geometry == GeometryKind::triangles;
    f.density = f.micro_triangles ? request.density : 0;
    f.searched = f.true_shell && (all || request.has_searched);
    f.slants = f.true_shell && (all || request.has_slants);
    f.path = request.path;
    f.driver_triangles = f.micro_triangles && f.path != TracePath::bvh;
    f.bundles = f.path == TracePath::bvh && request.can_bundle && !request.dense_sheet;
    return f;
}

namespace {

// One list of decisions, in the order that `explain` prints them.
class Describer {
  public:
    Describer(const Scene& scene, const FeatureRequest& request, const Features& features)
        : scene_(scene), request_(request), features_(features), method_("method " + std::string(request.method->name)) {}

    void add(std::string name, bool built, std::string why) {
        report_.features.push_back({std::move(name), built, std::move(why), 0});
    }

    // `needed`: by the scene or the method; else it is there only because everything was asked for.
    void add_needed(const char* name, bool built, bool needed, const std::string& yes, const std::string& no) {
        add(name, built, needed ? yes : built ? "everything was asked for" : no);
    }

    void geometry() {
        const Features& f = features_;
        add("base mesh prisms", true,
            f.micro_triangles ? "hits are told on the base mesh" : "every triangle is met as one box in one tree");
        add("displacement maps", true, "the surface itself, 16 bits a texel");
        add_needed("procedural heights", f.procedural, any_procedural(scene_),
                   "an object's heights are made of an exemplar: its Gaussianised texels stand in the map's place",
                   "all heights are maps");
        add("height bounds", true, "each triangle's box is as high as its own part of the map (kept on the processor)");
        const MapBounds bounds = request_.method->map_bounds;
        const std::string samples = method_ + " samples heights and needs no bounds of the map";
        add_needed("min-max pyramid", f.pyramid, needs_pyramid(scene_, *request_.method),
                   method_ + (bounds == MapBounds::planes ? " bounds the exemplar by it" : " bounds the map by it"),
                   bounds == MapBounds::planes ? method_ + " bounds the map about planes" : samples);
        add("bounds about planes", f.slabs,
            f.slabs                       ? method_ + " bounds the map by them: where it is smooth they are closer than the "
                                                      "least and the greatest height"
            : bounds == MapBounds::none   ? samples
            : bounds == MapBounds::planes ? "all heights are made of an exemplar"
                                          : method_ + " bounds the map by its least and greatest heights");
        add("surface bounds", f.true_shell,
            f.true_shell && f.hits == HitPlace::on_surface
                ? method_ + " finds nothing beside the surface: boxes are as narrow as that"
            : f.true_shell ? method_ + " meets the surface itself: boxes hold it where it leaves the parallel prism"
            : f.driver_triangles ? method_ + " meets micro-triangles, which the driver's structure holds itself"
            : f.micro_triangles ? method_ + " meets micro-triangles, and boxes hold each of them"
                         : method_ + " meets the surface of the parallel prism, and boxes hold no more");
        add("micro-triangles", f.micro_triangles,
            f.micro_triangles ? "the surface, made of triangles in advance" : method_ + " needs no tessellation");
        add_needed("search of folded shells", f.searched, f.true_shell && request_.has_searched,
                   "the shell of a triangle folds, or stands far from its normal",
                   f.true_shell ? "no triangle's shell folds" : method_ + " does not meet the surface itself");
        add_needed("slanted prisms", f.slants, f.true_shell && request_.has_slants,
                   "most triangles are thin tiles aslant: their prisms end along the surface",
                   f.true_shell ? "prisms along the base triangles are as low as most triangles need"
                                : method_ + " does not meet the surface itself");
        const bool parallel = request_.method->geometry == GeometryKind::parallel_prisms;
        add("mended creases", f.mended_creases,
            !parallel               ? method_ + " does not offset triangles in parallel"
            : request_.has_creases ? "edges are folded below 5 degrees"
                                   : "no edge is folded below 5 degrees");
        add("several objects", scene_.objects.size() > 1,
            scene_.objects.size() > 1 ? "textures are indexed by object" : "one object: textures are not indexed");
    }

    void shading() {
        const Features& f = features_;
        add_needed("shadows", f.shadows, any_light(scene_) || any_sky(scene_), "the scene has light",
                   "the scene has no light");
        add_needed("sky light", f.sky, any_sky(scene_), "the environment shines", "the environment is dark");
        add_needed("gloss", f.gloss, any_gloss(scene_), "a material has specular > 0", "no material has specular > 0");
        add_needed("opacity maps", f.opacity, any_opacity(scene_), "an object has an opacity map",
                   "no object has an opacity map");
        add_needed("albedo maps", f.albedo_maps, any_albedo_map(scene_, request_), "a material's albedo is a map",
                   "no material's albedo is a map");
        add("bounces and refraction", false, "this version traces camera and shadow rays");
    }

    // Switches of the method that the shader reads as it runs.
    void switches(const std::map<std::string, double>& parameters) {
        const auto add_switch = [&](const char* name, const char* parameter, const char* on, const char* off) {
            const auto found = parameters.find(parameter);
            const bool has = found != parameters.end(), built = has && found->second > 0.5;
            add(name, built, !has ? method_ + " has none" : std::string(parameter) + (built ? " is on: " : " is off: ") +
                                                                (built ? on : off));
        };
        add_switch("thin-feature jitter", "jitter", "the first sample is shifted at random",
                   "what is thinner than a step can be missed for good");
        add_switch("normal correction", "correct_normals", "shading takes the interpolated normal",
                   "shading takes the base triangle's normal");
    }

    void passes() {
        const Features& f = features_;
        report_.path = f.path;
        const std::string used(trace_path_words(f.path));
        for (const TracePath path : {TracePath::ray_query, TracePath::pipeline, TracePath::bvh})
            add(std::string(trace_path_words(path)), f.path == path,
                f.path != path             ? "the " + used + " does its work"
                : request_.path_asked_for ? "asked for by --path"
                                           : why_best(path));
        add("bundles of rays", f.bundles,
            f.bundles                    ? "eight rays walk the tree together, as the driver runs them"
            : f.path != TracePath::bvh ? "the " + used + " traces each ray for itself"
            : request_.can_bundle      ? "the mesh is a flat sheet of small triangles: each ray alone meets few boxes of it"
                                       : "this device runs each ray for itself");
        add("image", true, "sum of samples, their number, and the tone-mapped picture");
        add("layers", false, "depth, normals, uv and id are traced only when asked for");
        add("picking", false, "compiled at the first pick");
        add("counters", false, "what rays cost is counted only when asked for");
        add("ray log", false, "compiled when the first ray is asked about");
        add("upload staging", false, "made at the first edit, as large as the edit");
    }

    FeatureReport take() { return std::move(report_); }

  private:
    const Scene& scene_;
    const FeatureRequest& request_;
    const Features& features_;
    std::string method_;
    FeatureReport report_;
};

}  // namespace

FeatureReport describe_features(const Scene& scene, const FeatureRequest& request, const Features& features,
                                const std::map<std::string, double>& parameters) {
    Describer list(scene, request, features);
    list.geometry();
    list.shading();
    list.switches(parameters);
    list.passes();
    return list.take();
}

}  // namespace relievo
