// The sample meshes' layouts, and strokes over their seams: what RELIEVO_SAMPLES (a folder of the generator)
// holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>

#include "brushes/sculptor.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/seam_gap.h"
#include "editor/session/surface/seam_table.h"
#include "slope_jump.h"
#include "test_meshes.h"

namespace relievo::samples_test {
namespace {

using namespace test;

constexpr int kSize = 512;

std::vector<std::filesystem::path> sample_meshes() {
    const char* folder = std::getenv("RELIEVO_SAMPLES");
    if (folder == nullptr) return {};
    std::vector<std::filesystem::path> meshes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".obj") meshes.push_back(entry.path());
    }
    std::sort(meshes.begin(), meshes.end());
    return meshes;
}

Mesh load(const std::filesystem::path& path) {
    return make_mesh(load_mesh_file(path), glm::dmat4(1), glm::dvec3(0), true);
}

TEST(Samples, aligned_seams_close_exactly_whatever_the_map) {
    ASSERT_GE(sample_meshes().size(), 8u);
    for (const auto& path : sample_meshes()) {
        const Mesh mesh = load(path);
        const auto start = std::chrono::steady_clock::now();
        const SeamTable table = build_seam_table(mesh, kSize, kSize, Wrap::repeat);
        const double ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        HeightMap map = random_map(kSize, kSize, 1);
        fill_gutters(map, table);
        const std::vector<SeamGap> gaps = seam_gaps(mesh, map, Wrap::repeat);
        const auto aligned =
            std::count_if(gaps.begin(), gaps.end(), [](const SeamGap& g) { return g.aligned; });
        std::printf(
            "  %-10s %6zu faces, %4zu seam edges (%td aligned), %6zu copies, %5zu equations, %.1f ms\n",
            path.stem().c_str(), mesh.faces.size(), gaps.size(), aligned, table.copies.size(),
            table.equations.size(), ms);
        EXPECT_EQ(max_seam_gap(mesh, map, Wrap::repeat, true), 0) << path;
        // Both have seams that slant; heights of the latter are procedural, and sculpted when they are baked.
        if (path.stem() == "stump" || path.stem() == "procedural_sphere") {
            EXPECT_LT(static_cast<std::size_t>(aligned), gaps.size());
        } else {
            EXPECT_TRUE(table.equations.empty()) << path;
        }
    }
}

// The furthest position's distance from the origin.
float size_of(const Mesh& mesh) {
    float size = 0;
    for (const glm::vec3& p : mesh.positions) size = std::max(size, glm::length(p));
    return size;
}

// Dabs on every corner of every seam's edges that is not too near another, so that all kinds of ends are met.
std::vector<Dab> dabs_on_seams(const Mesh& mesh, const HeightMap& map, float apart) {
    std::vector<glm::vec3> places;
    std::vector<Dab> dabs;
    for (const SeamGap& gap : seam_gaps(mesh, map, Wrap::repeat)) {
        for (const std::uint32_t position : gap.position) {
            const glm::vec3 p = mesh.positions[position];
            const auto near = [&](glm::vec3 q) { return glm::distance(p, q) < apart; };
            if (std::any_of(places.begin(), places.end(), near)) continue;
            places.push_back(p);
            for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
                const auto& corners = mesh.faces[face].position;
                const auto at = std::find(corners.begin(), corners.end(), position);
                if (at == corners.end()) continue;
                Dab dab;
                dab.face = face;
                dab.b1 = at == corners.begin() + 1 ? Dab::kBarycentricOne : 0;
                dab.b2 = at == corners.begin() + 2 ? Dab::kBarycentricOne : 0;
                dabs.push_back(dab);
                break;
            }
        }
    }
    return dabs;
}

