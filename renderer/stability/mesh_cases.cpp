// Cases of the base mesh: slivers, faces without area, folds, creases, borders, normals that lean.
#include <cmath>

#include "renderer/stability/case_parts.h"
#include "renderer/stability/extreme_meshes.h"

namespace relievo::stability {
namespace {

using glm::dvec3;

// Two slivers of the given width, turned out of the axes.
Case slivers(double width) {
    Mesh mesh = plane_mesh();
    for (glm::vec3& p : mesh.positions) p = {p.x, p.y * width + 0.3f * p.x, 0};
    measure_bounds(mesh);
    return on_mesh(mesh,
                   {{"from above", {0.5, 0.15, 0.5 * std::sqrt(width)}, {0.5, 0.151, 0}},
                    {"grazing", {0.2, -0.1, 0.08}, {0.6, 0.185, 0}}},
                   0.02, 0.5, dunes_map(64, 64));
}

Case one_triangle(double amplitude, const dvec3& na, const dvec3& nb, const dvec3& nc) {
    return on_mesh(triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, na, nb, nc), triangle_views(), amplitude,
                   0.5, dunes_map(64, 64));
}

// Normals that lean apart by `spread`.
Case spread_triangle(double amplitude, double spread) {
    return one_triangle(amplitude, {spread, spread, 1}, {-spread, 0.5 * spread, 1},
                        {0.3 * spread, -spread, 1});
}

void add_shapes(std::vector<CaseEntry>& list) {
    const auto add = [&](const char* name, const char* what, std::function<Case()> make) {
        list.push_back({"meshes", name, what, std::move(make)});
    };
    add("slivers", "two triangles of aspect 1e2", [] { return slivers(1e-2); });
    add("thin_slivers", "two triangles of aspect 1e4", [] { return slivers(1e-4); });
    add("ribbon_of_slivers", "twelve triangles of aspect 1e4 side by side", [] {
        return on_mesh(ribbon_mesh(6, 1e-4),
                       {{"from above", {0.5, 0.12, 0.07}, {0.5, 0.1503, 0.05}},
                        {"close", {0.4998, 0.1495, 0.052}, {0.4999, 0.1503, 0.05}},
                        {"grazing", {0.2, -0.1, 0.12}, {0.6, 0.185, 0.06}}},
                       0.002, 0.5, dunes_map(64, 64));
    });
    add("fan_of_needles", "needles of aspect 1e4 with a corner in common, whose normals lean, under noise", [] {
        return on_mesh(
            needle_fan_mesh(12, 1e-4),
            {{"from above", {0.62, -0.1, 0.3}, {0.6, 0, 0}}, {"close", {0.8, -0.09, 0.13}, {0.6, 0, 0}}}, 0.2,
            0.5, noise_map(53, 37));
    });
    add("zero_area_faces", "faces with two corners at one place, or three on a line, among the others", [] {
        return on_mesh(with_zero_area_faces(ball_mesh(16, 8)), ball_views(), 0.2, 0.5,
                       ball_dunes_map(64, 32));
    });
    add("duplicate_vertices", "a ball whose faces share no vertex",
        [] { return on_mesh(unwelded(ball_mesh(32, 16)), ball_views(), 0.2, 0.5, ball_dunes_map(128, 64)); });
    add("open_borders", "a ball that lacks every third face", [] {
        return on_mesh(with_holes(ball_mesh(24, 12)), ball_views(), 0.2, 0.5, ball_dunes_map(96, 48));
    });
    add("open_borders_on_lump", "a lump that lacks every third face",
        [] { return on_mesh(with_holes(lump_mesh()), ball_views(), 0.2, 0.5, dunes_map(64, 64)); });
    add("non_manifold_edge", "seven sheets that share one edge", [] {
        return on_mesh(
            book_mesh(7),
            {{"from outside", {1.6, 1.3, 0.9}, {0, 0, 0}}, {"along the edge", {0.1, 0.05, 2}, {0.1, 0.1, 0}}},
            0.1, 0.5, dunes_map(64, 64));
    });
    const std::vector<NamedView> edge_views = {{"from the front", {1.2, 0.2, 0.4}, {-0.3, 0.5, 0}},
                                               {"from above", {-0.4, 0.3, 1.2}, {-0.4, 0.5, 0}},
                                               {"along the edge", {0.05, -1, 0.05}, {-0.2, 0.5, 0}}};
    add("crease_4_degrees", "two triangles folded to 4 degrees",
        [=] { return on_mesh(wedge_mesh(4), edge_views, 0.1, 0.5, dunes_map(64, 64)); });
    add("crease_half_degree", "two triangles folded to half a degree",
        [=] { return on_mesh(wedge_mesh(0.5), edge_views, 0.1, 0.5, dunes_map(64, 64)); });
    add("fold_of_0_degrees", "two triangles on each other", [=] {
        Case c = on_mesh(wedge_mesh(0), edge_views, 0.1, 0.5, dunes_map(64, 64));
        c.beyond_float = "the edge's normals lie in the plane of both triangles, and S covers itself there";
        c.size = 32;
        return c;
    });
    add("blade_2_degrees", "a closed blade with an edge of 2 degrees",
        [=] { return on_mesh(blade_mesh(2, 3), edge_views, 0.05, 0.5, dunes_map(64, 64)); });
    add("blade_high", "a closed blade with an edge of 4 degrees, raised high",
        [=] { return on_mesh(blade_mesh(4, 2), edge_views, 0.3, 0.0, dunes_map(64, 64)); });
}

void add_normals(std::vector<CaseEntry>& list) {
    const auto add = [&](const char* name, const char* what, std::function<Case()> make) {
        list.push_back({"normals", name, what, std::move(make)});
    };
    add("leaning_normals", "normals that lean by 45 degrees", [] { return spread_triangle(0.2, 0.7); });
    add("steep_normals", "normals that lean by 72 degrees", [] { return spread_triangle(0.3, 3); });
    add("normal_at_85_degrees", "one normal almost along the triangle", [] {
        return one_triangle(0.2, {0.1, 0.1, 1}, {1, 0.3, 0.09}, {-0.1, 0.2, 1});
    });
    add("normal_at_right_angle", "one normal with N.Ng = 0", [] {
        return one_triangle(0.2, {0, 0, 1}, {1, 0.2, 0}, {0, 0, 1});
    });
    add("normals_near_right_angle", "all normals with N.Ng = 1e-3", [] {
        return one_triangle(0.2, {1, 0.2, 1e-3}, {1, -0.3, 1e-3}, {0.8, 0.1, 1e-3});
    });
    add("normal_backwards", "one normal with N.Ng = -0.5", [] {
        return one_triangle(0.15, {0, 0, 1}, {0.87, 0.2, -0.5}, {0, 0.2, 1});
    });
    add("normals_backwards", "all normals with N.Ng = -1: the file's against its own faces", [] {
        return on_mesh(turned_inside_out(ball_mesh(24, 12)), ball_views(), 0.2, 0.5, ball_dunes_map(96, 48));
    });
    add("opposite_normals", "normals that cancel inside the triangle", [] {
        return one_triangle(0.15, {1, 0, 0.1}, {-1, 0, 0.1}, {0, -1, 0.1});
    });
    add("leaning_on_ball", "every fifth normal leans by up to 60 degrees, on a ball", [] {
        return on_mesh(with_leaning_normals(ball_mesh(16, 8)), ball_views(), 0.1, 0.5,
                       ball_dunes_map(64, 32));
    });
    add("normals_nearly_cancel", "one corner's normal is turned round: N runs by 0, within the triangle, and S swings", [] {
        Case c = one_triangle(0.6, {0.02, 0.02, -1}, {0, 0, 1}, {0.2, 0, 0.98});
        c.objects[0].paint(24, 24, noise_map(24, 24).value);
        return c;
    });
    add("folded_shell", "one triangle whose shell folds: several surface points over one base point",
        [] { return spread_triangle(1.6, 0.9); });
    add("folded_shell_flat", "the same under a flat map", [] {
        Case c = spread_triangle(1.6, 0.9);
        c.objects[0].paint(1, 1, [](int, int) { return 1.0; });
        return c;
    });
    add("folded_shell_cliffs", "the same with texel cliffs", [] {
        Case c = spread_triangle(1.6, 0.9);
        c.objects[0].paint(16, 16, cliff_map(16, 16).value);
        return c;
    });
    add("folded_shell_rows_of_cliffs", "the same, lower, with rows of cliffs that cross the triangle aslant", [] {
        Case c = spread_triangle(0.9, 0.9);
        c.objects[0].mesh.uvs = {{0, 0}, {0.4f, 2}, {-0.3f, 1.5f}};
        c.objects[0].paint(1, 32, cliff_map(1, 32).value);
        return c;
    });
}

}  // namespace

std::vector<CaseEntry> mesh_cases() {
    std::vector<CaseEntry> list;
    add_shapes(list);
    add_normals(list);
    return list;
}

}  // namespace relievo::stability
