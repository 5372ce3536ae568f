// Small scenes made in memory, for tests of the renderer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "renderer/renderer.h"

namespace relievo::test {

struct TestMap {
    int width = 0, height = 0;
    std::vector<std::uint16_t> texels;
    HeightView view() const { return {width, height, texels.data()}; }
};

// The texel that a place of one axis, which may lie beyond the map, reads.
inline int wrapped(int i, int size, Wrap wrap) {
    return wrap == Wrap::clamp ? std::clamp(i, 0, size - 1) : (i % size + size) % size;
}

// value(u, v) in [0, 1], sampled at texel centres.
inline TestMap make_map(int width, int height, const std::function<double(double, double)>& value) {
    TestMap map{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double h = value((x + 0.5) / width, (y + 0.5) / height);
            map.texels.push_back(static_cast<std::uint16_t>(std::lround(std::fmin(1, std::fmax(0, h)) * 65535)));
        }
    return map;
}

inline TestMap bumps(int size) {
    return make_map(size, size, [](double u, double v) {
        return 0.5 + 0.2 * std::sin(u * 25) * std::cos(v * 19) + 0.1 * std::sin(u * 61 + v * 47);
    });
}

// The unit square in the xz plane around 0, facing up (+y), uv over the whole map.
inline MeshFile plane_mesh() {
    MeshFile m;
    m.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    m.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    m.faces = {{{0, 1, 2}, {0, 1, 2}}, {{0, 2, 3}, {0, 2, 3}}};
    return m;
}

// A unit sphere of 2 * around * (rings - 1) triangles, poles on the y axis, smooth normals, one texture seam.
inline MeshFile ball_mesh(int around = 32, int rings = 16) {
    MeshFile m;
    const double pi = std::acos(-1.0);
    m.positions.push_back({0, 1, 0});
    for (int r = 1; r < rings; ++r)
        for (int a = 0; a < around; ++a) {
            const double theta = pi * r / rings, phi = 2 * pi * a / around;
            m.positions.push_back({std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)});
        }
    m.positions.push_back({0, -1, 0});
    m.file_normals = m.positions;
    for (int r = 0; r <= rings; ++r)
        for (int a = 0; a <= around; ++a) m.uvs.push_back({double(a) / around, 1 - double(r) / rings});
    const auto vertex = [&](int r, int a) {
        if (r == 0) return 0u;
        if (r == rings) return static_cast<std::uint32_t>(m.positions.size() - 1);
        return static_cast<std::uint32_t>(1 + (r - 1) * around + a % around);
    };
    const auto uv = [&](int r, int a) { return static_cast<std::uint32_t>(r * (around + 1) + a); };
    for (int r = 0; r < rings; ++r)
        for (int a = 0; a < around; ++a) {
            if (r > 0) m.faces.push_back({{vertex(r, a), vertex(r + 1, a), vertex(r, a + 1)},
                                          {uv(r, a), uv(r + 1, a), uv(r, a + 1)}});
            if (r < rings - 1) m.faces.push_back({{vertex(r, a + 1), vertex(r + 1, a), vertex(r + 1, a + 1)},
                                                  {uv(r, a + 1), uv(r + 1, a), uv(r + 1, a + 1)}});
        }
    return m;
}

inline Scene make_scene(const MeshFile& file, double amplitude, double midlevel = 0.5, Wrap wrap = Wrap::repeat) {
    Scene scene;
    scene.path = "test.json";
    SceneObject object;
    object.displacement.amplitude = amplitude;
    object.displacement.midlevel = midlevel;
    object.displacement.wrap = wrap;
    object.mesh = make_mesh(file, object.transform, scene.origin, true);
    scene.objects.push_back(object);
    scene.camera.eye = {0.7, 2.2, 2.6};
    scene.lights.push_back({});
    scene.image = {96, 96, 4};
    return scene;
}

// A displaced ball under a sun and a lamp.
inline Scene lit_ball(const MeshFile& ball = ball_mesh()) {
    Scene scene = make_scene(ball, 0.3);
    Light point;
    point.kind = Light::Kind::point;
    point.position = {2, 2, 1};
    point.radius = 0.3f;
    scene.lights.push_back(point);
    return scene;
}

inline RenderSettings settings_of(const Scene& scene) {
    RenderSettings s;
    s.width = scene.image.width;
    s.height = scene.image.height;
    return s;
}

}  // namespace relievo::test
