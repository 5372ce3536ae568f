// Cases of procedural heights: extreme tiling, and exemplars that are hardly any.
#include "renderer/stability/case_parts.h"

namespace relievo::stability {
namespace {

Case procedural(Case c, double scale, double triangle_size) {
    for (SampleSurface& surface : c.objects) {
        surface.procedural = Procedural{};
        surface.procedural->scale = scale;
        surface.procedural->triangle_size = triangle_size;
        surface.procedural->seed = 3;
        surface.procedural->offset = {0.3, -7.6};
    }
    c.sampled = Sampled::no_promise;
    return c;
}

// Texture coordinates as they are, and one corner far away.
Case wild(Case c) {
    for (SampleSurface& surface : c.objects) surface.mesh.uvs[0] += glm::vec2(40, -25);
    return c;
}

}  // namespace

std::vector<CaseEntry> procedural_cases() {
    std::vector<CaseEntry> list;
    const auto add = [&](const char* name, const char* what, std::function<Case()> make) {
        list.push_back({"procedural heights", name, what, std::move(make)});
    };
    add("procedural", "hills tiled and blended on a plane",
        [] { return smooth(procedural(on_plane(0.1, 0.5, dunes_map(64, 64)), 2, 0.25)); });
    add("procedural_ball", "the same on a ball, torn at its texture seam",
        [] { return procedural(on_ball(0.15, 0.5, dunes_map(64, 48)), 3, 0.3); });
    add("procedural_lump", "the same on 30 irregular triangles",
        [] { return procedural(on_lump(0.1, 0.5, dunes_map(48, 48)), 2, 0.25); });
    add("procedural_small_triangles", "many triangles in a texel",
        [] { return procedural(on_plane(0.05, 0.5, dunes_map(32, 32)), 2, Procedural::kLeastTriangle); });
    add("procedural_large_triangle", "one triangle over all",
        [] { return procedural(on_plane(0.1, 0.5, dunes_map(64, 64)), 2, Procedural::kMostTriangle); });
    add("procedural_least_scale", "less than a texel over all",
        [] { return procedural(on_plane(0.1, 0.5, noise_map(32, 32)), Procedural::kLeastScale, 0.25); });
    add("procedural_large_scale", "texels far smaller than pixels",
        [] { return procedural(on_plane(0.002, 0.5, dunes_map(32, 32)), 100, 0.25); });
    add("procedural_cliffs", "0 and 65535 side by side at random",
        [] { return procedural(on_plane(0.05, 0.5, cliff_map(32, 32)), 2, 0.25); });
    add("procedural_noise", "every texel another height",
        [] { return procedural(on_ball(0.05, 0.5, noise_map(24, 40)), 2, 0.4); });
    add("procedural_one_texel", "an exemplar of one texel",
        [] { return procedural(on_plane(0.1, 0.2, flat_map(0.7, 1, 1)), 3, 0.25); });
    add("procedural_constant", "an exemplar of one value",
        [] { return procedural(on_ball(0.1, 0.2, flat_map(0.7, 8, 8)), 3, 0.25); });
    add("procedural_wild", "slanted over dozens of periods",
        [] { return wild(procedural(on_plane(0.01, 0.5, dunes_map(32, 32)), 1, 0.25)); });
    return list;
}

}  // namespace relievo::stability
