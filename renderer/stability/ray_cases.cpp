// Cases of single rays: along the surface, along prisms' sides, through edges and vertices exactly, starting
// inside, on and below the surface.
#include <glm/geometric.hpp>

#include "renderer/stability/case_parts.h"

namespace relievo::stability {
namespace {

using glm::dvec3;

Ray ray_of(const dvec3& origin, const dvec3& direction) {
    return {glm::vec3(origin), glm::vec3(glm::normalize(direction))};
}

dvec3 position(const Mesh& mesh, std::uint32_t corner) {
    return dvec3(mesh.positions[corner]);
}
dvec3 normal(const Mesh& mesh, std::uint32_t corner) {
    return dvec3(mesh.normals[corner]);
}

// Faces to shoot at: some 60 of them, spread over the mesh.
std::vector<std::uint32_t> chosen_faces(const Mesh& mesh) {
    std::vector<std::uint32_t> faces;
    const std::size_t step = std::max<std::size_t>(1, mesh.faces.size() / 60);
    for (std::size_t i = 0; i < mesh.faces.size(); i += step) faces.push_back(static_cast<std::uint32_t>(i));
    return faces;
}

// Down the vertex normals and along the edges' normals, from above and from below: on the border of every
// prism that meets there.
RaySet through_vertices_and_edges(const Mesh& mesh, double height) {
    RaySet set{"through vertices and edges", {}};
    for (const std::uint32_t face : chosen_faces(mesh)) {
        const auto& corners = mesh.faces[face].position;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
            for (const double along : {0.0, 0.5, 0.3}) {
                const dvec3 on = position(mesh, a) * (1 - along) + position(mesh, b) * along;
                const dvec3 n = glm::normalize(normal(mesh, a) * (1 - along) + normal(mesh, b) * along);
                set.rays.push_back(ray_of(on + n * height, -n));
                set.rays.push_back(ray_of(on - n * height, n));
            }
        }
    }
    return set;
}

// In the bilinear side of a prism: from over one end of an edge to below the other.
RaySet along_prism_sides(const Mesh& mesh, double height) {
    RaySet set{"along prism sides", {}};
    for (const std::uint32_t face : chosen_faces(mesh)) {
        const auto& corners = mesh.faces[face].position;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
            const dvec3 high = position(mesh, a) + normal(mesh, a) * height,
                        low = position(mesh, b) - normal(mesh, b) * height;
            set.rays.push_back(ray_of(high, low - high));
            set.rays.push_back(ray_of(low, high - low));
            // Along the edge itself, half of the height over it.
            const dvec3 from = position(mesh, a) + normal(mesh, a) * (height / 2),
                        to = position(mesh, b) + normal(mesh, b) * (height / 2);
            set.rays.push_back(ray_of(from - (to - from) * 2.0, to - from));
        }
    }
    return set;
}

struct Place {
    dvec3 on, normal, along;
    double displacement;
};

// Places spread over S, each with one direction along it.
std::vector<Place> places(const Case& c, std::uint32_t count, std::uint32_t seed) {
    const ReferenceSurface surface = c.reference();
    const Mesh& mesh = c.objects[0].mesh;
    std::vector<Place> list;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto face =
            static_cast<std::uint32_t>(hash01(i, 0, seed) * static_cast<double>(mesh.faces.size()));
        const double b1 = hash01(i, 1, seed), b2 = (1 - b1) * hash01(i, 2, seed);
        const ReferencePoint at = surface.evaluate(0, face, b1, b2);
        const dvec3 side(hash01(i, 3, seed) - 0.5, hash01(i, 4, seed) - 0.5, hash01(i, 5, seed) - 0.5);
        list.push_back(
            {at.position, at.normal, glm::normalize(glm::cross(at.normal, side)), at.displacement});
    }
    return list;
}

RaySet along_the_surface(const Case& c, double back) {
    RaySet set{"along the surface", {}};
    for (const Place& p : places(c, 150, 21)) set.rays.push_back(ray_of(p.on - p.along * back, p.along));
    return set;
}

RaySet from_on_the_surface(const Case& c) {
    RaySet set{"from on the surface", {}};
    for (const Place& p : places(c, 100, 22)) {
        for (const dvec3& d : {p.normal, -p.normal, p.along, glm::normalize(p.along + p.normal * 0.3),
                               glm::normalize(p.along - p.normal * 0.3)})
            set.rays.push_back(ray_of(p.on, d));
    }
    return set;
}

// Between the base mesh and S, and as far beyond it.
RaySet from_inside_the_shell(const Case& c) {
    RaySet set{"from inside the shell", {}};
    for (const Place& p : places(c, 100, 23)) {
        for (const double part : {-0.5, 0.01, 0.5}) {
            const dvec3 from = p.on - p.normal * (p.displacement * part);
            for (const dvec3& d : {p.normal, -p.normal, p.along}) set.rays.push_back(ray_of(from, d));
        }
    }
    return set;
}

