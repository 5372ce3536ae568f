// Close bounds hold S: no sampled point of a triangle's part leaves its box, hull or plane, whatever the map, and on smooth
// maps they are as narrow as it. So do slanted prisms, which are made of them.
#include "renderer/close_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <random>
#include <string>
#include <vector>

#include "renderer/slant.h"
#include "tests/support/scenes.h"

namespace relievo::test::close_bounds_test {
namespace {

using glm::dvec2;
using glm::dvec3;

struct TestMap {
    std::string name;
    int width, height;
    Wrap wrap;
    std::vector<std::uint16_t> texels;
    HeightView view() const { return {width, height, texels.data()}; }

    double texel(double x, double y) const {
        const auto inside = [&](double at, int size) {
            if (wrap == Wrap::clamp) return static_cast<std::size_t>(std::clamp(at, 0.0, size - 1.0));
            return static_cast<std::size_t>(at - size * std::floor(at / size));
        };
        return texels[inside(y, height) * static_cast<std::size_t>(width) + inside(x, width)];
    }
    double at(const dvec2& uv) const {
        const dvec2 t = uv * dvec2(width, height) - 0.5, cell = glm::floor(t), f = t - cell;
        return glm::mix(glm::mix(texel(cell.x, cell.y), texel(cell.x + 1, cell.y), f.x),
                        glm::mix(texel(cell.x, cell.y + 1), texel(cell.x + 1, cell.y + 1), f.x), f.y);
    }
};

std::vector<TestMap> maps() {
    std::vector<TestMap> all;
    std::mt19937 rng(5);
    for (const auto& [w, h] : {std::pair{1, 1}, {3, 5}, {64, 64}, {300, 7}, {517, 260}}) {
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
            TestMap noise{"noise", w, h, wrap, {}}, smooth{"smooth", w, h, wrap, {}}, cliff{"cliff", w, h, wrap, {}};
            for (int y = 0; y < h; ++y) {
                for (int x = 0; x < w; ++x) {
                    noise.texels.push_back(static_cast<std::uint16_t>(rng()));
                    smooth.texels.push_back(
                        static_cast<std::uint16_t>(32768 + 20000 * std::sin(6.2832 * x / w) * std::cos(6.2832 * y / h)));
                    cliff.texels.push_back(x / 2 % 2 == 0 ? 0 : 65535);
                }
            }
            for (TestMap* m : {&noise, &smooth, &cliff}) {
                m->name += " " + std::to_string(w) + (wrap == Wrap::clamp ? " clamp" : " repeat");
                all.push_back(std::move(*m));
            }
        }
    }
    return all;
}

// `bend`: how far vertex normals lean; `reach`: what the triangle spans of the map's width.
Mesh random_triangle(std::mt19937& rng, double bend, double reach, const TestMap& map) {
    std::uniform_real_distribution<double> u(-1, 1);
    MeshFile m;
    for (int i = 0; i < 3; ++i) m.positions.push_back({u(rng), u(rng), u(rng)});
    const dvec3 ng = glm::normalize(glm::cross(m.positions[1] - m.positions[0], m.positions[2] - m.positions[0]));
    for (int i = 0; i < 3; ++i) m.file_normals.push_back(glm::normalize(ng + dvec3(u(rng), u(rng), u(rng)) * bend));
    const dvec2 centre(2 * u(rng), 2 * u(rng));
    for (int i = 0; i < 3; ++i)
        m.uvs.push_back(centre + dvec2(u(rng), u(rng) * static_cast<double>(map.width) / map.height) * reach);
    m.faces = {{{0, 1, 2}, {0, 1, 2}}};
    return make_mesh(m, glm::dmat4(1), {}, true);
}

struct Bounded {
    Mesh mesh;
    gpu::Primitive primitive;
    std::array<glm::vec2, 3> uvs;
    DisplacementRange range;
    double amplitude, midlevel;

