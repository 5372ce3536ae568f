// What the search by patches (shaders/methods/exact/patch_search.glsl) relies on to drop a patch: no point of
// the surface leaves its patch's box, and over a patch the surface's derivatives stray from those at its
// middle by no more than said. And what the search answers: places of the surface that the ray meets within
// rounding, however far it comes from and however many texels the triangle has. Random triangles whose shells fold as often as not, maps, rays and
// patches.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

#include "tests/support/shader_in_float.h"

namespace relievo::patch_bounds_test {
namespace {

using namespace shader_in_float;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // every method has the same
#include "shaders/methods/exact/intersect.glsl"
#pragma GCC diagnostic pop

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

class Trial {
  public:
    // Of some texels a triangle, or of thousands with cliffs between them.
    enum class Map { any, many_cliffs };
    explicit Trial(unsigned seed, Map map = Map::any) : random_(seed), many_(map == Map::many_cliffs) {
        make_map();
        make_triangle();
        const vec3 target = primitive_.origin + vec3(direction() * 0.1);
        const vec3 eye = target + vec3(direction() * std::pow(10.0, between(-2, 1)));
        frame_ = make_patch_frame(primitive_, subject.normals, eye, normalize(target - eye));
    }

    void check_patch() {
        choose_patch();
        vec2 low, high;
        patch_texels(frame_, patch_texel(frame_, corner_), side_, low, high);
        const vec2 range = patch_displacement(primitive_, subject.object, low, high);
        const PatchBox box = patch_box(frame_, corner_, side_, range);
        const double rounding = 1e-5 * (1.0 + double{length(frame_.p)} + glm::length(dvec2(range)));
        for (int i = 0; i < 20; ++i) {
            const dvec2 b = place();
            const vec2 texel = patch_texel(frame_, vec2(b));
            const float value = map_value(0, primitive_base(primitive_), texel);
            const dvec3 s = surface(b, displacement(subject.object, value));
            const dvec4 at(s, s.x * double{box.across.x} + s.y * double{box.across.y});
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(at, dvec4(box.low) - rounding)) &&
                        glm::all(glm::lessThanEqual(at, dvec4(box.high) + rounding)))
                << at.x << " " << at.y << " " << at.z << " " << at.w << " leaves " << box.low.x << " "
                << box.low.y << " " << box.low.z << " " << box.low.w << " to " << box.high.x << " "
                << box.high.y << " " << box.high.z << " " << box.high.w;
        }
    }

    // How many patches had a spread at all.
    int check_derivatives() {
        choose_patch();
        const vec2 middle = corner_ + vec2(0.5f * side_), cell = floor(patch_texel(frame_, middle));
        const vec4 quad = height_quad(0, primitive_base(primitive_) + cell);
        const PatchFrame from = frame_at(frame_, vec2(0), frame_.tx - cell);
        const PatchPoint m = patch_point(from, subject.object, quad, middle);
        const float spread = jacobian_spread(frame_, subject.object, quad, m, 0.5f * side_);
        if (spread >= 1e30f) return 0;
        for (int i = 0; i < 20; ++i) {
            const PatchPoint a = patch_point(from, subject.object, quad, vec2(place()));
            const float rounding = 1e-4f * (length(a.s1) + length(a.s2) + length(m.s1) + length(m.s2));
            const float strays = length(a.s1 - m.s1) + length(a.s2 - m.s2);
            EXPECT_LE(strays, spread + rounding) << "side " << side_;
        }
        return 1;
    }

    // How far the hit lies beside a ray at the surface, over what rounding does to a place on it.
    std::optional<double> beside_ray() {
        const double b1 = between(0, 1), b2 = between(0, 1 - b1);
        const vec3 target(in_world({b1, b2})),
            eye = target + vec3(direction() * std::pow(10.0, between(0, 2)));
        const vec3 d = normalize(target - eye), away = abs(eye - primitive_.origin);
        SurfaceHit hit;
        if (!search_patches(primitive_, subject.normals, subject.object, eye, d, 0.0f, 1e30f,
                            3e-7f * max(max(away.x, away.y), away.z), vec3(1e-5f), hit))
            return std::nullopt;
        const dvec3 off = in_world(hit.b) - dvec3(eye), along = glm::normalize(dvec3(d));
        const vec2 tx1 = abs(primitive_.tx1), tx2 = abs(primitive_.tx2);
        const double steep =
            std::abs(double{subject.object.amplitude}) * std::max({tx1.x, tx1.y, tx2.x, tx2.y});
        const double high = std::max(std::abs(primitive_.w_low), std::abs(primitive_.w_high));
        const double size = double{length(primitive_.q2)} + primitive_.q1x + steep +
                            high / glm::length(dvec3(base_normal(subject.normals, hit.b)));
        return glm::length(off - along * glm::dot(off, along)) / (6e-8 * size);
    }

