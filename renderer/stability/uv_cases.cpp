// Cases of texture coordinates: mirrored, degenerate, overlapping, out of range; repeat and clamp.
#include "renderer/stability/case_parts.h"
#include "renderer/stability/extreme_meshes.h"

namespace relievo::stability {
namespace {

Mesh plane_with_uvs(const std::vector<glm::vec2>& uvs) {
    Mesh mesh = plane_mesh();
    mesh.uvs = uvs;
    return mesh;
}

Case on_uvs(const std::vector<glm::vec2>& uvs, Wrap wrap, double amplitude = 0.1) {
    MapShape map = dunes_map(32, 32);
    map.wrap = wrap;
    return on_mesh(plane_with_uvs(uvs), plane_views(), amplitude, 0.5, map);
}

}  // namespace

std::vector<CaseEntry> uv_cases() {
    std::vector<CaseEntry> list;
    const auto add = [&](const std::string& name, const std::string& what, std::function<Case()> make) {
        list.push_back({"texture coordinates", name, what, std::move(make)});
    };
    add("uv_mirrored", "a mirrored plane", [] {
        return on_uvs({{1, 0}, {0, 0}, {0, 1}, {1, 1}}, Wrap::repeat);
    });
    add("uv_mirrored_half", "one triangle is the mirror image of the other", [] {
        return on_uvs({{0, 0}, {1, 0}, {1, 1}, {1, 0}}, Wrap::repeat);
    });
    add("uv_on_a_line", "all texture coordinates on one line", [] {
        return on_uvs({{0.1f, 0.2f}, {0.7f, 0.8f}, {0.4f, 0.5f}, {0.2f, 0.3f}}, Wrap::repeat);
    });
    add("uv_at_a_point", "all texture coordinates at one point", [] {
        return on_uvs({{0.3f, 0.2f}, {0.3f, 0.2f}, {0.3f, 0.2f}, {0.3f, 0.2f}}, Wrap::clamp);
    });
    add("uv_overlapping", "every face of a ball has the same part of the map: torn edges", [] {
        return on_mesh(with_overlapping_uvs(ball_mesh(8, 5)), ball_views(), 0.15, 0.5, dunes_map(32, 32));
    });
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const std::string how = wrap == Wrap::repeat ? "repeat" : "clamp";
        add("uv_out_of_range_" + how, "three periods, " + how, [=] {
            return on_uvs({{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}, wrap, 0.05);
        });
        add("uv_slanted_" + how, "skewed over several periods, " + how, [=] {
            return on_uvs({{-1.4f, 0.9f}, {0.2f, -2.1f}, {1.9f, 3.7f}, {-0.6f, 2.2f}}, wrap, 0.05);
        });
        add("uv_far_" + how, "a thousand periods away, " + how, [=] {
            return on_uvs({{1000, -1000}, {1001, -1000}, {1001, -999}, {1000, -999}}, wrap);
        });
        add("uv_wild_" + how, "ten thousand periods on one triangle, " + how, [=] {
            Case c = on_uvs({{-70.5f, 3}, {1e4f, 0.25f}, {0.5f, -900}, {0.5f, 0.5f}}, wrap);
            c.size = 32;
            c.views.resize(2);
            c.beyond_float = "a triangle spans 3e5 texels: float tells their places to 1/32 of a texel";
            return c;
        });
    }
    const auto folds_beyond_clamp = [](const glm::vec2& scale, MapShape map) {
        Mesh mesh = lump_mesh();
        for (glm::vec2& uv : mesh.uvs) uv = uv * scale - 7.0f;
        map.wrap = Wrap::clamp;
        return on_mesh(mesh, {{"from outside", {1.8, -0.6, 0.9}, {0, 0, 0}}}, 0.6, 0.5, map);
    };
    add("uv_beyond_clamp_on_folds", "forty widths of a clamped map across a lump whose shell folds", [=] {
        return folds_beyond_clamp({40, -25}, noise_map(53, 37));
    });
    add("uv_beyond_clamp_on_rough_folds", "the same, thousands of texels under each triangle", [=] {
        Case c = folds_beyond_clamp({45, 36}, noise_map(512, 512));
        c.size = 32;
        return c;
    });
    return list;
}

}  // namespace relievo::stability
