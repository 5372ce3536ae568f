// `exact` against the reference on surfaces drawn at random: meshes, maps, amplitudes and views that nobody chose. Held to
// its promise pixel by pixel, but not to the median's: such a view may show a blade edge-on and nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/stability/case_parts.h"
#include "renderer/stability/extreme_meshes.h"
#include "renderer/stability/harness.h"
#include "tests/stability/draw.h"
#include "tests/support/device.h"

namespace relievo::stability::random_surfaces_test {
namespace {

constexpr unsigned kSeeds = 32;
constexpr int kSize = 40;  // pixels a side

std::vector<NamedView> around_ball(Draw& draw) {
    std::vector<NamedView> views;
    for (const char* name : {"far", "near"}) {
        const glm::dvec3 eye = draw.direction() * draw.between(1.2, 4);
        views.push_back({name, eye, draw.vector(0.5)});
    }
    const glm::dvec3 eye = draw.direction() * draw.between(0.02, 0.6);
    views.push_back({"within", eye, draw.vector(0.5)});
    return views;
}

std::vector<NamedView> over_plane(Draw& draw) {
    std::vector<NamedView> views;
    for (const char* name : {"one", "another"}) {
        glm::dvec3 eye = draw.vector(1.1) + glm::dvec3(0.5, 0.5, 0);
        eye.z = (draw.coin() ? 1 : -1) * draw.log_between(0.01, 2);
        views.push_back({name, eye, {draw.between(0, 1), draw.between(0, 1), 0}});
    }
    return views;
}

Mesh any_ball(Draw& draw) {
    const int columns = draw.whole(4, 32), rows = draw.whole(3, 18);
    return ball_mesh(columns, rows);
}

glm::dmat4 squeeze(Draw& draw) {
    glm::dmat4 m(1);
    m[0] = {draw.between(0.2, 1.5), draw.between(-0.4, 0.4), 0, 0};
    m[1] = {draw.between(-0.5, 0.5), draw.between(0.2, 1.5), 0, 0};
    m[2] = {0, draw.between(-0.5, 0.5), draw.between(0.1, 1.5), 0};
    return m;
}

Mesh any_triangle(Draw& draw) {
    std::array<glm::dvec3, 3> normals;
    for (glm::dvec3& n : normals) {
        const double lean = draw.between(0, 1.2);
        n = glm::normalize(glm::dvec3(0, 0, 1) + lean * draw.direction());
    }
    return triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, normals[0], normals[1], normals[2]);
}

MapShape any_map(Draw& draw) {
    const auto side = [&] { return draw.whole(0, 3) > 0 ? draw.whole(4, 200) : draw.whole(1, 8); };
    const int width = side(), height = side();
    const auto wave = [](double across, double up) {
        return [across, up](int x, int y) { return 0.5 + 0.5 * std::sin(across * x) * std::cos(up * y); };
    };
    MapShape (*const patterns[])(int, int) = {dunes_map, noise_map, cliff_map, spike_map, ridge_map};
    const auto pattern = static_cast<std::size_t>(draw.whole(0, 5));
    MapShape map;
    if (pattern < std::size(patterns)) {
        map = patterns[pattern](width, height);
    } else {
        const double across = draw.between(0.05, 0.6), up = draw.between(0.05, 0.6);
        map = {width, height, wave(across, up)};
    }
    map.wrap = draw.coin() ? Wrap::repeat : Wrap::clamp;
    return map;
}

Case random_case(unsigned seed) {
    Draw draw(seed);
    Mesh mesh;
    bool flat = false;
    switch (draw.whole(0, 8)) {
        case 0:
            mesh = plane_mesh(draw.log_between(0.2, 5), draw.between(-2, 2));
            flat = true;
            break;
        case 1:
            mesh = any_triangle(draw);
            flat = true;
            break;
        case 2:
            mesh = lump_mesh();
            break;
        case 3:
            mesh = blade_mesh(draw.between(2, 60), draw.whole(2, 8));
            break;
        case 4:
            mesh = wedge_mesh(draw.between(1, 179));
            break;
        case 5:
            mesh = with_leaning_normals(any_ball(draw));
            break;
        case 6:
            mesh = transformed(any_ball(draw), squeeze(draw));
            break;
        case 7:
            mesh = with_overlapping_uvs(lump_mesh());
            break;
        default:
            mesh = any_ball(draw);
    }
    const auto views = flat ? over_plane(draw) : around_ball(draw);
    const MapShape map = any_map(draw);
    const double amplitude = (draw.coin() ? 1 : -1) * draw.log_between(1e-3, 1.5);
    const double midlevel = draw.coin() ? draw.between(0, 1) : draw.whole(0, 1);
    return on_mesh(mesh, views, amplitude, midlevel, map);
}

class RandomSurfaces : public testing::TestWithParam<unsigned> {};

TEST_P(RandomSurfaces, ExactIsRight) {
    const JudgedCase judged({"random", "seed_" + std::to_string(GetParam()), "drawn at random",
                             [&] { return random_case(GetParam()); }},
                            kSize);
    const Cell cell = judged.run(test::device(), find_method("exact"));
    const ImageComparison errors = cell.worst().errors;
    EXPECT_NE(cell.verdict, Verdict::broken) << cell.text();
    EXPECT_EQ(errors.missed + errors.invented + errors.unexplained, 0) << cell.text();
    EXPECT_LE(errors.depth_away.p99, 1e-4) << cell.text();
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSurfaces, testing::Range(0u, kSeeds));

}  // namespace
}  // namespace relievo::stability::random_surfaces_test
