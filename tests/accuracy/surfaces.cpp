// See surfaces.h.
#include "tests/accuracy/surfaces.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>

namespace relievo::test {
namespace {

using glm::dvec3;
using Value = std::function<double(int, int)>;

const std::vector<NamedView> kPlaneViews{{"from above", {0.5, 0.1, 1.6}, {0.5, 0.5, 0}},
                                         {"grazing", {-0.4, -0.3, 0.16}, {0.6, 0.6, 0}},
                                         {"along the ground", {0.5, 0.5, 0.12}, {0.9, 0.8, 0.08}},
                                         {"from below", {0.4, 0.2, -1.3}, {0.5, 0.5, 0}}};
const std::vector<NamedView> kBallViews{{"from outside", {2.0, 1.4, 1.1}, {0, 0, 0}},
                                        {"grazing", {1.25, 0.5, 0.0}, {0.0, 1.0, 0.1}},
                                        {"from inside", {0.1, 0.2, 0.0}, {1, 0.3, 0.2}},
                                        {"from far", {9, 20, 7}, {0, 0, 0}, 2e-5}};

JudgedSurface plane(double amplitude, double midlevel, int width, int height, const Value& value,
                    Wrap wrap = Wrap::repeat, Sampled sampled = Sampled::no_promise) {
    JudgedSurface s;
    s.sample.mesh = plane_mesh();
    s.sample.amplitude = amplitude;
    s.sample.midlevel = midlevel;
    s.sample.wrap = wrap;
    s.sample.paint(width, height, value);
    s.views = kPlaneViews;
    s.sampled = sampled;
    return s;
}

JudgedSurface on_mesh(const Mesh& mesh, double amplitude, double midlevel, int width, int height,
                      const Value& value, Sampled sampled = Sampled::no_promise) {
    JudgedSurface s = plane(amplitude, midlevel, width, height, value, Wrap::repeat, sampled);
    s.sample.mesh = mesh;
    s.views = kBallViews;
    return s;
}

Value dunes_of(int width, int height) {
    return [=](int x, int y) { return dunes((x + 0.5) / width, (y + 0.5) / height); };
}

Value ball_dunes_of(int width, int height) {
    return [=](int x, int y) { return ball_dunes((x + 0.5) / width, (y + 0.5) / height); };
}

JudgedSurface ball(double amplitude, double midlevel) {
    return on_mesh(ball_mesh(32, 16), amplitude, midlevel, 256, 128, ball_dunes_of(256, 128),
                   Sampled::within_limits);
}

JudgedSurface lump(double amplitude) {
    return on_mesh(lump_mesh(), amplitude, 0.5, 128, 128, ball_dunes_of(128, 128), Sampled::known_flaw);
}

JudgedSurface scaled(JudgedSurface s, double scale) {
    for (glm::vec3& p : s.sample.mesh.positions) p = glm::vec3(dvec3(p) * scale);
    measure_bounds(s.sample.mesh);
    s.sample.amplitude *= scale;
    for (NamedView& v : s.views) v.eye *= scale, v.look_at *= scale;
    s.sampled = Sampled::no_promise;
    return s;
}

JudgedSurface moved(JudgedSurface s, const dvec3& origin) {
    s.origin = origin;
    s.sampled = Sampled::no_promise;
    return s;
}

// The plane squeezed to a strip of two slivers, turned out of the axes.
JudgedSurface slivers(double width) {
    JudgedSurface s = plane(0.02, 0.5, 64, 64, dunes_of(64, 64));
    for (glm::vec3& p : s.sample.mesh.positions) p = {p.x, p.y * width + 0.3f * p.x, 0};
    measure_bounds(s.sample.mesh);
    s.views = {{"from above", {0.5, 0.15, 0.5 * std::sqrt(width)}, {0.5, 0.151, 0}},
               {"grazing", {0.2, -0.1, 0.08}, {0.6, 0.185, 0}}};
    return s;
}

JudgedSurface one_triangle(double amplitude, double spread) {
    JudgedSurface s = plane(amplitude, 0.5, 64, 64, dunes_of(64, 64));
    s.sample.mesh = triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {spread, spread, 1},
                                  {-spread, 0.5 * spread, 1}, {0.3 * spread, -spread, 1});
    s.views = {{"from above", {0.3, 0.1, 2.0}, {0.33, 0.33, 0}},
               {"grazing", {-0.6, -0.5, 0.4}, {0.4, 0.4, 0}},
               {"from below", {0.3, 0.2, -1.6}, {0.33, 0.33, 0}}};
    return s;
}

int known_wrong(const std::string& name) {
    // One sheet of several inside the triangle is followed.
    if (name == "folded_shell") return 500;
    // A few pixels where normals lean far from the triangle's own.
    if (name == "cliffs_on_lump") return 20;
    return 0;
}

using Maker = std::function<JudgedSurface()>;

const std::vector<std::pair<std::string, Maker>>& makers() {
    const auto limits = Sampled::within_limits;
    const auto spikes = [](int x, int y) { return x % 8 == 3 && y % 8 == 5 ? 1.0 : 0.2; };
    const auto ridges = [](int x, int y) { return x % 7 == 3 || y % 11 == 5 ? 0.9 : 0.1; };
    const auto cliffs = [](int x, int y) { return hash01(unsigned(x), unsigned(y), 5) < 0.5 ? 0.0 : 1.0; };
    const auto fur = [](int x, int y) { return std::pow(hash01(unsigned(x), unsigned(y), 9), 4); };
    static const std::vector<std::pair<std::string, Maker>> list{
        {"ball", [] { return ball(0.2, 0.5); }},
        {"ball_carved", [] { return ball(-0.1, 0.0); }},
        {"lump", [] { return lump(0.1); }},
        {"lump_high", [] { return lump(0.4); }},
        {"dunes", [=] { return plane(0.15, 0.5, 256, 256, dunes_of(256, 256), Wrap::repeat, limits); }},
        {"ramp",
         [=] {
             return plane(
                 0.3, 0.5, 64, 64, [](int x, int) { return x / 63.0; }, Wrap::clamp, limits);
         }},
        {"ramps",
         [=] {
             return plane(
                 0.1, 0, 128, 128, [](int x, int) { return x % 32 / 31.0; }, Wrap::repeat, limits);
         }},
        {"terraces",
         [=] {
             return plane(
                 0.1, 0, 64, 64, [](int x, int y) { return (x / 8 + y / 8) % 2; }, Wrap::repeat, limits);
         }},
        {"flat_low",
         [=] {
             return plane(
                 0.2, 0.5, 4, 4, [](int, int) { return 0.0; }, Wrap::repeat, limits);
         }},
        {"flat_mid",
         [=] {
             return plane(
                 0.2, 0.5, 4, 4, [](int, int) { return 0.5; }, Wrap::repeat, limits);
         }},
        {"flat_high",
         [=] {
             return plane(
                 0.2, 0.5, 4, 4, [](int, int) { return 1.0; }, Wrap::repeat, limits);
         }},
        {"spikes", [=] { return plane(0.1, 0.2, 96, 96, spikes); }},
        {"spikes_on_ball", [=] { return on_mesh(ball_mesh(32, 16), 0.2, 0.2, 256, 128, spikes); }},
        {"ridges", [=] { return plane(-0.1, 0.8, 77, 77, ridges); }},
        {"ridges_on_ball", [=] { return on_mesh(ball_mesh(32, 16), 0.15, 0.5, 255, 127, ridges); }},
        {"cliffs", [=] { return plane(0.05, 1.0, 64, 64, cliffs, Wrap::clamp); }},
        {"cliffs_on_ball", [=] { return on_mesh(ball_mesh(32, 16), 0.1, 0.3, 128, 64, cliffs); }},
        {"cliffs_on_lump", [=] { return on_mesh(lump_mesh(), 0.2, 0.5, 64, 64, cliffs); }},
        {"fur_on_ball", [=] { return on_mesh(ball_mesh(32, 16), 0.1, 0.0, 512, 256, fur); }},
        {"fur_on_lump", [=] { return on_mesh(lump_mesh(), 0.1, 0.0, 256, 256, fur); }},
        {"one_texel",
         [=] { return on_mesh(ball_mesh(32, 16), 0.2, 0.5, 1, 1, [](int, int) { return 0.8; }); }},
        {"one_by_nine", [] { return plane(0.2, 0.5, 1, 9, [](int, int y) { return y % 3 / 2.0; }); }},
        {"nine_by_one",
         [] {
             return plane(
                 0.2, 0.5, 9, 1, [](int x, int) { return x % 3 / 2.0; }, Wrap::clamp);
         }},
        {"seven_by_five", [] { return on_mesh(lump_mesh(), 0.2, 0.5, 7, 5, ball_dunes_of(7, 5)); }},
        {"large_odd_map",
         [] { return plane(0.1, 0.5, 1777, 601, [](int x, int y) { return dunes(x / 100.0, y / 90.0); }); }},
        {"tiny_scene", [] { return scaled(ball(0.2, 0.5), 1e-4); }},
        {"large_scene", [] { return scaled(lump(0.1), 1e4); }},
        {"far_away", [] { return moved(ball(0.2, 0.5), dvec3(1e5, -1e5, 1e5)); }},
        {"slivers", [] { return slivers(1e-2); }},
        {"thin_slivers", [] { return slivers(1e-4); }},
        {"leaning_normals", [] { return one_triangle(0.2, 0.7); }},
        {"steep_normals", [] { return one_triangle(0.3, 3); }},
        {"folded_shell", [] { return one_triangle(1.6, 0.9); }},
    };
    return list;
}

}  // namespace

std::vector<std::string> judged_surface_names() {
    std::vector<std::string> names;
    for (const auto& [name, maker] : makers()) names.push_back(name);
    return names;
}

JudgedSurface judged_surface(const std::string& name) {
    for (const auto& [known, maker] : makers()) {
        if (known != name) continue;
        JudgedSurface s = maker();
        s.name = name;
        s.exact_wrong = known_wrong(name);
        return s;
    }
    throw std::invalid_argument("no judged surface is called " + name);
}

}  // namespace relievo::test
