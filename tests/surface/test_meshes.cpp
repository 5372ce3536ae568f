#include "test_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "brushes/seam_bends.h"

namespace relievo::test {

void MeshBuilder::triangle(const Corner& a, const Corner& b, const Corner& c) {
    triangles_.push_back({a, b, c});
}

void MeshBuilder::quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

Mesh MeshBuilder::build() const {
    Mesh mesh;
    std::map<std::tuple<float, float, float>, std::uint32_t> known;
    for (const auto& corners : triangles_) {
        Mesh::Face face{};
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 p = corners[i].position;
            const auto [at, fresh] =
                known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(mesh.positions.size()));
            if (fresh) mesh.positions.push_back(p);
            face.position[i] = at->second;
            face.uv[i] = static_cast<std::uint32_t>(mesh.uvs.size());
            mesh.uvs.push_back(corners[i].uv);
        }
        mesh.faces.push_back(face);
    }
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
    for (const Mesh::Face& f : mesh.faces) {
        const glm::dvec3 a(mesh.positions[f.position[0]]), b(mesh.positions[f.position[1]]),
            c(mesh.positions[f.position[2]]);
        for (const std::uint32_t p : f.position) sums[p] += glm::cross(b - a, c - a);
    }
    for (const glm::dvec3& sum : sums) {
        const double length = glm::length(sum);
        mesh.normals.push_back(length > 0 ? glm::vec3(sum / length) : glm::vec3(0, 0, 1));
    }
    return mesh;
}

