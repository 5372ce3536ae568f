// Leaves shade as what they are: two triangles a square are flat, a B-spline is smooth, bilinear leaves have S's normal.
#include <gtest/gtest.h>

#include "tests/dbvh/dbvh_shader.h"

namespace relievo::dbvh::normals_test {
namespace {

constexpr int kTexels = 16;

class LeafNormals : public testing::Test {
  protected:
    LeafNormals()
        : map_(test::bumps(kTexels)), pyramid_(map_.view(), Wrap::repeat),
          mesh_(make_mesh(test::plane_mesh(), glm::dmat4(1), glm::dvec3(0), true)) {
        subject.map = &map_;
        subject.pyramid = &pyramid_;
        subject.object = {};
        subject.object.amplitude = 0.4f;
        subject.object.midlevel = 0.5f;
        subject.object.map_size = {kTexels, kTexels};
        const auto p = make_primitive(mesh_, 0, 0, {{kTexels, kTexels}, false});
        primitive_ = *p;
        subject.normals = relievo::primitive_normals(mesh_, 0);
    }
    // At texel coordinates relative to the primitive's base.
    vec3 normal(float leaf, float level, vec2 x) const {
        const Domain g = make_domain(primitive_, subject.normals, false, 1, 0);
        return shading_normal(primitive_, subject.normals, subject.object, vec4(leaf, level, 0, 0),
                              barycentrics_at(g, x - primitive_.tx0));
    }
    float value(float leaf, float stride, vec2 x) const {
        const vec2 base = primitive_base(primitive_), square = floor((base + x) / stride) * stride - base;
        const vec2 f = (x - square) / stride;
        const int index = leaf == kLeafBspline ? (f.x > 0.5f) + 2 * (f.y > 0.5f) : f.x + f.y > 1;
        const Piece e = make_piece(primitive_, leaf, square, stride, index);
        return piece_value(e, (x - e.origin) / stride);
    }
    // Of the height field over the flat square, from differences of the leaf's own heights.
    vec3 by_differences(float leaf, float stride, vec2 x) const {
        constexpr float kStep = 1e-2f;
        const float per_texel = subject.object.amplitude / (2 * kStep) / (2.0f / kTexels);
        const auto slope = [&](vec2 step) {
            return (value(leaf, stride, x + step) - value(leaf, stride, x - step)) * per_texel;
        };
        return normalize(vec3(-slope(vec2(kStep, 0)), 1, slope(vec2(0, kStep))));  // u along +x, v along -z
    }

    test::TestMap map_;
    HeightPyramid pyramid_;
    Mesh mesh_;
    Primitive primitive_{};
};

// Corner of a square of 4 texels inside the first triangle, which lies below the diagonal.
vec2 square_in(const Primitive& p) {
    const vec2 base = primitive_base(p);
    return vec2(12, 4) - base;
}

TEST_F(LeafNormals, TrianglesAreFlatAndDifferAcrossTheirDiagonal) {
    for (const float level : {0.0f, 1.0f, 2.0f}) {
        const float stride = std::ldexp(1.0f, static_cast<int>(level));
        const vec2 corner = square_in(primitive_);
        const vec3 first = normal(kLeafTriangles, level, corner + stride * vec2(0.1f, 0.2f));
        const vec3 same = normal(kLeafTriangles, level, corner + stride * vec2(0.6f, 0.3f));
        const vec3 other = normal(kLeafTriangles, level, corner + stride * vec2(0.8f, 0.7f));
        EXPECT_LT(length(first - same), 1e-5f) << level;
        EXPECT_GT(length(first - other), 1e-3f) << level;
        EXPECT_LT(length(first - by_differences(kLeafTriangles, stride, corner + stride * vec2(0.3f, 0.3f))), 1e-3f);
        EXPECT_LT(length(other - by_differences(kLeafTriangles, stride, corner + stride * vec2(0.8f, 0.7f))), 1e-3f);
    }
}

TEST_F(LeafNormals, BSplinesAreSmoothAndFollowTheirOwnSlope) {
    for (const float level : {0.0f, 1.0f}) {
        const float stride = std::ldexp(1.0f, static_cast<int>(level));
        const vec2 corner = square_in(primitive_);
        for (const float at : {0.0f, 0.5f, 1.0f}) {  // between squares, and between the pieces of one
            const vec2 x = corner + stride * vec2(at, 0.3f), step(1e-3f, 0);
            EXPECT_LT(length(normal(kLeafBspline, level, x - step) - normal(kLeafBspline, level, x + step)), 4e-3f);
        }
        const vec2 x = corner + stride * vec2(0.3f, 0.8f);
        EXPECT_LT(length(normal(kLeafBspline, level, x) - by_differences(kLeafBspline, stride, x)), 1e-3f);
    }
}

TEST_F(LeafNormals, BilinearLeavesHaveThatOfTheSurface) {
    const Domain g = make_domain(primitive_, subject.normals, false, 1, 0);
    const vec2 x = square_in(primitive_) + vec2(0.3f, 0.4f);
    const vec3 n = displaced_normal(primitive_, subject.normals, subject.object,
                                    barycentrics_at(g, x - primitive_.tx0), false);
    EXPECT_EQ(normal(kLeafBilinear, 0, x), n);
}

}  // namespace
}  // namespace relievo::dbvh::normals_test
