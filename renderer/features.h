// The only place that decides what a scene needs (DESIGN.md section 7): derived from scene, method and settings.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "renderer/methods/registry.h"
#include "renderer/scene/scene.h"
#include "renderer/trace_path.h"

namespace relievo {

struct Feature {
    std::string name;  // "shadows", "min-max pyramid", "opacity maps", ...
    bool built = false;
    std::string reason;       // one clause: why it is built or left out
    std::uint64_t bytes = 0;  // device memory it takes; 0 for shader code, or while nobody has asked for it yet
};

struct FeatureReport {
    std::vector<Feature> features;
    std::uint64_t bytes_total = 0;
    TracePath path = TracePath::bvh;
};

// What is built. Every consumer (specialisation constants, buffers, passes) reads these and nothing else.
struct Features {
    bool shadows = false;        // rays from the hit to each light
    bool opacity = false;        // opacity maps: a lookup inside the intersection
    bool gloss = false;          // the GGX lobe and the mirrored sky
    bool sky = false;            // light of the sky
    bool mended_creases = false; // triangles inserted along folded edges (paper 002, section 5.4)
    bool pyramid = false;        // min-max pyramid on the device: of all maps, or beside slabs of exemplars alone
    bool slabs = false;          // bounds of maps about planes on the device
    bool true_shell = false;     // boxes and clipping hold S itself, not only the parallel prism's surface
    HitPlace hits = HitPlace::in_box;  // the method's
    bool procedural = false;     // heights made of an exemplar
    bool albedo_maps = false;    // a material's albedo is a map
    bool micro_triangles = false; // S made of triangles in advance
    bool driver_triangles = false; // rays meet them by the driver's own test, else by the method's
    double density = 0;          // of them, segments a texel
    bool searched = false;       // search of triangles whose shell folds
    bool slants = false;         // prisms with ends along the surface
    TracePath path = TracePath::ray_query;  // never automatic
    bool bundles = false;        // rays walk our own BVH eight by eight (shaders/trace/bundle.glsl), else each alone
    bool operator==(const Features&) const = default;
};

struct FeatureRequest {
    const Method* method = nullptr;
    bool everything = false;   // build all, whether needed or not
    bool has_creases = false;  // a mesh has edges folded below the threshold
    TracePath path = TracePath::ray_query;  // resolved
    bool path_asked_for = false;            // not the device's own choice
    double density = 0;                     // the method's parameter of that name, 0 where it has none
    bool has_searched = false;              // a triangle is flagged kPrimitiveSearched
    bool has_slants = false;                // most triangles are flagged kPrimitiveSlanted
    bool can_bundle = false;                // the device walks in bundles (DeviceInfo::bundles)
    bool dense_sheet = false;               // is_dense_sheet() for the image as the renderer was made
    bool has_colours = false;               // an albedo map was given, whether the scene names a file or not
};

// Whether the scene is a flat mesh of triangles so small that in an image of this size (pixels) a bundle's rays meet several of
// them. Looks at every triangle.
bool is_dense_sheet(const Scene& scene, int width, int height);

Features derive_features(const Scene& scene, const FeatureRequest& request);

// The same decisions in words, in a fixed order. `parameters`: the method's, all of them. Bytes, and what is built only
// once it is asked for, are filled in by the renderer.
FeatureReport describe_features(const Scene& scene, const FeatureRequest& request, const Features& features,
                                const std::map<std::string, double>& parameters);

}  // namespace relievo
