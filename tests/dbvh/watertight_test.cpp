// No ray passes through a closed mesh: rays at its vertices, at its edges and at the borders of texels, for
// every leaf.
#include <gtest/gtest.h>

#include <random>

#include "tests/dbvh/dbvh_shader.h"

namespace relievo::dbvh::watertight_test {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTube = 0.5, kRing = 2;  // radii of the torus

// A torus whose texture repeats both ways: no seam, no pole, so that S is closed whatever the map.
MeshFile torus_mesh(int around, int across) {
    MeshFile m;
    const double turn = 2 * std::acos(-1.0);
    for (int a = 0; a <= around; ++a) {
        for (int c = 0; c <= across; ++c) {
            const double phi = turn * (a % around) / around, theta = turn * (c % across) / across;
            const double r = kRing + kTube * std::cos(theta);
            if (a < around && c < across)
                m.positions.push_back({r * std::cos(phi), r * std::sin(phi), kTube * std::sin(theta)});
            m.uvs.push_back({double(a) / around, double(c) / across});
        }
    }
    const auto face = [&](int a0, int c0, int a1, int c1, int a2, int c2) {
        const auto position = [&](int a, int c) {
            return static_cast<std::uint32_t>(a % around * across + c % across);
        };
        const auto uv = [&](int a, int c) { return static_cast<std::uint32_t>(a * (across + 1) + c); };
        m.faces.push_back(
            {{position(a0, c0), position(a1, c1), position(a2, c2)}, {uv(a0, c0), uv(a1, c1), uv(a2, c2)}});
    };
    for (int a = 0; a < around; ++a) {
        for (int c = 0; c < across; ++c) {
            face(a, c, a + 1, c, a + 1, c + 1);
            face(a, c, a + 1, c + 1, a, c + 1);
        }
    }
    return m;
}

struct Closed {
    Mesh mesh;
    test::TestMap map;
    std::optional<HeightPyramid> pyramid;
    std::vector<Primitive> primitives;
    std::vector<PrimitiveNormals> normals;

    Closed(int around, int across, int width, int height, unsigned seed) {
        std::mt19937 random(seed);
        mesh = make_mesh(torus_mesh(around, across), glm::dmat4(1), dvec3(0), false);
        map = test::make_map(width, height, [&](double, double) { return double(random() % 1000) / 999; });
        pyramid.emplace(map.view(), Wrap::repeat);
        subject.map = &map;
        subject.pyramid = &*pyramid;
        subject.object = {};
        subject.object.amplitude = 0.4f;
        subject.object.midlevel = 0.5f;
        subject.object.map_size = {width, height};
        for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
            auto p = make_primitive(mesh, i, 0, {{width, height}, false});
            if (!p) continue;
            primitives.push_back(*p);
            normals.push_back(relievo::primitive_normals(mesh, i));
            set_shell(primitives.back(), normals.back(), {-0.2, 0.2});
        }
    }

    bool hit(vec4 parameters, vec3 o, vec3 d, float t_max) const {
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            subject.normals = normals[i];
            SurfaceHit found;
            if (intersect_surface(primitives[i], subject.object, parameters, o, d, 0, t_max, 0, found))
                return true;
        }
        return false;
    }
};

// A place on a triangle that more than one piece of surface claims: a vertex, an edge, a texel's border.
vec2 shared_place(const Primitive& p, std::mt19937& random) {
    const auto unit = [&] { return static_cast<float>(random() % 4096) / 4096; };
    vec2 b(unit(), unit());
    if (b.x + b.y > 1) b = vec2(1) - b;
    const unsigned kind = random() % 4;
    if (kind == 0) return random() % 2 ? vec2(0) : vec2(1, 0);
    if (kind == 1) return random() % 2 ? vec2(b.x, 0) : vec2(b.x, 1 - b.x);
    // Along b.x to where the texel coordinate is whole, and there along the border to the crossing of two.
    const vec2 t1 = p.tx1 - p.tx0, t2 = p.tx2 - p.tx0, texel = texel_at(p, b);
    const vec2 to =
        glm::round(texel) - (kind == 2 ? vec2(0, glm::round(texel).y - texel.y) : vec2(0)) - p.tx0;
    const float area = cross2(t1, t2);
    return vec2(cross2(to, t2), cross2(t1, to)) / area;
}

class DbvhWatertight : public testing::TestWithParam<std::tuple<float, int>> {};

TEST_P(DbvhWatertight, NoRayPassesThroughAClosedMesh) {
    const auto [leaf, level] = GetParam();
    std::mt19937 random(7);
    for (const glm::ivec2 size : {glm::ivec2(16, 8), glm::ivec2(52, 28), glm::ivec2(54, 30), glm::ivec2(13, 7)}) {
        const Closed closed(9, 6, size.x, size.y, 3);
        int passed = 0;
        for (int i = 0; i < 3000; ++i) {
            const std::size_t k = random() % closed.primitives.size();
            const Primitive& p = closed.primitives[k];
            const vec2 b = shared_place(p, random);
            const vec3 at = surface_point(p, closed.normals[k], subject.object, b);
            if (!within_edges(b, vec3(0))) continue;
            // From outside towards the middle of the tube.
            const vec3 middle = normalize(vec3(at.x, at.y, 0)) * float(kRing);
            const vec3 aside = vec3(random() % 100, random() % 100, random() % 100) * 1e-3f - vec3(0.05f);
            const vec3 o = middle + normalize(at - middle) * (i % 2 ? 1.3f : 20.0f) + aside,
                       d = normalize(at - o);
            if (!closed.hit(vec4(leaf, float(level), 0, 1), o, d, length(middle - o))) ++passed;
        }
        EXPECT_EQ(passed, 0) << size.x << " x " << size.y;
    }
}

INSTANTIATE_TEST_SUITE_P(Leaves, DbvhWatertight,
                         testing::Combine(testing::Values(kLeafBox, kLeafTriangles, kLeafBilinear,
                                                          kLeafBspline),
                                          testing::Values(0, 1, 2)));

}  // namespace
}  // namespace relievo::dbvh::watertight_test