Mesh plane() {
    MeshBuilder builder;
    builder.quad({{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {1, 0}}, {{1, 1, 0}, {1, 1}}, {{0, 1, 0}, {0, 1}});
    return builder.build();
}

Mesh box_sphere(int a, int b, int c, unsigned order) {
    struct Side {
        glm::ivec3 corner, right, up;  // in cells; right x up points outward
        int w, h;
    };
    const std::array<Side, 6> sides{{{{0, 0, c}, {1, 0, 0}, {0, 1, 0}, a, b},
                                     {{0, b, 0}, {1, 0, 0}, {0, -1, 0}, a, b},
                                     {{a, 0, 0}, {0, 1, 0}, {0, 0, 1}, b, c},
                                     {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, c, b},
                                     {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, a, c},
                                     {{0, b, 0}, {0, 0, 1}, {1, 0, 0}, c, a}}};
    std::array<std::size_t, 6> places{0, 1, 2, 3, 4, 5};
    std::mt19937 random = generator(order);
    if (order != 0) std::shuffle(places.begin(), places.end(), random);
    // The places are 1/4 x 3/8 of the map each; a cell is 1/64 of the map or less, in powers of two.
    const int most = std::max({a, b, c});
    const float cell = most <= 8 ? 1.0f / 64 : 1.0f / 128;
    MeshBuilder builder;
    for (std::size_t s = 0; s < 6; ++s) {
        const Side& side = sides[s];
        const glm::vec2 origin(0.0625f + 0.3125f * static_cast<float>(places[s] % 3),
                               0.0625f + 0.5f * static_cast<float>(places[s] / 3));
        const unsigned turn = order == 0 ? 0 : static_cast<unsigned>(random() % 8);
        const auto corner = [&](int i, int j) {
            const glm::vec3 at(side.corner + side.right * i + side.up * j);
            const glm::vec3 cube =
                at / glm::vec3(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c));
            glm::ivec2 t(i, j);
            if (turn & 1) t = {side.h - t.y, t.x};
            if (turn & 2) t = {(turn & 1 ? side.h : side.w) - t.x, t.y};
            if (turn & 4) t = {t.x, (turn & 1 ? side.w : side.h) - t.y};
            return MeshBuilder::Corner{glm::normalize(cube * 2.0f - 1.0f), origin + glm::vec2(t) * cell};
        };
        for (int j = 0; j < side.h; ++j) {
            for (int i = 0; i < side.w; ++i) {
                builder.quad(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
            }
        }
    }
    return builder.build();
}

Mesh turned_box_sphere(int n) {
    Mesh mesh = box_sphere(n, n, n);
    const std::size_t corners = mesh.uvs.size() / 6;  // of an island: each triangle has its own
    for (std::size_t island = 0; island < 6; ++island) {
        glm::vec2 low = mesh.uvs[island * corners], high = low;
        for (std::size_t i = island * corners; i < (island + 1) * corners; ++i) {
            low = glm::min(low, mesh.uvs[i]);
            high = glm::max(high, mesh.uvs[i]);
        }
        const glm::vec2 centre = (low + high) * 0.5f;
        const float angle = 0.3f + 1.1f * static_cast<float>(island);
        const float grow = 1.2f + 0.08f * static_cast<float>(island), c = grow * std::cos(angle),
                    s = grow * std::sin(angle);
        for (std::size_t i = island * corners; i < (island + 1) * corners; ++i) {
            const glm::vec2 d = mesh.uvs[i] - centre;
            mesh.uvs[i] = centre + glm::vec2(c * d.x - s * d.y, s * d.x + c * d.y);
        }
    }
    return mesh;
}

Mesh cut_strip(double turn, double scale) {
    MeshBuilder builder;
    const auto left = [](float x, float y) {
        return MeshBuilder::Corner{{x, y, 0}, glm::vec2(0.125f + 0.25f * x, 0.25f + 0.25f * y)};
    };
    const auto right = [&](float x, float y) {
        const double c = std::cos(turn) * 0.25 * scale, s = std::sin(turn) * 0.25 * scale;
        const double dx = static_cast<double>(x) - 1, dy = static_cast<double>(y);
        return MeshBuilder::Corner{{x, y, 0}, glm::vec2(0.625 + c * dx - s * dy, 0.25 + s * dx + c * dy)};
    };
    builder.quad(left(0, 0), left(1, 0), left(1, 1), left(0, 1));
    builder.quad(right(1, 0), right(2, 0), right(2, 1), right(1, 1));
    return builder.build();
}

Mesh cut_cylinder(int cells) {
    MeshBuilder builder;
    const auto corner = [&](int i, int j) {
        const float angle = 6.2831853f * static_cast<float>(i % cells) / static_cast<float>(cells);
        return MeshBuilder::Corner{{std::cos(angle), std::sin(angle), static_cast<float>(j)},
                                   {0.125f + 0.75f * static_cast<float>(i) / static_cast<float>(cells),
                                    0.25f + 0.25f * static_cast<float>(j)}};
    };
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < cells; ++i) {
            builder.quad(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
    }
    return builder.build();
}

Mesh globe(int around, int along) {
    MeshBuilder builder;
    const auto corner = [&](float column, int row) {
        const float turn = 6.2831853f *
                           (row == 0 || row == along ? 0 : std::fmod(column, static_cast<float>(around))) /
                           static_cast<float>(around),
                    rise = 3.14159265f * static_cast<float>(row) / static_cast<float>(along);
        const float out = row == 0 || row == along ? 0 : std::sin(rise);
        return MeshBuilder::Corner{{-out * std::sin(turn), -std::cos(rise), -out * std::cos(turn)},
                                   {column / static_cast<float>(around),
                                    0.25f + 0.5f * static_cast<float>(row) / static_cast<float>(along)}};
    };
    for (int i = 0; i < around; ++i) {
        const auto c = static_cast<float>(i);
        builder.triangle(corner(c + 0.5f, 0), corner(c + 1, 1), corner(c, 1));
        builder.triangle(corner(c, along - 1), corner(c + 1, along - 1), corner(c + 0.5f, along));
        for (int row = 1; row + 1 < along; ++row)
            builder.quad(corner(c, row), corner(c + 1, row), corner(c + 1, row + 1), corner(c, row + 1));
    }
    return builder.build();
}

std::mt19937 generator(unsigned seed) {
    return std::mt19937(seed);
}

HeightMap random_map(int width, int height, unsigned seed) {
    HeightMap map(width, height);
    std::mt19937 random = generator(seed);
    for (std::uint16_t& texel : map.texels()) texel = static_cast<std::uint16_t>(random() & 0xFFFF);
    return map;
}

void set_owned(HeightMap& map, const MeshSurface& surface,
               const std::function<double(const glm::dvec3&)>& counts) {
    std::vector<SurfaceTexel> texels;
    surface.precise_texels_in_ball(glm::vec3(0), 10, texels);
    for (const SurfaceTexel& t : texels)
        map.set(t.x, t.y, static_cast<std::uint16_t>(std::lround(counts(glm::dvec3(t.position)))));
}

HeightMap with_copies_alone(HeightMap map, const SeamTable& table) {
    for (const SeamCopy& copy : table.copies) map.texels()[copy.gutter] = map.texels()[copy.source];
    return map;
}

void fill_gutters(HeightMap& map, const SeamTable& table) {
    map = with_copies_alone(std::move(map), table);
    SeamBends(table, map.width(), map.height()).apply(map);
}

Displacement displacement(double amplitude, double midlevel, Wrap wrap) {
    Displacement d;
    d.amplitude = amplitude;
    d.midlevel = midlevel;
    d.wrap = wrap;
    return d;
}

}  // namespace relievo::test
