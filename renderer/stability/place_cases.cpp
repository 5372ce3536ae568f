// Cases of the whole scene: tiny, huge, far away; several objects; holes.
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/stability/case_parts.h"
#include "renderer/stability/extreme_meshes.h"

namespace relievo::stability {
namespace {

SampleSurface shifted(SampleSurface surface, const glm::vec3& by) {
    for (glm::vec3& p : surface.mesh.positions) p += by;
    measure_bounds(surface.mesh);
    return surface;
}

Case three_objects() {
    Case c = on_plane(0.1, 0.5, dunes_map(64, 64));
    c.objects.push_back(shifted(on_ball(0.1, 0.2, ball_dunes_map(128, 64)).objects[0], {0.5f, 0.5f, 1.3f}));
    c.objects.push_back(shifted(on_lump(-0.2, 0.5, cliff_map(16, 16)).objects[0], {2.5f, 1.5f, 0}));
    c.views = {{"from outside", {-1.5, -2, 2.5}, {0.8, 0.8, 0.5}}, {"grazing", {-1, -1, 0.3}, {1, 1, 0.4}}};
    return c;
}

// Amplitude 0 among others, so far away that the flat triangles' prisms are thinner than the rays' rounding.
Case flat_among_others() {
    Case c = on_plane(0.1, 0.5, dunes_map(64, 64));
    c.objects.push_back(shifted(on_ball(0, 0.5, ball_dunes_map(128, 64)).objects[0], {2.5f, 0.5f, 0}));
    c.objects.push_back(shifted(on_ball(0.1, 0.5, ball_dunes_map(128, 64)).objects[0], {0.5f, 2.5f, 0}));
    c.views = {{"from outside", {-3, -2, 5}, {1.2, 1.2, 0}}, {"from afar", {-9, -7, 12}, {1.2, 1.2, 0}}};
    return c;
}

}  // namespace

std::vector<CaseEntry> place_cases() {
    std::vector<CaseEntry> list;
    const auto add = [&](const std::string& name, const std::string& what, std::function<Case()> make) {
        list.push_back({"places", name, what, std::move(make)});
    };
    const auto ball = [] { return on_ball(0.2, 0.5, ball_dunes_map(256, 128)); };
    const auto lump = [] { return on_lump(0.1, 0.5, ball_dunes_map(128, 128)); };
    add("tiny_scene", "a ball 1e-4 times as large", [=] { return scaled(ball(), 1e-4); });
    add("tiny_lump", "a lump 1e-4 times as large", [=] { return scaled(lump(), 1e-4); });
    add("huge_ball", "a ball 1e4 times as large", [=] { return scaled(ball(), 1e4); });
    add("large_scene", "a lump 1e4 times as large", [=] { return scaled(lump(), 1e4); });
    add("tiny_cliffs", "cliffs 1e-4 times as large",
        [] { return scaled(on_plane(0.05, 0.5, cliff_map(32, 32)), 1e-4); });
    add("huge_cliffs", "cliffs 1e4 times as large",
        [] { return scaled(on_plane(0.05, 0.5, cliff_map(32, 32)), 1e4); });
    add("huge_and_flat", "amplitude 1e-6 of a scene 1e4 times as large",
        [] { return scaled(on_ball(1e-6, 0.5, ball_dunes_map(64, 32)), 1e4); });
    add("far_away", "a ball 1e5 away", [=] { return moved(ball(), {1e5, -1e5, 1e5}); });
    add("lump_far_away", "a lump 1e5 away", [=] { return moved(lump(), {-1e5, 1e5, 1e5}); });
    add("tiny_far_away", "a ball 1e-2 times as large, 1e5 away", [=] {
        return moved(scaled(ball(), 1e-2), {1e5, 1e5, -1e5});
    });
    add("mirrored_transform", "a ball mirrored, squeezed to an egg and turned by its transform", [] {
        glm::dmat4 m = glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(0.3, 1, 0.2));
        m = glm::scale(m, glm::dvec3(-1, 0.4, 1.2));
        return on_mesh(transformed(ball_mesh(32, 16), m), ball_views(), 0.1, 0.5, ball_dunes_map(128, 64));
    });
    add("several_objects", "a plane, a ball and a lump with maps and amplitudes of their own", three_objects);
    add("flat_among_others", "amplitude 0 on one of three objects, seen from afar",
        [] { return smooth(flat_among_others()); });
    return list;
}

}  // namespace relievo::stability
