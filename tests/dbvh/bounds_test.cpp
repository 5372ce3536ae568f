// No point of the displaced surface leaves the box of a square that it lies in: random triangles, normals,
// maps, levels.
#include <gtest/gtest.h>

#include <random>

#include "tests/dbvh/dbvh_shader.h"

namespace relievo::dbvh::bounds_test {
namespace {

using glm::dvec2;
using glm::dvec3;

class Trial {
  public:
    explicit Trial(unsigned seed) : random_(seed) {
        make_map();
        make_triangle();
    }

    void check_square(float leaf) {
        const Primitive& p = primitive_;
        const Domain g = make_domain(p, subject.normals, is_thin(p), greatest_displacement(subject.object), 0);
        thin += g.thin ? 1 : 0;
        const int leaf_level = whole(0, 2), level = leaf_level + whole(0, 5);
        const float size = std::ldexp(1.0f, level), stride = std::ldexp(1.0f, leaf_level);
        const dvec2 at = barycentrics();
        const vec2 inside = g.t0 + vec2(dvec2(g.t1) * at.x + dvec2(g.t2) * at.y), base = g.thin ? vec2(0) : primitive_base(p);
        const vec2 square = floor((base + inside) / size) * size - base;
        const vec2 low = max(square - g.t0, g.low), high = min(square - g.t0 + vec2(size), g.high);
        const vec2 middle = 0.5f * (low + high), half_size = 0.5f * (high - low);
        const bool by_pieces = level == leaf_level && leaf != kLeafBspline;
        const LeafCells cells = leaf_cells(p, g, square, stride, middle, half_size);
        const vec2 values = by_pieces ? leaf_values(p, cells, leaf, stride)
                                      : square_values(p, subject.object, g.thin, leaf, leaf_level,
                                                      g.thin ? cells.first : square, level);
        if (level == leaf_level) {
            ASSERT_LE(cells.last.x - cells.first.x, stride);
            ASSERT_LE(cells.last.y - cells.first.y, stride);
        }
        const DisplacedBox box = displaced_box(
            g, middle, half_size,
            displacement_range(p, subject.object, values, leaf == kLeafBilinear && leaf_level == 0));
        const bool outside = outside_triangle(g, middle, half_size, 2e-5f);
        for (int i = 0; i < 30; ++i) {
            const dvec2 b = barycentrics();
            const dvec2 of_domain = dvec2(g.t0) + dvec2(g.t1) * b.x + dvec2(g.t2) * b.y,
                        place = (of_domain - dvec2(square)) / double(size);
            if (std::min(place.x, place.y) < 0 || std::max(place.x, place.y) > 1) continue;
            ++points;
            ASSERT_FALSE(outside);
            const dvec2 texel = dvec2(p.tx0) * (1 - b.x - b.y) + dvec2(p.tx1) * b.x + dvec2(p.tx2) * b.y;
            const bool square_is_leaf = level == leaf_level && leaf == kLeafBilinear && !g.thin;
            const dvec3 s = in_frame_of_triangle(surface(b, height(leaf, square, stride, square_is_leaf, texel)));
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(s, dvec3(box.low))) &&
                        glm::all(glm::lessThanEqual(s, dvec3(box.high))))
                << "level " << level << " leaf " << leaf << ": " << s.x << " " << s.y << " " << s.z << " box "
                << box.low.x << " " << box.low.y << " " << box.low.z << " to " << box.high.x << " "
                << box.high.y << " " << box.high.z;
        }
    }