    // Of a ray that passes a cliff's edge by a hundred-thousandth of the amplitude, this side or that: how far beside the
    // surface it was met, over what rounding does to a place of the triangle, however many texels it has.
    std::optional<double> met_beside_cliff() {
        dvec2 b;
        do b = {between(0, 1), between(0, 1)};
        while (b.x + b.y > 1 || !to_texel_corner(b));
        const dvec3 on = in_world(b), toward = direction();
        const dvec3 off = glm::normalize(glm::cross(toward, direction()));
        const vec3 target(on + off * (1e-5 * double{subject.object.amplitude})), eye = target - vec3(toward);
        const vec3 d = normalize(target - eye), away = abs(eye - primitive_.origin);
        SurfaceHit hit;
        if (!search_patches(primitive_, subject.normals, subject.object, eye, d, 0.0f, 1e30f,
                            3e-7f * max(max(away.x, away.y), away.z), vec3(1e-5f), hit))
            return std::nullopt;
        const double high = std::max(std::abs(primitive_.w_low), std::abs(primitive_.w_high));
        const double size = 1 + double{length(primitive_.q2)} + primitive_.q1x +
                            high / glm::length(dvec3(base_normal(subject.normals, hit.b)));
        return nearest_to_ray(hit.b, dvec3(eye), glm::normalize(dvec3(d))) / (6e-8 * size);
    }

  private:
    // The nearest corner of four texels, if it lies in the triangle.
    bool to_texel_corner(dvec2& b) const {
        const dvec2 t1(primitive_.tx1 - primitive_.tx0), t2(primitive_.tx2 - primitive_.tx0);
        const dvec2 at = dvec2(primitive_.tx0) + t1 * b.x + t2 * b.y, to = glm::round(at) - dvec2(primitive_.tx0);
        const double turn = t1.x * t2.y - t1.y * t2.x;
        b = dvec2(to.x * t2.y - to.y * t2.x, t1.x * to.y - t1.y * to.x) / turn;
        return b.x > 0 && b.y > 0 && b.x + b.y < 1;
    }

    // The least distance of the surface from the ray, about a place whose barycentrics were rounded.
    double nearest_to_ray(dvec2 b, const dvec3& eye, const dvec3& d) const {
        const auto beside = [&](const dvec2& at) {
            const dvec3 off = in_world(at) - eye;
            return glm::length(off - d * glm::dot(off, d));
        };
        double least = beside(b);
        for (double step = 1e-6; step > 1e-11; step *= 0.6) {
            dvec2 best = b;
            for (int i = -4; i <= 4; ++i)
                for (int j = -4; j <= 4; ++j) {
                    const dvec2 at = b + dvec2(i, j) * (0.25 * step);
                    if (const double distance = beside(at); distance < least) least = distance, best = at;
                }
            b = best;
        }
        return least;
    }

    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    int whole(int a, int b) { return std::uniform_int_distribution<int>(a, b)(random_); }
    dvec3 direction() {
        for (;;) {
            const dvec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
            if (glm::length(v) > 0.1 && glm::length(v) < 1) return glm::normalize(v);
        }
    }

    void choose_patch() {
        const int depth = whole(0, 9), last = (1 << depth) - 1;
        side_ = std::ldexp(1.0f, -depth);
        corner_ = vec2(whole(0, last), 0) * side_;
        corner_.y = static_cast<float>(whole(0, last - static_cast<int>(corner_.x / side_))) * side_;
    }
    dvec2 place() { return dvec2(corner_) + dvec2(between(0, 1), between(0, 1)) * double{side_}; }

    void make_map() {
        map_.width = whole(1, 30);
        map_.height = whole(1, 30);
        const bool cliffs = many_ || whole(0, 2) == 0;
        for (int i = 0; i < map_.width * map_.height; ++i)
            map_.texels.push_back(static_cast<std::uint16_t>(cliffs ? 65535 * whole(0, 1) : whole(0, 65535)));
        pyramid_.emplace(map_.view(), Wrap::repeat);
        subject.map = &map_;
        subject.pyramid = &*pyramid_;
        subject.object = {};
        subject.object.amplitude = static_cast<float>(between(-2, 2) * std::pow(10.0, between(-3, 1)));
        subject.object.midlevel = static_cast<float>(between(0, 1));
        subject.object.map_size = {map_.width, map_.height};
    }

    void make_triangle() {
        for (;;) {
            MeshFile file;
            const double texels = std::pow(2.0, many_ ? between(9, 12) : between(-2, 6)), lean = between(0, 3);
            for (int i = 0; i < 3; ++i) {
                file.positions.push_back(direction());
                file.uvs.push_back(dvec2(between(-1, 1), between(-1, 1)) * texels /
                                   dvec2(map_.width, map_.height));
            }
            const dvec3 ng =
                glm::cross(file.positions[1] - file.positions[0], file.positions[2] - file.positions[0]);
            for (int i = 0; i < 3; ++i)
                file.file_normals.push_back(glm::normalize(glm::normalize(ng) + direction() * lean));
            file.faces = {{{0, 1, 2}, {0, 1, 2}}};
            const Mesh mesh = make_mesh(file, glm::dmat4(1), dvec3(0), true);
            const auto p = make_primitive(mesh, 0, 0, {{map_.width, map_.height}, false});
            if (!p) continue;
            primitive_ = *p;
            subject.normals = relievo::primitive_normals(mesh, 0);
            // As a searched triangle has them: bounds of the displacement.
            const float a = displacement(subject.object, 0), b = displacement(subject.object, 1);
            primitive_.w_low = std::min(a, b);
            primitive_.w_high = std::max(a, b);
            return;
        }
    }

