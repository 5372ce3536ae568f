// The sample assets as relievo_assets writes them: counts, normals, layouts and seams. ctest runs the tool
// twice (fixture `sample_assets`) and passes the folders in the environment.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <ostream>
#include <set>
#include <string>

#include "tests/assets/obj_file.h"

namespace relievo::assets_test::sample_assets_test {
namespace {

namespace fs = std::filesystem;

fs::path environment(const char* name) {
    const char* value = std::getenv(name);
    if (!value) throw std::runtime_error(std::string(name) + " is not set: run this test through ctest");
    return value;
}

struct Asset {
    const char* name;
    std::size_t triangles;
    bool closed;           // every edge has two triangles
    bool slanted = false;  // has seams that no copied texel can make exact
};
void PrintTo(const Asset& asset, std::ostream* out) {
    *out << asset.name;
}

constexpr Asset kAssets[] = {{"plane", 2, false},     {"asteroid", 480, true}, {"chainmail", 1404, false},
                             {"leather", 3968, true}, {"orb", 3968, true},     {"stump", 7704, false, true},
                             {"knot", 22308, true},   {"fur", 3840, true}};

class SampleAsset : public testing::TestWithParam<Asset> {
  protected:
    void SetUp() override {
        const fs::path folder = environment("RELIEVO_ASSETS_FIRST");
        obj_ = read_obj(folder / "meshes" / (std::string(GetParam().name) + ".obj"));
        map_ = read_map(folder / "maps" / (std::string(GetParam().name) + ".png"));
    }
    glm::dvec2 uv(const Corner& c) const { return obj_.uvs[c.uv]; }

    ObjFile obj_;
    MapFile map_;
};

// The two texture-space lines of a mesh edge, each from the lower to the higher position index.
struct EdgeSides {
    std::vector<std::array<std::size_t, 2>> uvs;  // indices, one pair a triangle
};
std::map<std::array<std::size_t, 2>, EdgeSides> edges_of(const ObjFile& obj) {
    std::map<std::array<std::size_t, 2>, EdgeSides> edges;
    for (const auto& face : obj.faces)
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner &a = face[i], &b = face[(i + 1) % 3];
            if (a.position < b.position)
                edges[{a.position, b.position}].uvs.push_back({a.uv, b.uv});
            else
                edges[{b.position, a.position}].uvs.push_back({b.uv, a.uv});
        }
    return edges;
}

TEST_P(SampleAsset, has_the_triangles_it_promises) {
    EXPECT_EQ(obj_.faces.size(), GetParam().triangles);
    EXPECT_EQ(map_.bits, 16);
    EXPECT_EQ(map_.side, 512);
}

TEST_P(SampleAsset, has_one_unit_normal_for_each_position) {
    std::map<std::size_t, std::size_t> normal_of;
    for (const auto& face : obj_.faces)
        for (const Corner& c : face)
            EXPECT_EQ(normal_of.try_emplace(c.position, c.normal).first->second, c.normal);
    EXPECT_EQ(normal_of.size(), obj_.positions.size());
    for (const glm::dvec3& n : obj_.normals) EXPECT_NEAR(glm::length(n), 1.0, 1e-8);
}

TEST_P(SampleAsset, is_counter_clockwise_outside_and_in_the_map) {
    for (const auto& face : obj_.faces) {
        const glm::dvec3 a = obj_.positions[face[0].position];
        const glm::dvec3 normal =
            glm::cross(obj_.positions[face[1].position] - a, obj_.positions[face[2].position] - a);
        ASSERT_GT(glm::length(normal), 0.0);
        for (const Corner& c : face)
            EXPECT_GT(glm::dot(normal, obj_.normals[c.normal]) / glm::length(normal), 0.3);
        const glm::dvec2 e1 = uv(face[1]) - uv(face[0]), e2 = uv(face[2]) - uv(face[0]);
        EXPECT_GT(e1.x * e2.y - e1.y * e2.x, 0.0);
    }
    double volume = 0;
    for (const auto& face : obj_.faces)
        volume += glm::dot(obj_.positions[face[0].position],
                           glm::cross(obj_.positions[face[1].position], obj_.positions[face[2].position]));
    if (GetParam().closed) {
        EXPECT_GT(volume, 0.0);
    }
}

TEST_P(SampleAsset, edges_have_two_triangles_unless_open) {
    std::size_t open = 0;
    for (const auto& [key, edge] : edges_of(obj_)) {
        EXPECT_LE(edge.uvs.size(), 2u);
        open += edge.uvs.size() == 1;
    }
    EXPECT_EQ(open == 0, GetParam().closed);
}

TEST_P(SampleAsset, texture_coordinates_stay_inside_the_map) {
    for (const glm::dvec2& t : obj_.uvs) {
        EXPECT_GE(std::min(t.x, t.y), 0.0);
        EXPECT_LE(std::max(t.x, t.y), 1.0);
    }
}

// Islands: triangles that share texture coordinates.
std::vector<std::size_t> islands_of(const ObjFile& obj) {
    std::vector<std::size_t> parent(obj.uvs.size());
    for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = i;
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const auto& face : obj.faces)
        for (const Corner& c : face) parent[root(c.uv)] = root(face[0].uv);
    std::vector<std::size_t> island(parent.size());
    for (std::size_t i = 0; i < parent.size(); ++i) island[i] = root(i);
    return island;
}

