// Against dense micro-triangles: an independent search that samples S on a fine grid of every face, polishes
// what the ray meets there by Newton's method, and looks for hits that the reference did not report.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/reference/sample_surfaces.h"

namespace relievo::test::micro_triangles_test {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kFar = 1e30;

struct MicroMesh {
    const ReferenceSurface& surface;
    int cuts;                               // of every edge
    std::vector<std::vector<dvec3>> grids;  // a face each, rows of b2

    MicroMesh(const ReferenceSurface& s, const Mesh& mesh, int n) : surface(s), cuts(n) {
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
            std::vector<dvec3>& grid = grids.emplace_back();
            for (int j = 0; j <= n; ++j) {
                for (int i = 0; i <= n; ++i)
                    grid.push_back(i + j <= n ? s.evaluate(0, face, double(i) / n, double(j) / n).position
                                              : dvec3(0));
            }
        }
    }

    // A root of S(b) = o + t d from the given start; the derivatives by central differences, so that nothing
    // of the reference's own derivatives is trusted.
    bool polish(std::uint32_t face, const dvec3& o, const dvec3& d, dvec2& b, double& t) const {
        const auto s = [&](double b1, double b2) { return surface.evaluate(0, face, b1, b2).position; };
        for (int step = 0; step < 30; ++step) {
            const double h = 1e-7;
            const dvec3 rest = s(b.x, b.y) - o - d * t;
            if (glm::length(rest) < 1e-12) return b.x >= 0 && b.y >= 0 && b.x + b.y <= 1;
            const dvec3 s1 = (s(b.x + h, b.y) - s(b.x - h, b.y)) / (2 * h);
            const dvec3 s2 = (s(b.x, b.y + h) - s(b.x, b.y - h)) / (2 * h);
            const dvec3 across = glm::cross(s1, s2);
            const double det = glm::dot(across, -d);
            b.x -= glm::dot(glm::cross(rest, s2), -d) / det;
            b.y -= glm::dot(glm::cross(s1, rest), -d) / det;
            t -= glm::dot(across, rest) / det;
            if (!std::isfinite(b.x + b.y + t) || std::abs(b.x) > 2 || std::abs(b.y) > 2) return false;
        }
        return false;
    }

    // Least t of all polished roots.
    double first(const dvec3& o, const dvec3& d) const {
        double best = kFar;
        for (std::uint32_t face = 0; face < grids.size(); ++face) {
            for (int j = 0; j < cuts; ++j) {
                for (int i = 0; i + j < cuts; ++i) {
                    meet(face, i, j, false, o, d, best);
                    if (i + j + 1 < cuts) meet(face, i, j, true, o, d, best);
                }
            }
        }
        return best;
    }

    void meet(std::uint32_t face, int i, int j, bool upper, const dvec3& o, const dvec3& d,
              double& best) const {
        const auto at = [&](int x, int y) {
            return grids[face][static_cast<std::size_t>(y * (cuts + 1) + x)];
        };
        const dvec3 a = upper ? at(i + 1, j + 1) : at(i, j), b = at(i + 1, j), c = at(i, j + 1);
        const dvec3 e1 = b - a, e2 = c - a, p = glm::cross(d, e2);
        const double det = glm::dot(e1, p);
        if (det == 0) return;
        const dvec3 from = o - a, q = glm::cross(from, e1);
        const double u = glm::dot(from, p) / det, v = glm::dot(d, q) / det, t = glm::dot(e2, q) / det;
        // Wider than the triangle: the surface bulges between its samples.
        if (u < -0.3 || v < -0.3 || u + v > 1.3 || t < 0) return;
        dvec2 start = upper ? dvec2(i + 1 - u, j + 1 - v) : dvec2(i + u, j + v);
        start /= cuts;
        double root = t;
        if (polish(face, o, d, start, root) && root > 0) best = std::min(best, root);
    }
};

void compare(const SampleSurface& sample, int cuts, std::uint32_t rays, double eye, const char* what) {
    const ReferenceSurface surface = sample.reference();
    const MicroMesh micro(surface, sample.mesh, cuts);
    int hits = 0, same = 0;
    std::uint64_t nodes = 0;
    for (std::uint32_t i = 0; i < rays; ++i) {
        const dvec3 centre(sample.mesh.sphere_centre);
        const double radius = sample.mesh.sphere_radius;
        const dvec3 from =
            centre +
            glm::normalize(dvec3(hash01(i, 0, 7), hash01(i, 1, 7), hash01(i, 2, 7)) - 0.5) * eye * radius;
        const dvec3 to =
            centre + (dvec3(hash01(i, 3, 7), hash01(i, 4, 7), hash01(i, 5, 7)) * 2.0 - 1.0) * 0.8 * radius;
        const dvec3 d = glm::normalize(to - from);
        const auto answer = surface.trace(from, d, 0, kFar);
        EXPECT_FALSE(answer.undecided);
        nodes += answer.nodes;
        const double found = micro.first(from, d), t = answer.hit ? answer.hit->t : kFar;
        // What the sampling finds, the reference must not miss.
        EXPECT_LE(t, found + 1e-9) << what << ", ray " << i;
        if (!answer.hit) continue;
        ++hits;
        same += std::abs(found - t) < 1e-9;
        // No invented hits: the point is on the ray and on S.
        EXPECT_LT(glm::distance(from + d * t, answer.hit->position), 1e-11) << what << ", ray " << i;
        const ReferencePoint on = surface.evaluate(0, answer.hit->face, answer.hit->b1, answer.hit->b2);
        EXPECT_LT(glm::distance(on.position, answer.hit->position), 1e-11) << what << ", ray " << i;
    }
    std::printf("%s: %d of %u rays hit, %d found by sampling too, %.0f nodes a ray\n", what, hits, rays, same,
                static_cast<double>(nodes) / rays);
    EXPECT_GT(same, hits * 9 / 10) << what;
}