    // In the ray's frame, in double.
    dvec3 surface(dvec2 b, double height) const {
        const PatchFrame& f = frame_;
        const dvec3 n = dvec3(f.n) + dvec3(f.n1) * b.x + dvec3(f.n2) * b.y;
        return dvec3(f.p) + dvec3(f.p1) * b.x + dvec3(f.p2) * b.y + glm::normalize(n) * height;
    }

    dvec3 in_world(dvec2 b) const {
        const Primitive& p = primitive_;
        const dvec3 t = p.tangent, u = glm::cross(dvec3(p.ng), t), n0 = subject.normals.n0;
        const dvec3 n = n0 + (dvec3(subject.normals.n1) - n0) * b.x + (dvec3(subject.normals.n2) - n0) * b.y;
        const dvec2 at = dvec2(p.tx0) + dvec2(p.tx1 - p.tx0) * b.x + dvec2(p.tx2 - p.tx0) * b.y,
                    cell = glm::floor(at);
        const glm::dvec4 quad(height_quad(0, primitive_base(p) + vec2(cell)));
        const double value = glm::mix(glm::mix(quad.x, quad.y, at.x - cell.x),
                                      glm::mix(quad.z, quad.w, at.x - cell.x), at.y - cell.y);
        return dvec3(p.origin) + t * (p.q1x * b.x + p.q2.x * b.y) + u * (p.q2.y * b.y) +
               glm::normalize(n) *
                   (double{subject.object.amplitude} * (value - double{subject.object.midlevel}));
    }

    std::mt19937 random_;
    bool many_;
    test::TestMap map_;
    std::optional<HeightPyramid> pyramid_;
    Primitive primitive_{};
    PatchFrame frame_{};
    vec2 corner_{0};
    float side_ = 1;
};

TEST(PatchBounds, HoldEveryPointOfTheSurface) {
    for (unsigned seed = 0; seed < 20000; ++seed) {
        Trial trial(seed);
        for (int i = 0; i < 8; ++i) trial.check_patch();
        ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
}

TEST(PatchBounds, HoldTheDerivatives) {
    int bounded = 0;
    for (unsigned seed = 0; seed < 20000; ++seed) {
        Trial trial(seed);
        for (int i = 0; i < 8; ++i) bounded += trial.check_derivatives();
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(bounded, 50000);
}

TEST(TexelFrom, IsRoundedOnce) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> texel(-16384, 16384);
    for (int i = 0; i < 20000; ++i) {
        PatchFrame f{};
        f.tx = {texel(random), texel(random)};
        f.tx1 = {texel(random), texel(random)};
        f.tx2 = {texel(random), texel(random)};
        const unsigned places = 1u << (random() % 16u);
        const vec2 corner = vec2(random() % places, random() % places) / static_cast<float>(places);
        const dvec2 at = dvec2(f.tx) + dvec2(f.tx1) * double{corner.x} + dvec2(f.tx2) * double{corner.y};
        const vec2 from(glm::floor(at));
        const dvec2 wrong = dvec2(texel_from(f, corner, from)) - (at - dvec2(from));
        ASSERT_LE(std::max(std::abs(wrong.x), std::abs(wrong.y)), 6e-8) << at.x << " " << at.y;
    }
}

// Rays that aim at a place of the surface, which some of it must stop.
TEST(SearchedHits, LieBesideFarRaysByRoundingOfTheTriangleAlone) {
    std::vector<double> beside;
    for (unsigned seed = 0; seed < 4000; ++seed) {
        const std::optional<double> b = Trial(seed).beside_ray();
        ASSERT_TRUE(b) << "seed " << seed << ": nothing is hit";
        beside.push_back(*b);
    }
    std::sort(beside.begin(), beside.end());
    EXPECT_LT(beside[beside.size() * 99 / 100], 3);
}

TEST(SearchedHits, AreNoneWhereRaysPassCliffsOfThousandsOfTexels) {
    std::vector<double> beside;
    for (unsigned seed = 0; seed < 800; ++seed)
        if (const auto b = Trial(seed, Trial::Map::many_cliffs).met_beside_cliff()) beside.push_back(*b);
    ASSERT_GT(beside.size(), 700u);
    std::sort(beside.begin(), beside.end());
    EXPECT_LT(beside[beside.size() * 9 / 10], 4);
    EXPECT_LT(beside[beside.size() * 99 / 100], 20);
}

}  // namespace
}  // namespace relievo::patch_bounds_test
