// texels_in_ball against a search over every texel of every face, in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "brushes/symmetry.h"
#include "editor/session/surface/mesh_surface.h"
#include "test_meshes.h"

namespace relievo::ball_test {
namespace {

using namespace test;

struct Found {
    double distance;
    glm::dvec3 position;
};

// The nearest point of S at every owned texel, by (y, x).
std::map<std::pair<int, int>, Found> search_all(const Mesh& mesh, const Displacement& d, const HeightMap& map,
                                                glm::dvec3 centre) {
    std::map<std::pair<int, int>, Found> found;
    const int width = map.width(), height = map.height();
    for (const Mesh::Face& face : mesh.faces) {
        glm::dvec2 t[3];
        for (int i = 0; i < 3; ++i) {
            t[i] =
                glm::dvec2(mesh.uvs[face.uv[static_cast<std::size_t>(i)]]) * glm::dvec2(width, height) - 0.5;
        }
        const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
        if (area == 0) continue;
        const int x0 = static_cast<int>(std::floor(std::min({t[0].x, t[1].x, t[2].x})));
        const int x1 = static_cast<int>(std::ceil(std::max({t[0].x, t[1].x, t[2].x})));
        const int y0 = static_cast<int>(std::floor(std::min({t[0].y, t[1].y, t[2].y})));
        const int y1 = static_cast<int>(std::ceil(std::max({t[0].y, t[1].y, t[2].y})));
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                const glm::dvec2 p(x, y);
                const auto part = [&](int i, int j) {
                    return ((t[i].x - p.x) * (t[j].y - p.y) - (t[i].y - p.y) * (t[j].x - p.x)) / area;
                };
                const double b[3] = {part(1, 2), part(2, 0), part(0, 1)};
                if (b[0] < -1e-12 || b[1] < -1e-12 || b[2] < -1e-12) continue;
                int wx = x, wy = y;
                if (d.wrap == Wrap::repeat) {
                    wx = ((x % width) + width) % width;
                    wy = ((y % height) + height) % height;
                } else if (x < 0 || y < 0 || x >= width || y >= height) {
                    continue;
                }
                glm::dvec3 position(0), normal(0);
                for (int i = 0; i < 3; ++i) {
                    position += b[i] * glm::dvec3(mesh.positions[face.position[static_cast<std::size_t>(i)]]);
                    normal += b[i] * glm::dvec3(mesh.normals[face.position[static_cast<std::size_t>(i)]]);
                }
                position += d.amplitude * (map.at(wx, wy) / 65535.0 - d.midlevel) * glm::normalize(normal);
                const double distance = glm::distance(position, centre);
                const auto [at, fresh] = found.try_emplace({wy, wx}, Found{distance, position});
                if (!fresh && distance < at->second.distance) at->second = {distance, position};
            }
        }
    }
    return found;
}

void expect_same_as_search(const Mesh& mesh, const Displacement& d, const HeightMap& map, glm::vec3 centre,
                           float radius) {
    const MeshSurface surface(mesh, d, map);
    std::vector<SurfaceTexel> texels;
    surface.texels_in_ball(centre, radius, texels);
    for (std::size_t i = 1; i < texels.size(); ++i) {
        ASSERT_TRUE(std::pair(texels[i - 1].y, texels[i - 1].x) < std::pair(texels[i].y, texels[i].x));
    }
    auto expected = search_all(mesh, d, map, glm::dvec3(centre));
    const double slack = 2e-5 * (1 + std::abs(d.amplitude) + static_cast<double>(radius));
    for (const SurfaceTexel& texel : texels) {
        const auto at = expected.find({texel.y, texel.x});
        ASSERT_NE(at, expected.end()) << texel.x << ' ' << texel.y;
        EXPECT_TRUE(surface.owned(texel.x, texel.y));
        EXPECT_NEAR(static_cast<double>(texel.distance), at->second.distance, slack);
        EXPECT_LT(texel.distance, radius);
        EXPECT_NEAR(static_cast<double>(glm::length(texel.normal)), 1, 1e-5);
        expected.erase(at);
    }
    for (const auto& [texel, found] : expected) {
        EXPECT_GT(found.distance, static_cast<double>(radius) - slack) << texel.second << ' ' << texel.first;
        EXPECT_TRUE(surface.owned(texel.second, texel.first));
    }
}

float uniform(std::mt19937& random, float low, float high) {
    return low + (high - low) * static_cast<float>(random() & 0xFFFFFF) / 16777216.0f;
}