TEST(Samples, strokes_over_seams_leave_no_gap) {
    for (const auto& path : sample_meshes()) {
        const Mesh mesh = load(path);
        const float size = size_of(mesh);
        HeightMap map(kSize, kSize);
        const MeshSurface surface(mesh, displacement(0.2 * static_cast<double>(size)), map);
        Sculptor sculptor(map, surface);
        const std::vector<Dab> dabs = dabs_on_seams(mesh, map, 0.15f * size);
        for (const Tool tool : {Tool::draw, Tool::smooth, Tool::flatten}) {
            Brush brush;
            brush.tool = tool;
            brush.radius = 0.1f * size;
            brush.strength = 1;
            sculptor.begin(brush);
            for (const Dab& dab : dabs) {
                for (int i = 0; i < 4; ++i) sculptor.dab(dab);
            }
            sculptor.end();
            const auto [low, high] = std::minmax_element(map.texels().begin(), map.texels().end());
            const double aligned = max_seam_gap(mesh, map, Wrap::repeat, true);
            const double any = max_seam_gap(mesh, map, Wrap::repeat, false);
            EXPECT_EQ(aligned, 0) << path;
            EXPECT_LE(any, 0.02 * (*high - *low)) << path << " of " << *high - *low;
            if (!dabs.empty() && tool == Tool::draw) {
                EXPECT_GT(*high - *low, 500) << path;
            }
            if (any > 0) std::printf("  %s: %.1f of %d counts\n", path.stem().c_str(), any, *high - *low);
        }
    }
}

// Along exact seams, in the slope of a stroke over all of them: where rows bend most it shows less than the
// bends of rows within the islands do.
TEST(Samples, a_stroke_over_exact_seams_keeps_its_slope) {
    for (const auto& path : sample_meshes()) {
        const Mesh mesh = load(path);
        const float size = size_of(mesh);
        HeightMap map(kSize, kSize);
        const Displacement shown = displacement(0.2 * static_cast<double>(size));
        const MeshSurface surface(mesh, shown, map);
        if (surface.seams().bends.empty()) continue;
        Sculptor sculptor(map, surface);
        Brush brush;
        brush.radius = 0.2f * size;
        brush.strength = 1;
        sculptor.begin(brush);
        for (const Dab& dab : dabs_on_seams(mesh, map, 0.15f * size)) sculptor.dab(dab);
        sculptor.end();
        const HeightMap copies = with_copies_alone(map, surface.seams());
        const auto mean = [&](const HeightMap& of) {
            double sum = 0, count = 0;
            for (const SlopeJump& jump : slope_jumps(mesh, of, shown))
                if (jump.seam && jump.aligned) sum += jump.mean, ++count;
            return sum / count;
        };
        const double before = mean(copies), after = mean(map);
        std::printf("  %-10s mean jump of slope: %.5f by copies, %.5f\n", path.stem().c_str(), before, after);
        EXPECT_LT(after, std::max(0.5 * before, 2e-4)) << path << ": all but rounding";
        if (path.stem() == "asteroid" || path.stem() == "orb" || path.stem() == "leather") {
            EXPECT_LT(after, 0.1 * before) << path;
        }
    }
}

// Slanted seams of 8 bits may differ by one value more: both sides are rounded.
TEST(Samples, painting_over_seams_leaves_none_to_see) {
    for (const auto& path : sample_meshes()) {
        const Mesh mesh = load(path);
        const float size = size_of(mesh);
        HeightMap map(kSize, kSize);
        const MeshSurface surface(mesh, displacement(0.2 * static_cast<double>(size)), map);
        const std::vector<Dab> dabs = dabs_on_seams(mesh, map, 0.15f * size);
        for (const int bits : {8, 16}) {
            ColourMap colours(kSize, kSize, bits, {50 * 257, 150 * 257, 200 * 257});
            Sculptor sculptor(map, surface);
            sculptor.set_colours(colours);
            Brush brush;
            brush.radius = 0.1f * size;
            brush.paint = Paint::colour;
            brush.red = 1.0f, brush.green = 0.1f, brush.blue = 0.3f;
            sculptor.begin(brush);
            for (const Dab& dab : dabs) {
                for (int i = 0; i < 3; ++i) sculptor.dab(dab);
            }
            sculptor.end();
            for (std::size_t k = 0; k < 3; ++k) {
                const HeightMap& plane = colours.plane(k);
                const auto [low, high] = std::minmax_element(plane.texels().begin(), plane.texels().end());
                EXPECT_EQ(max_seam_gap(mesh, plane, Wrap::repeat, true), 0) << path;
                EXPECT_LE(max_seam_gap(mesh, plane, Wrap::repeat, false),
                          0.02 * (*high - *low) + (bits == 8 ? 257 : 0))
                    << path << ", " << bits << " bits, of " << *high - *low;
            }
        }
    }
}

}  // namespace
}  // namespace relievo::samples_test
