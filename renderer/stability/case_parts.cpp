// See case_parts.h.
#include "renderer/stability/case_parts.h"

#include <glm/mat4x4.hpp>
#include <utility>

namespace relievo::stability {

using glm::dvec3;

std::vector<NamedView> plane_views() {
    return {{"from above", {0.5, 0.1, 1.6}, {0.5, 0.5, 0}},
            {"grazing", {-0.4, -0.3, 0.16}, {0.6, 0.6, 0}},
            {"along the ground", {0.5, 0.5, 0.12}, {0.9, 0.8, 0.08}},
            {"from below", {0.4, 0.2, -1.3}, {0.5, 0.5, 0}}};
}

std::vector<NamedView> ball_views() {
    return {{"from outside", {2.0, 1.4, 1.1}, {0, 0, 0}},
            {"grazing", {1.25, 0.5, 0.0}, {0.0, 1.0, 0.1}},
            {"from inside", {0.1, 0.2, 0.0}, {1, 0.3, 0.2}},
            {"from far", {9, 20, 7}, {0, 0, 0}}};
}

std::vector<NamedView> triangle_views() {
    return {{"from above", {0.3, 0.1, 2.0}, {0.33, 0.33, 0}},
            {"grazing", {-0.6, -0.5, 0.4}, {0.4, 0.4, 0}},
            {"from below", {0.3, 0.2, -1.6}, {0.33, 0.33, 0}}};
}

Case on_mesh(const Mesh& mesh, std::vector<NamedView> views, double amplitude, double midlevel,
             const MapShape& map) {
    SampleSurface surface;
    surface.mesh = mesh;
    surface.amplitude = amplitude;
    surface.midlevel = midlevel;
    surface.wrap = map.wrap;
    surface.paint(map.width, map.height, map.value);
    Case c;
    c.objects.push_back(std::move(surface));
    c.views = std::move(views);
    return c;
}

Case on_plane(double amplitude, double midlevel, const MapShape& map) {
    return on_mesh(plane_mesh(), plane_views(), amplitude, midlevel, map);
}

Case on_ball(double amplitude, double midlevel, const MapShape& map) {
    return on_mesh(ball_mesh(32, 16), ball_views(), amplitude, midlevel, map);
}

Case on_lump(double amplitude, double midlevel, const MapShape& map) {
    return on_mesh(lump_mesh(), ball_views(), amplitude, midlevel, map);
}

Case smooth(Case c) {
    c.sampled = Sampled::within_limits;
    return c;
}

Case irregular(Case c) {
    c.sampled = Sampled::known_flaw;
    return c;
}

Case scaled(Case c, double scale) {
    for (SampleSurface& surface : c.objects) {
        for (glm::vec3& p : surface.mesh.positions) p = glm::vec3(dvec3(p) * scale);
        measure_bounds(surface.mesh);
        surface.amplitude *= scale;
    }
    for (NamedView& v : c.views) v.eye *= scale, v.look_at *= scale;
    for (RaySet& set : c.rays)
        for (Ray& ray : set.rays) ray.origin = glm::vec3(dvec3(ray.origin) * scale);
    c.sampled = Sampled::no_promise;
    return c;
}

Case moved(Case c, const dvec3& origin) {
    for (SampleSurface& surface : c.objects) {
        MeshFile file;  // as it would be read: in the world, in double
        for (const glm::vec3& p : surface.mesh.positions) file.positions.push_back(dvec3(p) + origin);
        for (const glm::vec3& n : surface.mesh.normals) file.file_normals.emplace_back(n);
        for (const glm::vec2& uv : surface.mesh.uvs) file.uvs.emplace_back(uv);
        file.faces = surface.mesh.faces;
        surface.mesh = make_mesh(file, glm::dmat4(1), origin, true);
    }
    c.origin = origin;
    c.sampled = Sampled::no_promise;
    return c;
}

MapShape dunes_map(int width, int height) {
    return {width, height, [=](int x, int y) { return dunes((x + 0.5) / width, (y + 0.5) / height); }};
}

MapShape ball_dunes_map(int width, int height) {
    return {width, height, [=](int x, int y) { return ball_dunes((x + 0.5) / width, (y + 0.5) / height); }};
}

MapShape flat_map(double value, int width, int height) {
    return {width, height, [=](int, int) { return value; }};
}

MapShape noise_map(int width, int height) {
    return {width, height, [](int x, int y) { return hash01(unsigned(x), unsigned(y), 6); }};
}

MapShape cliff_map(int width, int height) {
    return {width, height,
            [](int x, int y) { return hash01(unsigned(x), unsigned(y), 5) < 0.5 ? 0.0 : 1.0; }};
}

MapShape spike_map(int width, int height) {
    return {width, height, [](int x, int y) { return x % 8 == 3 && y % 8 == 5 ? 1.0 : 0.2; }};
}

MapShape ridge_map(int width, int height) {
    return {width, height, [](int x, int y) { return x % 7 == 3 || y % 11 == 5 ? 0.9 : 0.1; }};
}

}  // namespace relievo::stability