    Bounded(Mesh given, const TestMap& map, double a, double m)
        : mesh(std::move(given)), uvs{mesh.uvs[0], mesh.uvs[1], mesh.uvs[2]}, amplitude(a), midlevel(m) {
        primitive = make_primitive(mesh, 0, 0, {{map.width, map.height}, map.wrap == Wrap::clamp}).value();
        range = {std::min(-a * m, a * (1 - m)), std::max(-a * m, a * (1 - m))};
        set_shell(primitive, primitive_normals(mesh, 0), range);
    }
    MappedTriangle triangle() const { return {primitive, primitive_normals(mesh, 0), uvs, range}; }

    struct Point {
        dvec3 position;
        double count;
    };
    Point at(const TestMap& map, const dvec3& b) const {
        dvec3 position(0), normal(0);
        dvec2 uv(0);
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            position += b[i] * dvec3(mesh.positions[mesh.faces[0].position[k]]);
            normal += b[i] * dvec3(mesh.normals[mesh.faces[0].position[k]]);
            uv += b[i] * dvec2(uvs[k]);
        }
        const double count = map.at(uv);
        return {position + amplitude * (count / 65535 - midlevel) * glm::normalize(normal), count};
    }
};

// Inside, on edges and at corners.
dvec3 random_place(std::mt19937& rng, int i) {
    std::uniform_real_distribution<double> u(0, 1);
    dvec3 b(u(rng), u(rng), u(rng));
    if (i % 4 == 1) b[i / 4 % 3] = 0;
    if (i % 16 == 2) b = dvec3(0), b[i / 16 % 3] = 1;
    return b / (b.x + b.y + b.z);
}

// Height over the planes at the prism's ends, as shaders/geometry/prism.glsl has it.
double over_ends(const gpu::Primitive& p, const dvec3& position) {
    const auto flags = static_cast<std::int32_t>(p.flags);
    const double x = (flags << (32 - gpu::kSlantShiftY) >> gpu::kSlantShiftY) * double{gpu::kSlantStep};
    const double y = (flags >> gpu::kSlantShiftY) * double{gpu::kSlantStep};
    const dvec3 from = position - dvec3(p.origin), bitangent = glm::cross(dvec3(p.ng), dvec3(p.tangent));
    return glm::dot(from, dvec3(p.ng)) - x * glm::dot(from, dvec3(p.tangent)) - y * glm::dot(from, bitangent);
}

TEST(CloseBounds, HoldEveryPointOfTheSurface) {
    std::mt19937 rng(11);
    std::uniform_real_distribution<double> u(0, 1);
    int planes = 0, slanted = 0;
    for (const TestMap& map : maps()) {
        const HeightPyramid pyramid(map.view(), map.wrap);
        for (const double reach : {0.004, 0.03, 0.2, 1.3}) {
            for (int round = 0; round < 12; ++round) {
                SCOPED_TRACE(map.name + " " + std::to_string(reach) + " " + std::to_string(round));
                const Bounded t(random_triangle(rng, round % 3 * 0.4, reach, map), map, round % 2 == 0 ? 0.3 : -1.5, u(rng));
                const MapSurface surface{map.view(), pyramid, t.amplitude, t.midlevel};
                const CloseBounds bounds = close_bounds(t.triangle(), surface);
                const Box box = box_within(bounds, t.triangle());
                const SurfaceHull hull = hull_within(bounds, t.triangle(), surface);
                const dvec3 direction(u(rng) - 0.5, u(rng) - 0.5, u(rng) - 0.5), origin(0.3, -2, 1);
                const Extent extent = extent_along(hull, direction, origin);
                planes += bounds.plane ? 1 : 0;
                const gpu::Primitive lower = with_slant(t.triangle(), hull);
                slanted += is_slanted(lower) ? 1 : 0;
                EXPECT_FALSE(is_slanted(lower) && (lower.flags & (gpu::kPrimitiveFolded | gpu::kPrimitiveSearched)) != 0);
                for (int i = 0; i < 200; ++i) {
                    const dvec3 b = random_place(rng, i);
                    const auto point = t.at(map, b);
                    for (int k = 0; k < 3; ++k) {
                        ASSERT_GE(point.position[k], double{box.low[k]});
                        ASSERT_LE(point.position[k], double{box.high[k]});
                    }
                    const double along = glm::dot(point.position - origin, direction);
                    ASSERT_GE(along, extent.low);
                    ASSERT_LE(along, extent.high);
                    if (is_slanted(lower)) {
                        ASSERT_GT(over_ends(lower, point.position), double{lower.w_low});
                        ASSERT_LT(over_ends(lower, point.position), double{lower.w_high});
                    }
                    if (!bounds.plane) continue;
                    const auto& c = bounds.plane->corner;
                    const double over = point.count - (b.x * c[0] + b.y * c[1] + b.z * c[2]);
                    ASSERT_GE(over, bounds.plane->low);
                    ASSERT_LE(over, bounds.plane->high);
                }
            }
        }
    }
    EXPECT_GT(planes, 200);
    EXPECT_GT(slanted, 40);
}