TEST(MicroTriangles, BallWithDunes) {
    SampleSurface sample;
    sample.mesh = ball_mesh(8, 5);
    sample.amplitude = 0.4;
    sample.midlevel = 0.5;
    sample.paint(32, 16, [](int x, int y) { return ball_dunes((x + 0.5) / 32, (y + 0.5) / 16); });
    compare(sample, 12, 250, 3, "ball");
    compare(sample, 12, 250, 0.3, "ball from inside");
}

TEST(MicroTriangles, IrregularLumpWithNegativeAndLargeAmplitudes) {
    for (const double amplitude : {0.4, -0.4, 3.0}) {
        SampleSurface sample;
        sample.mesh = lump_mesh();
        sample.amplitude = amplitude;
        sample.midlevel = 0.5;
        sample.paint(24, 24, [](int x, int y) { return dunes((x + 0.5) / 24, (y + 0.5) / 24); });
        compare(sample, 16, 150, 4, "lump");
    }
}

TEST(MicroTriangles, FoldedShell) {
    // Normals lean towards each other and the displacement passes the point where they cross: S folds over,
    // several barycentrics for one point.
    SampleSurface sample;
    sample.mesh = triangle_mesh({0, 0, 0}, {1, 0, 0}, {0.3, 0.9, 0}, {1, 0.6, 1}, {-1, 0.5, 1}, {0.1, -1, 1});
    sample.amplitude = 1.5;
    sample.paint(6, 6, [](int x, int y) {
        return hash01(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 5);
    });
    compare(sample, 64, 600, 4, "folded shell");
    sample.texels = {65535};
    sample.width = sample.height = 1;
    compare(sample, 64, 600, 4, "folded shell, constant map");
}

TEST(MicroTriangles, CliffsAndNoise) {
    SampleSurface sample;
    sample.mesh = lump_mesh();
    sample.amplitude = 0.3;
    sample.midlevel = 0.3;
    sample.paint(8, 8, [](int x, int y) {
        return hash01(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 6) > 0.5;
    });
    compare(sample, 24, 150, 3, "cliffs");
}

TEST(MicroTriangles, DegenerateAndMirroredTextureCoordinates) {
    SampleSurface sample;
    sample.mesh =
        triangle_mesh({0, 0, 0}, {1, 0, 0}, {0.3, 0.9, 0}, {0.3, 0.1, 1}, {-0.2, 0.1, 1}, {0.1, -0.3, 1});
    sample.amplitude = 0.5;
    sample.paint(12, 12, [](int x, int y) {
        return hash01(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 3);
    });
    sample.mesh.uvs = {{0.1f, 0.2f}, {0.7f, 0.8f}, {0.4f, 0.5f}};  // a line
    compare(sample, 48, 200, 4, "texture on a line");
    sample.mesh.uvs = {{0.3f, 0.2f}, {0.3f, 0.2f}, {0.3f, 0.2f}};  // a point
    compare(sample, 8, 200, 4, "texture at a point");
    sample.mesh.uvs = {{0.1f, 0.9f}, {0.2f, 0.1f}, {0.9f, 0.7f}};  // mirrored
    compare(sample, 48, 200, 4, "mirrored texture");
    sample.mesh.uvs = {{-1.4f, 0.9f}, {0.2f, -2.1f}, {1.9f, 3.7f}};  // several periods
    compare(sample, 96, 200, 4, "several periods");
}

TEST(Speed, ABallOf960TrianglesIsTracedWithinSeconds) {
    SampleSurface sample;
    sample.mesh = ball_mesh(32, 16);
    sample.amplitude = 0.2;
    sample.midlevel = 0.5;
    sample.paint(512, 512, [](int x, int y) { return ball_dunes((x + 0.5) / 512, (y + 0.5) / 512); });
    const ReferenceSurface surface = sample.reference();
    Camera camera;
    const auto start = std::chrono::steady_clock::now();
    const ReferenceImage image = trace_image(surface, camera, dvec3(0), 128, 128);
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    std::size_t hits = 0;
    for (const std::uint32_t object : image.object) hits += object != 0;
    std::printf("128 x 128 pixels of a 960-triangle ball: %.0f ms, %zu hits\n", ms, hits);
    EXPECT_EQ(image.undecided, 0u);
    EXPECT_GT(hits, 4000u);
}

}  // namespace
}  // namespace relievo::test::micro_triangles_test