TEST_P(SampleAsset, islands_neither_overlap_nor_come_nearer_than_their_gap) {
    constexpr int kSide = 512, kGap = 4 * kSide / 256;
    const std::vector<std::size_t> island = islands_of(obj_);
    std::vector<int> covered(kSide * kSide, 0);
    std::vector<std::size_t> owner(kSide * kSide, SIZE_MAX);
    for (const auto& face : obj_.faces) {
        const glm::dvec2 a = uv(face[0]) * double{kSide}, b = uv(face[1]) * double{kSide},
                         c = uv(face[2]) * double{kSide};
        const auto side = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 x) {
            return (q.x - p.x) * (x.y - p.y) - (q.y - p.y) * (x.x - p.x);
        };
        for (int y = static_cast<int>(std::min({a.y, b.y, c.y})); y < std::max({a.y, b.y, c.y}); ++y)
            for (int x = static_cast<int>(std::min({a.x, b.x, c.x})); x < std::max({a.x, b.x, c.x}); ++x) {
                const glm::dvec2 p{x + 0.5, y + 0.5};
                const double least = std::min({side(a, b, p), side(b, c, p), side(c, a, p)});
                if (least < -1e-9) continue;
                const auto texel = static_cast<std::size_t>(y * kSide + x);
                covered[texel] += least > 1e-9;
                if (covered[texel] > 1) ADD_FAILURE() << "two triangles over texel " << x << " " << y;
                owner[texel] = island[face[0].uv];
            }
    }
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (int step = 1; step < kGap; ++step) {
                const std::size_t here = owner[static_cast<std::size_t>(y * kSide + x)];
                if (here == SIZE_MAX) break;
                for (const auto& [dx, dy] : {std::pair{step, 0}, {0, step}, {step, step}, {step, -step}}) {
                    if (x + dx >= kSide || y + dy >= kSide || y + dy < 0) continue;
                    const std::size_t there = owner[static_cast<std::size_t>((y + dy) * kSide + x + dx)];
                    if (there != SIZE_MAX && there != here)
                        FAIL() << "islands touch at texel " << x << " " << y;
                }
            }
}

TEST_P(SampleAsset, heights_agree_exactly_along_straight_seams) {
    double aligned_gap = 0, slanted_gap = 0;
    std::size_t aligned = 0, slanted = 0;
    for (const auto& [key, edge] : edges_of(obj_)) {
        if (edge.uvs.size() != 2 || edge.uvs[0] == edge.uvs[1]) continue;
        bool straight = true;
        std::array<glm::dvec2, 2> from, step;
        for (std::size_t k = 0; k < 2; ++k) {
            from[k] = obj_.uvs[edge.uvs[k][0]];
            step[k] = obj_.uvs[edge.uvs[k][1]] - from[k];
            straight = straight && (step[k].x == 0.0 || step[k].y == 0.0);
        }
        (straight ? aligned : slanted) += 1;
        for (int i = 0; i <= 64; ++i) {  // dyadic, so that both sides' bilinear heights are exact
            const double f = i / 64.0;
            const double gap =
                std::fabs(map_.bilinear(from[0] + f * step[0]) - map_.bilinear(from[1] + f * step[1]));
            (straight ? aligned_gap : slanted_gap) = std::max(straight ? aligned_gap : slanted_gap, gap);
        }
    }
    EXPECT_EQ(aligned_gap, 0.0);
    EXPECT_LE(slanted_gap, 0.01 * 65535);
    EXPECT_EQ(slanted > 0, GetParam().slanted);
    EXPECT_EQ(aligned > 0, GetParam().triangles > 2);
    RecordProperty("slanted_gap_counts", std::to_string(slanted_gap));
}

TEST_P(SampleAsset, map_leaves_headroom_for_sculpting) {
    const auto [low, high] = std::minmax_element(map_.counts.begin(), map_.counts.end());
    EXPECT_GT(*low, 0.03 * 65535);
    EXPECT_LT(*high, 0.97 * 65535);
    EXPECT_GT(*high - *low, 0.2 * 65535);
}