// Triangles anywhere, with texture coordinates anywhere: overlapping, mirrored, across the map's borders,
// slivers.
Mesh soup(std::mt19937& random, int faces, float reach) {
    MeshBuilder builder;
    const auto corner = [&] {
        const glm::vec3 p(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        return MeshBuilder::Corner{p,
                                   {uniform(random, -reach, 1 + reach), uniform(random, -reach, 1 + reach)}};
    };
    for (int i = 0; i < faces; ++i) builder.triangle(corner(), corner(), corner());
    return builder.build();
}

TEST(Ball, finds_what_a_search_over_all_texels_finds) {
    std::mt19937 random = generator(1);
    for (int i = 0; i < 60; ++i) {
        const Mesh mesh =
            i % 2 ? box_sphere(3, 4, 5, static_cast<unsigned>(i)) : soup(random, 8, i % 4 ? 0.0f : 1.5f);
        const int width = 1 + static_cast<int>(random() % 90), height = 1 + static_cast<int>(random() % 90);
        const Displacement d =
            displacement(static_cast<double>(uniform(random, -0.5f, 0.5f)),
                         static_cast<double>(uniform(random, 0, 1)), i % 3 ? Wrap::repeat : Wrap::clamp);
        const HeightMap map = random_map(width, height, static_cast<unsigned>(i));
        for (int k = 0; k < 4; ++k) {
            const glm::vec3 centre(uniform(random, -1.2f, 1.2f), uniform(random, -1.2f, 1.2f),
                                   uniform(random, -1, 1));
            expect_same_as_search(mesh, d, map, centre, uniform(random, 0.02f, 1.5f));
        }
    }
}

TEST(Ball, displacement_ten_times_the_edge_length) {
    for (const double amplitude : {10.0, -10.0, 1e-6, 0.0}) {
        const Mesh mesh = box_sphere(3, 3, 3);
        const HeightMap map = random_map(64, 64, 3);
        for (const float radius : {0.5f, 2.0f, 9.0f}) {
            expect_same_as_search(mesh, displacement(amplitude), map, {1, 0.5f, 0}, radius);
        }
    }
}

TEST(Ball, mirrored_halves_that_share_their_texels_are_both_in_reach) {
    MeshBuilder builder;
    builder.quad({{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {1, 0}}, {{1, 1, 0}, {1, 1}}, {{0, 1, 0}, {0, 1}});
    builder.quad({{-1, 0, 0}, {1, 0}}, {{0, 0, 0}, {0, 0}}, {{0, 1, 0}, {0, 1}}, {{-1, 1, 0}, {1, 1}});
    const Mesh mesh = builder.build();
    const HeightMap map(32, 32);
    for (const float x : {-0.7f, -0.1f, 0.1f, 0.7f}) {
        expect_same_as_search(mesh, displacement(0.1), map, {x, 0.5f, 0}, 0.3f);
    }
}

TEST(Ball, texel_centres_on_shared_edges_come_once) {
    // 2n + 1 texels: the diagonal passes through texel centres.
    for (const int size : {1, 2, 31, 33, 64}) {
        const HeightMap map(size, size);
        const Mesh mesh = plane();
        const MeshSurface surface(mesh, displacement(0.1), map);
        std::vector<SurfaceTexel> texels;
        surface.texels_in_ball({0.5f, 0.5f, 0}, 10, texels);
        EXPECT_EQ(texels.size(), static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    }
}

TEST(Ball, zero_area_faces_and_duplicate_faces) {
    MeshBuilder builder;
    const MeshBuilder::Corner a{{0, 0, 0}, {0, 0}}, b{{1, 0, 0}, {1, 0}}, c{{1, 1, 0}, {1, 1}},
        d{{0, 1, 0}, {0, 1}};
    builder.quad(a, b, c, d);
    builder.quad(a, b, c, d);
    builder.triangle(a, a, a);
    builder.triangle(a, b, b);
    builder.triangle(a, c, {{0.5f, 0.5f, 0}, {0.5f, 0.5f}});
    builder.triangle(a, {{0.5f, 0.5f, 0}, {0, 1}}, c);  // no area, but a footprint
    const Mesh mesh = builder.build();
    const HeightMap map = random_map(40, 30, 2);
    expect_same_as_search(mesh, displacement(0.3), map, {0.4f, 0.6f, 0}, 0.37f);
}

TEST(Ball, normals_that_cancel_give_no_nan) {
    Mesh mesh = plane();
    mesh.normals[0] = {0, 0, 1};
    mesh.normals[1] = {0, 0, -1};
    mesh.normals[2] = {1, 0, 0};
    mesh.normals[3] = {-1, 0, 0};
    const HeightMap map = random_map(33, 33, 2);
    const MeshSurface surface(mesh, displacement(0.5), map);
    std::vector<SurfaceTexel> texels;
    surface.texels_in_ball({0.5f, 0.5f, 0}, 3, texels);
    EXPECT_EQ(texels.size(), 33u * 33u);
    for (const SurfaceTexel& t : texels) {
        EXPECT_NEAR(static_cast<double>(glm::length(t.normal)), 1, 1e-5);
        EXPECT_TRUE(std::isfinite(t.distance));
    }
}

TEST(Ball, far_and_small_scenes_keep_their_texels) {
    for (const float scale : {1e-4f, 1e4f}) {
        Mesh mesh = box_sphere(3, 3, 3);
        for (glm::vec3& p : mesh.positions) p *= scale;
        const HeightMap map = random_map(256, 256, 3);
        const MeshSurface surface(mesh, displacement(0.1 * static_cast<double>(scale)), map);
        std::vector<SurfaceTexel> texels;
        surface.texels_in_ball(mesh.positions[0], 0.5f * scale, texels);
        EXPECT_GT(texels.size(), 20u);
    }
}

TEST(Ball, parts_together_are_the_list_to_the_bit) {
    const Mesh sphere = box_sphere(3, 3, 3), square = plane();
    const HeightMap map = random_map(700, 500, 4);
    const glm::dmat4 mirror{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    for (const Mesh* mesh : {&sphere, &square}) {
        const MeshSurface plain(*mesh, displacement(0.2), map);
        const TurnedSurface turned(plain, mirror);
        for (const Surface* surface :
             {static_cast<const Surface*>(&plain), static_cast<const Surface*>(&turned)})
            for (const float radius : {0.0f, 0.01f, 0.6f, 5.0f}) {
                const glm::vec3 centre(0.5f, 0.4f, 0.1f);
                std::vector<SurfaceTexel> list, visited;
                surface->texels_in_ball(centre, radius, list);
                std::size_t largest = 0;
                surface->visit_ball(centre, radius, [&](std::span<const SurfaceTexel> part) {
                    visited.insert(visited.end(), part.begin(), part.end());
                    largest = std::max(largest, part.size());
                });
                EXPECT_LE(largest, 100000u);
                ASSERT_EQ(visited.size(), list.size());
                EXPECT_EQ(surface->count_in_ball(centre, radius), list.size());
                for (std::size_t i = 0; i < list.size(); ++i) {
                    ASSERT_EQ(visited[i].x, list[i].x);
                    ASSERT_EQ(visited[i].y, list[i].y);
                    ASSERT_EQ(visited[i].distance, list[i].distance);
                    ASSERT_EQ(visited[i].position, list[i].position);
                    ASSERT_EQ(visited[i].normal, list[i].normal);
                }
                if (radius == 5.0f && mesh == &square) {
                    EXPECT_LT(largest, list.size());  // several parts
                }
            }
    }
}

TEST(Ball, radius_or_centre_that_is_not_a_number) {
    const HeightMap map(16, 16);
    const Mesh mesh = plane();
    const MeshSurface surface(mesh, displacement(0.1), map);
    std::vector<SurfaceTexel> texels(3);
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                    kInf = std::numeric_limits<float>::infinity();
    for (const float radius : {0.0f, -1.0f, kNan, kInf, 1e-30f}) {
        surface.texels_in_ball({0.5f, 0.5f, 0}, radius, texels);
        EXPECT_TRUE(texels.empty()) << radius;
    }
    surface.texels_in_ball({kNan, 0, 0}, 1, texels);
    EXPECT_TRUE(texels.empty());
    surface.texels_in_ball({0.5f, 0.5f, 0}, 1e30f, texels);
    EXPECT_EQ(texels.size(), 256u);
}

TEST(Ball, sees_the_map_change_under_it) {
    HeightMap map(8, 8, 32768);
    const Mesh mesh = plane();
    MeshSurface surface(mesh, displacement(2.0, 0.0), map);
    std::vector<SurfaceTexel> texels;
    surface.texels_in_ball({0.5f, 0.5f, 0}, 0.9f, texels);
    EXPECT_TRUE(texels.empty());
    map.set(4, 4, 0);
    surface.texels_in_ball({0.5f, 0.5f, 0}, 0.9f, texels);
    ASSERT_EQ(texels.size(), 1u);
    EXPECT_EQ(texels[0].x, 4);
    surface.set_displacement(0, 0.5);
    surface.texels_in_ball({0.5f, 0.5f, 0}, 0.9f, texels);
    EXPECT_EQ(texels.size(), 64u);
}

// Prints figures; asserts nothing about time.
TEST(Ball, timing_of_a_dab_of_65k_texels) {
    for (const int size : {1024, 4096, 8192}) {
        const Mesh mesh = box_sphere(16, 16, 23);
        const auto ms = [](auto start) {
            return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count();
        };
        const HeightMap map = random_map(size, size, 1);
        auto start = std::chrono::steady_clock::now();
        const MeshSurface surface(mesh, displacement(0.01), map);
        const double built = ms(start);
        std::vector<SurfaceTexel> texels;
        float low = 0, high = 2;
        for (int i = 0; i < 20; ++i) {  // the radius of 256 x 256 texels
            const float radius = (low + high) / 2;
            surface.texels_in_ball({0.6f, 0.8f, 0.1f}, radius, texels);
            (texels.size() < 65536 ? low : high) = radius;
        }
        double best = 1e9;
        for (int i = 0; i < 10; ++i) {
            start = std::chrono::steady_clock::now();
            surface.texels_in_ball({0.6f, 0.8f, 0.1f}, high, texels);
            best = std::min(best, ms(start));
        }
        std::printf("  map %d: built in %.1f ms (%zu copies); %zu texels in a ball of %.3f: %.2f ms\n", size,
                    built, surface.seams().copies.size(), texels.size(), static_cast<double>(high), best);
    }
}

}  // namespace
}  // namespace relievo::ball_test