RaySet from_below(const Case& c, double depth) {
    RaySet set{"from below", {}};
    for (const Place& p : places(c, 150, 24)) {
        set.rays.push_back(ray_of(p.on - p.normal * depth, p.normal));
        set.rays.push_back(ray_of(p.on - p.normal * depth, p.normal + p.along));
    }
    return set;
}

Case with_all_rays(Case c, double height) {
    c.views.clear();
    const Mesh& mesh = c.objects[0].mesh;
    c.rays = {through_vertices_and_edges(mesh, height),
              along_prism_sides(mesh, height),
              along_the_surface(c, 3 * height),
              from_on_the_surface(c),
              from_inside_the_shell(c),
              from_below(c, height)};
    return c;
}

// Rays that lie in a flat surface, in its border, and exactly on its diagonal and corners.
Case in_a_flat_plane() {
    Case c = on_plane(1, 0.5, flat_map(0, 1, 1));
    c.views.clear();
    RaySet lying{"in the surface", {}}, upright{"on borders and the diagonal", {}};
    for (int i = 0; i <= 40; ++i) {
        const double s = i / 40.0;
        lying.rays.push_back(ray_of({-1, s, -0.5}, {1, 0, 0}));
        lying.rays.push_back(ray_of({s, -1, -0.5}, {0, 1, 0}));
        lying.rays.push_back(ray_of({s, s, -0.5}, {1, 1, 0}));
        for (const double way : {1.0, -1.0}) {
            upright.rays.push_back(ray_of({s, s, way}, {0, 0, -way}));
            upright.rays.push_back(ray_of({s, 0, way}, {0, 0, -way}));
            upright.rays.push_back(ray_of({1, s, way}, {0, 0, -way}));
        }
    }
    c.rays = {lying, upright};
    return c;
}

// Rays exactly over texels' centres and borders, upright, and level along their rows, columns and diagonals
// at the height of the map's values: nothing of them tells one cell from its neighbour.
Case over_texel_borders(double amplitude, const MapShape& map) {
    Case c = on_plane(amplitude, 0, map);
    c.views.clear();
    RaySet upright{"upright", {}}, level{"level", {}};
    const int count = map.width;
    for (int i = 0; i <= 2 * count; ++i) {
        const double s = i / (2.0 * count);
        for (int j = 0; j <= 2 * count; j += 3) {
            const double t = j / (2.0 * count);
            upright.rays.push_back(ray_of({s, t, 2}, {0, 0, -1}));
            upright.rays.push_back(ray_of({s, t, -2}, {0, 0, 1}));
        }
        for (const double part : {0.0, 0.25, 0.5, 1.0}) {
            const double z = part * amplitude;
            level.rays.push_back(ray_of({-0.5, s, z}, {1, 0, 0}));
            level.rays.push_back(ray_of({s, 1.5, z}, {0, -1, 0}));
            level.rays.push_back(ray_of({s, s, z}, {1, 1, 0}));
            level.rays.push_back(ray_of({s, 0.5, z}, {-1, 0, 0}));
        }
    }
    c.rays = {upright, level};
    return c;
}

}  // namespace

std::vector<CaseEntry> ray_cases() {
    std::vector<CaseEntry> list;
    const auto add = [&](const char* name, const char* what, std::function<Case()> make) {
        list.push_back({"rays", name, what, std::move(make)});
    };
    add("rays_at_plane", "rays at hills on a plane",
        [] { return with_all_rays(on_plane(0.15, 0.5, dunes_map(64, 64)), 0.5); });
    add("rays_at_ball", "rays at hills on a ball",
        [] { return with_all_rays(on_ball(0.2, 0.5, ball_dunes_map(128, 64)), 0.5); });
    add("rays_at_flat_ball", "rays at a flat map on a ball",
        [] { return with_all_rays(on_ball(0.2, 0.5, flat_map(0.7)), 0.5); });
    add("rays_at_lump", "rays at hills on 30 irregular triangles",
        [] { return with_all_rays(on_lump(0.15, 0.5, ball_dunes_map(64, 64)), 0.5); });
    add("rays_at_cliffs", "rays at cliffs on a plane",
        [] { return with_all_rays(on_plane(0.1, 0.5, cliff_map(16, 16)), 0.3); });
    add("rays_at_spikes", "rays at spikes on a ball",
        [] { return with_all_rays(on_ball(0.2, 0.2, spike_map(128, 64)), 0.5); });
    add("rays_in_a_plane", "rays that lie in a flat plane, on its border and diagonal", in_a_flat_plane);
    add("rays_over_texel_borders", "rays exactly over texels' centres and borders, cliffs on a plane",
        [] { return over_texel_borders(0.25, cliff_map(16, 16)); });
    add("rays_over_chessboard", "the same over a chessboard of single texels", [] {
        return over_texel_borders(0.5, {8, 8, [](int x, int y) { return (x + y) % 2; }, Wrap::clamp});
    });
    return list;
}

}  // namespace relievo::stability