    // Parts of a lattice whose finest ones are a unit of the domain's coordinates large.
    void check_part() {
        const Primitive& p = primitive_;
        const Domain g = make_domain(p, subject.normals, false, greatest_displacement(subject.object), 0);
        const double width = std::abs(double(cross2(g.t1, g.t2))) / std::max(length(g.t1), std::max(length(g.t2), length(g.t2 - g.t1)));
        if (!(width > 1e-3) || !(width * 4096 > double(length(g.high - g.low)))) return;  // the texels are walked in the lattice's stead
        const PrismAxes axes = prism_axes(g, {});
        const float size = std::ldexp(1.0f, whole(0, 5));
        const vec2 inside = vec2(barycentrics()), at = g.t0 + g.t1 * inside.x + g.t2 * inside.y;
        const vec2 from = floor(at / size) * size, to = from + vec2(size);
        const vec2 low = max(from - g.t0, g.low), high = min(to - g.t0, g.high);
        const bool cut = low != from - g.t0 || high != to - g.t0;
        const int side = cut ? 0 : whole(-1, 1);
        const double d0 = displacement(subject.object, float(real01())),
                     d1 = displacement(subject.object, float(real01()));
        const PartPrism prism = part_prism(g, axes, 0.5f * (low + high), 0.5f * (high - low), side,
                                           vec2(std::min(d0, d1), std::max(d0, d1)));
        for (int i = 0; i < 30; ++i) {
            const dvec2 b = barycentrics();
            const dvec2 texel = dvec2(g.t0) + dvec2(g.t1) * b.x + dvec2(g.t2) * b.y;
            const dvec2 f = (texel - dvec2(from)) / double(size);
            if (std::min(f.x, f.y) < 0 || std::max(f.x, f.y) > 1 || (f.x + f.y - 1) * side > 0) continue;
            ++points;
            const double d = d0 + real01() * (d1 - d0);
            const vec4 s = axes_of(g, in_frame_of_triangle(surface(b, subject.object.midlevel + d / subject.object.amplitude)));
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(s, prism.low)) && glm::all(glm::lessThanEqual(s, prism.high)))
                << "size " << size << " side " << side;
        }
    }

    int points = 0, thin = 0;

  private:
    static vec4 axes_of(const Domain& g, const dvec3& v) {
        return along_axes(edge_normal(g.py), edge_normal(g.px), edge_normal(g.px - g.py), vec3(v));
    }

    double real01() { return std::uniform_real_distribution<double>(0, 1)(random_); }
    double between(double a, double b) { return a + (b - a) * real01(); }
    int whole(int a, int b) { return std::uniform_int_distribution<int>(a, b)(random_); }
    dvec2 barycentrics() {
        dvec2 b(real01(), real01());
        if (whole(0, 3) == 0) b.x = 0;  // an edge
        return b.x + b.y > 1 ? 1.0 - b : b;
    }
    dvec3 direction() {
        for (;;) {
            const dvec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
            if (glm::length(v) > 0.1 && glm::length(v) < 1) return glm::normalize(v);
        }
    }

    void make_map() {
        map_.width = whole(1, 40);
        map_.height = whole(1, 40);
        const bool cliffs = whole(0, 2) == 0;
        for (int i = 0; i < map_.width * map_.height; ++i)
            map_.texels.push_back(static_cast<std::uint16_t>(cliffs ? 65535 * whole(0, 1) : whole(0, 65535)));
        wrap_ = whole(0, 1) == 0 ? Wrap::repeat : Wrap::clamp;
        pyramid_.emplace(map_.view(), wrap_);
        subject.map = &map_;
        subject.pyramid = &*pyramid_;
        subject.object = {};
        subject.object.amplitude = static_cast<float>(between(-2, 2) * std::pow(10.0, between(-4, 1)));
        subject.object.midlevel = static_cast<float>(real01());
        subject.object.map_size = {map_.width, map_.height};
        subject.object.clamp_wrap = wrap_ == Wrap::clamp ? 1 : 0;
    }

    void make_triangle() {
        for (;;) {
            MeshFile file;
            const dvec3 at = direction() * between(0, 100);
            const double size = std::pow(10.0, between(-2, 2)), lean = between(0, 1.5),
                         texels = std::pow(2.0, between(-2, 6));
            // Every fourth triangle is thin in texture space: down to a line or a point.
            const double narrow = whole(0, 3) > 0 ? 1 : whole(0, 2) * std::pow(10.0, between(-7, -1));
            const dvec2 along(between(-1, 1), between(-1, 1)), across(-along.y, along.x);
            for (int i = 0; i < 3; ++i) {
                file.positions.push_back(at + direction() * size);
                const dvec2 uv = along * between(-1, 1) + across * (narrow * between(-1, 1));
                file.uvs.push_back(uv * texels / dvec2(map_.width, map_.height));
            }
            const dvec3 ng =
                glm::cross(file.positions[1] - file.positions[0], file.positions[2] - file.positions[0]);
            for (int i = 0; i < 3; ++i)
                file.file_normals.push_back(glm::normalize(glm::normalize(ng) + direction() * lean));
            file.faces = {{{0, 1, 2}, {0, 1, 2}}};
            const Mesh mesh = make_mesh(file, glm::dmat4(1), dvec3(0), true);
            auto p = make_primitive(mesh, 0, 0, {{map_.width, map_.height}, wrap_ == Wrap::clamp});
            if (!p) continue;
            primitive_ = *p;
            subject.normals = relievo::primitive_normals(mesh, 0);
            const double a = subject.object.amplitude, m = subject.object.midlevel;
            set_shell(primitive_, subject.normals,
                      {std::min(-a * m, a * (1 - m)), std::max(-a * m, a * (1 - m))});
            return;
        }
    }

    // In double; a B-spline by its control points' hull, over the leaf that holds the texel.
    double height(float leaf, vec2 square, float stride, bool square_is_leaf, dvec2 texel) {
        if (!square_is_leaf) {
            const vec2 base = primitive_base(primitive_);
            square = floor(vec2(dvec2(base) + texel) / stride) * stride - base;
        }
        const vec2 f = clamp((vec2(texel) - square) / stride, vec2(0), vec2(1));
        for (int i = 0; i < piece_count(leaf); ++i) {
            const Piece e = make_piece(primitive_, leaf, square, stride, i);
            const vec2 in = leaf == kLeafBspline ? f + vec2(0.5f) - vec2(float(i & 1), float(i >> 1)) : f;
            const float slack = i + 1 < piece_count(leaf) ? 0 : 1e-5f;
            if (in_piece(e, in, vec2(slack), slack)) return piece_value(e, in);
        }
        ADD_FAILURE() << "no piece holds its square's point";
        return 0;
    }

    dvec3 surface(dvec2 b, double value) const {
        const PrimitiveNormals& n = subject.normals;
        const dvec3 normal = dvec3(n.n0) * (1 - b.x - b.y) + dvec3(n.n1) * b.x + dvec3(n.n2) * b.y;
        const dvec3 tangent(primitive_.tangent), bitangent = glm::cross(dvec3(primitive_.ng), tangent);
        return tangent * (double{primitive_.q1x} * b.x + double{primitive_.q2.x} * b.y) +
               bitangent * (double{primitive_.q2.y} * b.y) +
               glm::normalize(normal) *
                   (double{subject.object.amplitude} * (value - double{subject.object.midlevel}));
    }
    dvec3 in_frame_of_triangle(dvec3 v) const {
        const dvec3 tangent(primitive_.tangent), ng(primitive_.ng);
        return {glm::dot(v, tangent), glm::dot(v, glm::cross(ng, tangent)), glm::dot(v, ng)};
    }

    std::mt19937 random_;
    test::TestMap map_;
    Wrap wrap_ = Wrap::repeat;
    std::optional<HeightPyramid> pyramid_;
    Primitive primitive_{};
};

class DbvhBounds : public testing::TestWithParam<float> {};

TEST_P(DbvhBounds, HoldEveryPointOfTheSurface) {
    int points = 0, thin = 0;
    for (unsigned seed = 0; seed < 20000; ++seed) {
        Trial trial(seed);
        for (int i = 0; i < 4; ++i) trial.check_square(GetParam());
        points += trial.points;
        thin += trial.thin;
        ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
    EXPECT_GT(points, 100000);
    EXPECT_GT(thin, 5000);
}

TEST(DbvhPartPrisms, HoldEveryPointOfTheSurface) {
    int points = 0;
    for (unsigned seed = 0; seed < 20000; ++seed) {
        Trial trial(seed);
        for (int i = 0; i < 4; ++i) trial.check_part();
        points += trial.points;
        ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
    EXPECT_GT(points, 100000);
}

INSTANTIATE_TEST_SUITE_P(Leaves, DbvhBounds, testing::Values(kLeafTriangles, kLeafBilinear, kLeafBspline));

}  // namespace
}  // namespace relievo::dbvh::bounds_test