double area(const Box& b) {
    const dvec3 d = dvec3(b.high) - dvec3(b.low);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

TEST(CloseBounds, AreAsNarrowAsASmoothSurface) {
    TestMap map{"ramps", 256, 256, Wrap::repeat, {}};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            map.texels.push_back(
                static_cast<std::uint16_t>(32768 + 15000 * std::sin(x * 0.1) + 15000 * std::sin(y * 0.13)));
    const HeightPyramid pyramid(map.view(), map.wrap);
    std::mt19937 rng(3);
    for (const double reach : {0.03, 0.24}) {  // texel by texel along its sides, and by whole texels
        double bounded = 0, sampled = 0, by_range = 0;
        for (int round = 0; round < 60; ++round) {
            Mesh mesh = random_triangle(rng, 0.03, reach, map);
            mesh.uvs[1] = mesh.uvs[0] + glm::vec2(0.9f, 0.2f) * static_cast<float>(reach);  // no slivers in the map
            mesh.uvs[2] = mesh.uvs[0] + glm::vec2(0.1f, 0.8f) * static_cast<float>(reach);
            const Bounded t(std::move(mesh), map, 1, 0.5);
            const MapSurface surface{map.view(), pyramid, t.amplitude, t.midlevel};
            double low = 1, high = 0;
            Box box{glm::vec3(1e30f), glm::vec3(-1e30f)};
            for (int i = 0; i <= 40; ++i) {
                for (int j = 0; i + j <= 40; ++j) {
                    const auto point = t.at(map, dvec3(40 - i - j, i, j) / 40.0);
                    box = {glm::min(box.low, glm::vec3(point.position)), glm::max(box.high, glm::vec3(point.position))};
                    low = std::min(low, point.count / 65535);
                    high = std::max(high, point.count / 65535);
                }
            }
            sampled += area(box);
            bounded += area(close_bounds(t.triangle(), surface).box.value());
            by_range += area(surface_box(t.primitive, primitive_normals(t.mesh, 0), {low - 0.5, high - 0.5}));
        }
        EXPECT_LT(bounded, sampled * (reach < 0.1 ? 1.02 : 1.1)) << reach;
        EXPECT_LT(bounded, by_range * 0.9) << reach << " " << by_range / sampled;
    }
}

TEST(CloseBounds, TrianglesWithoutAreaInTheMapHaveNone) {
    const TestMap map = maps()[13];
    const HeightPyramid pyramid(map.view(), map.wrap);
    std::mt19937 rng(9);
    Mesh mesh = random_triangle(rng, 0.2, 0.1, map);
    const Bounded whole(mesh, map, 1, 0.5);
    const MapSurface surface{map.view(), pyramid, 1, 0.5};
    for (const std::array<glm::vec2, 3>& uvs :
         {std::array<glm::vec2, 3>{glm::vec2(0.5f), glm::vec2(0.5f), glm::vec2(0.5f)},
          {glm::vec2(0.1f), glm::vec2(0.2f), glm::vec2(0.4f)},
          {glm::vec2(1e20f, 0), glm::vec2(1e20f, 1), glm::vec2(0)}}) {
        const MappedTriangle triangle{whole.primitive, primitive_normals(mesh, 0), uvs, whole.range};
        const CloseBounds bounds = close_bounds(triangle, surface);
        const Box box = box_within(bounds, triangle);
        for (int k = 0; k < 3; ++k) EXPECT_LE(box.low[k], box.high[k]);
    }
}

}  // namespace
}  // namespace relievo::test::close_bounds_test