INSTANTIATE_TEST_SUITE_P(All, SampleAsset, testing::ValuesIn(kAssets),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SampleAssets, chainmail_has_holes_and_wires) {
    const MapFile map = read_map(environment("RELIEVO_ASSETS_FIRST") / "maps" / "chainmail_opacity.png");
    EXPECT_EQ(map.bits, 8);
    std::size_t solid = 0;
    for (const unsigned short count : map.counts) solid += count > 32767;
    EXPECT_GT(solid, map.counts.size() / 4);
    EXPECT_LT(solid, map.counts.size() * 3 / 4);
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class SampleJournal : public testing::TestWithParam<std::array<const char*, 2>> {};

TEST_P(SampleJournal, dabs_lie_on_the_mesh_at_even_steps) {
    const auto [name, asset] = GetParam();
    const fs::path folder = environment("RELIEVO_ASSETS_FIRST");
    const ObjFile obj = read_obj(folder / "meshes" / (std::string(asset) + ".obj"));
    std::ifstream journal(folder / "strokes" / (std::string(name) + ".jsonl"));
    std::string line;
    std::getline(journal, line);
    EXPECT_EQ(line, std::string(R"({"relievo_journal":1,"scene":"../scenes/)") + asset + ".json\"}");
    std::size_t dabs = 0;
    while (std::getline(journal, line)) {
        const std::size_t list = line.find(R"("dabs":[)");
        if (list == std::string::npos) continue;
        double radius = 0;
        ASSERT_EQ(std::sscanf(line.c_str() + line.find(R"("radius")"), R"("radius":%lf)", &radius), 1);
        glm::dvec3 last{0};
        unsigned long last_time = 0;
        for (std::size_t at = line.find('[', list + 8); at != std::string::npos;
             at = line.find('[', at + 1)) {
            unsigned long time = 0, face = 0, b1 = 0, b2 = 0, pressure = 0;
            ASSERT_EQ(
                std::sscanf(line.c_str() + at, "[%lu,%lu,%lu,%lu,%lu]", &time, &face, &b1, &b2, &pressure),
                5);
            ASSERT_LT(face, obj.faces.size());
            ASSERT_LE(b1 + b2, 1u << 20);
            ASSERT_LE(pressure, 65535u);
            const auto& corners = obj.faces[face];
            const double w1 = static_cast<double>(b1) / (1 << 20), w2 = static_cast<double>(b2) / (1 << 20);
            const glm::dvec3 point = obj.positions[corners[0].position] * (1 - w1 - w2) +
                                     obj.positions[corners[1].position] * w1 +
                                     obj.positions[corners[2].position] * w2;
            if (time > 0) {
                EXPECT_GT(time, last_time);
                EXPECT_LT(glm::distance(point, last), radius);
            }
            last = point;
            last_time = time;
            ++dabs;
        }
    }
    EXPECT_GT(dabs, 100u);
}

INSTANTIATE_TEST_SUITE_P(All, SampleJournal,
                         testing::Values(std::array{"stump_rocks", "stump"}, std::array{"orb_groove", "orb"},
                                         std::array{"asteroid_first_minute", "asteroid"}),
                         [](const auto& test) { return std::string(test.param[0]); });

TEST(SampleAssets, two_runs_give_the_same_bytes) {
    const fs::path first = environment("RELIEVO_ASSETS_FIRST"), second = environment("RELIEVO_ASSETS_SECOND");
    std::size_t files = 0;
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(first)) {
        if (!file.is_regular_file()) continue;
        ++files;
        const fs::path other = second / fs::relative(file.path(), first);
        EXPECT_EQ(bytes_of(file.path()), bytes_of(other)) << other;
    }
    EXPECT_GE(files, 20u);
}

int exit_status(const std::string& arguments) {
    const std::string command =
        environment("RELIEVO_ASSETS_TOOL").string() + " " + arguments + " 2>/dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(SampleAssets, images_for_the_stamp_reach_high_and_fade_out_before_their_border) {
    int count = 0;
    for (const auto& file : fs::directory_iterator(environment("RELIEVO_ASSETS_FIRST") / "alphas")) {
        const MapFile image = read_map(file.path());
        int border = 0, highest = 0;
        for (int y = 0; y < image.side; ++y)
            for (int x = 0; x < image.side; ++x) {
                const int value = image.counts[static_cast<std::size_t>(y * image.side + x)];
                const double dx = 2.0 * x + 1 - image.side, dy = 2.0 * y + 1 - image.side;
                highest = std::max(highest, value);
                if (std::hypot(dx, dy) > image.side) border = std::max(border, value);
            }
        EXPECT_EQ(border, 0) << file.path() << ": beyond the brush's round";
        EXPECT_GT(highest, 40000) << file.path();
        ++count;
    }
    EXPECT_EQ(count, 8);
}

TEST(SampleAssets, bad_usage_ends_with_status_2) {
    const std::string folder = "-o " + (environment("RELIEVO_ASSETS_FIRST") / "unused").string();
    EXPECT_EQ(exit_status(""), 2);
    EXPECT_EQ(exit_status("-o"), 2);
    for (const char* size : {"63", "8193", "-1", "12x", "''"})
        EXPECT_EQ(exit_status(folder + " --size " + size), 2) << size;
    EXPECT_EQ(exit_status(folder + " --only teapot"), 2);
    EXPECT_EQ(exit_status(folder + " --colour red"), 2);
    EXPECT_EQ(exit_status("-o /dev/null/assets"), 1);
}

}  // namespace
}  // namespace relievo::assets_test::sample_assets_test
