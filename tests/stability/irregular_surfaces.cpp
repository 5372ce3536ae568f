// See irregular_surfaces.h.
#include "tests/stability/irregular_surfaces.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "renderer/stability/case_parts.h"
#include "tests/stability/draw.h"

namespace relievo::stability {
namespace {

using glm::dvec2;
using glm::dvec3;

struct Shape {
    std::string name;
    MeshFile file;
    bool flat = false;  // over [0, 1]^2, else around 0
};

void add_face(MeshFile& file, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    file.faces.push_back({{a, b, c}, {0, 0, 0}});
}

void add_square(MeshFile& file, const std::array<std::uint32_t, 4>& corners, bool other_diagonal) {
    const auto [a, b, c, d] = corners;
    add_face(file, a, b, other_diagonal ? d : c);
    other_diagonal ? add_face(file, b, c, d) : add_face(file, a, c, d);
}

// Columns of the given places, rows at random, corners moved about.
Shape crooked_grid(Draw& draw, const std::vector<double>& columns, int rows, double sideways) {
    Shape shape{"grid", {}, true};
    const double rise = draw.coin() ? 0 : draw.between(0, 0.3);
    const auto across = static_cast<std::uint32_t>(columns.size());
    for (int y = 0; y <= rows; ++y) {
        for (std::uint32_t x = 0; x < across; ++x) {
            const bool inner = x > 0 && x + 1 < across && y > 0 && y < rows;
            const double wide = inner ? columns[x + 1] - columns[x] : 0, high = inner ? 1.0 / rows : 0;
            shape.file.positions.push_back({columns[x] + draw.between(-1, 1) * sideways * wide,
                                            double(y) / rows + draw.between(-1, 1) * sideways * high,
                                            draw.between(-1, 1) * rise});
        }
    }
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(rows); ++y)
        for (std::uint32_t x = 0; x + 1 < across; ++x) {
            const std::uint32_t a = y * across + x;
            add_square(shape.file, {a, a + 1, a + across + 1, a + across}, draw.coin());
        }
    return shape;
}

Shape grid(Draw& draw) {
    const int count = draw.whole(1, 7);
    std::vector<double> columns;
    for (int i = 0; i <= count; ++i) columns.push_back(double(i) / count);
    return crooked_grid(draw, columns, draw.whole(1, 7), draw.between(0, 0.45));
}

Shape slivers(Draw& draw) {
    std::vector<double> columns{0};
    for (int i = draw.whole(4, 20); i > 0; --i) columns.push_back(columns.back() + draw.log_between(1e-3, 1));
    const double width = columns.back();
    for (double& x : columns) x /= width;
    Shape shape = crooked_grid(draw, columns, 1, 0);
    shape.name = "slivers";
    return shape;
}

Shape box(Draw& draw) {
    Shape shape{"box", {}};
    const dvec3 size(draw.log_between(0.2, 1), draw.log_between(0.2, 1), draw.log_between(0.2, 1));
    for (int i = 0; i < 8; ++i)
        shape.file.positions.push_back(size * dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    for (const std::array<std::uint32_t, 4>& side :
         std::array<std::array<std::uint32_t, 4>, 6>{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}})
        add_square(shape.file, side, false);
    return shape;
}

Shape spindle(Draw& draw) {
    Shape shape{"spindle", {}};
    const int count = draw.whole(3, 40);
    const double height = draw.log_between(0.1, 3);
    shape.file.positions = {{0, 0, height}, {0, 0, -height * draw.between(0.1, 1)}};
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::acos(-1.0) * (i + draw.between(-0.3, 0.3)) / count;
        shape.file.positions.push_back({std::cos(angle), std::sin(angle), draw.between(-0.1, 0.1)});
    }
    for (int i = 0; i < count; ++i) {
        const auto a = static_cast<std::uint32_t>(2 + i), b = static_cast<std::uint32_t>(2 + (i + 1) % count);
        add_face(shape.file, 0, a, b);
        add_face(shape.file, 1, b, a);
    }
    return shape;
}

Shape soup(Draw& draw) {
    Shape shape{"soup", {}};
    for (int i = draw.whole(1, 12); i > 0; --i) {
        const dvec3 at = 0.6 * draw.direction();
        const auto first = static_cast<std::uint32_t>(shape.file.positions.size());
        for (int k = 0; k < 3; ++k)
            shape.file.positions.push_back(at + draw.log_between(0.1, 0.9) * draw.direction());
        add_face(shape.file, first, first + 1, first + 2);
    }
    return shape;
}

dvec3 face_normal(const MeshFile& file, const Mesh::Face& face) {
    const dvec3 a = file.positions[face.position[0]];
    return glm::cross(file.positions[face.position[1]] - a, file.positions[face.position[2]] - a);
}

// Every face for itself, flat: S is torn along all edges.
void split_normals(Shape& shape) {
    MeshFile apart;
    for (const Mesh::Face& face : shape.file.faces) {
        const auto first = static_cast<std::uint32_t>(apart.positions.size());
        for (const std::uint32_t corner : face.position) {
            apart.positions.push_back(shape.file.positions[corner]);
            apart.file_normals.push_back(glm::normalize(face_normal(shape.file, face)));
        }
        add_face(apart, first, first + 1, first + 2);
    }
    shape.file = apart;
    shape.name += ", split normals";
}

void lean_normals(Draw& draw, Shape& shape) {
    std::vector<dvec3> sums(shape.file.positions.size(), dvec3(0));
    for (const Mesh::Face& face : shape.file.faces)
        for (const std::uint32_t corner : face.position) sums[corner] += face_normal(shape.file, face);
    const double lean = draw.between(0, 0.8);
    for (const dvec3& sum : sums)
        shape.file.file_normals.push_back(glm::normalize(glm::normalize(sum) + lean * draw.direction()));
    shape.name += ", leaning normals";
}

// Affine in the position, so that neighbours agree: sheared, mirrored as often as not, and thin where the axes are close.
void project(Draw& draw, Shape& shape) {
    const double scale = draw.log_between(0.2, 6);
    dvec3 u = scale * draw.log_between(0.3, 2) * draw.direction(), v = scale * draw.direction();
    if (shape.flat) u.z = v.z = 0;
    const dvec2 shift(draw.between(-3, 3), draw.between(-3, 3));
    for (const dvec3& p : shape.file.positions)
        shape.file.uvs.push_back(shift + dvec2(glm::dot(p, u), glm::dot(p, v)));
    for (Mesh::Face& face : shape.file.faces) face.uv = face.position;
    shape.name += ", projected";
}

// Of any size, form and side; every third is a line or a point.
void islands(Draw& draw, Shape& shape) {
    for (Mesh::Face& face : shape.file.faces) {
        const dvec2 at(draw.between(-2, 2), draw.between(-2, 2));
        const double size = draw.log_between(0.02, 3);
        const int kind = draw.whole(0, 5);
        for (std::uint32_t& corner : face.uv) {
            corner = static_cast<std::uint32_t>(shape.file.uvs.size());
            const double x = draw.between(-1, 1), y = draw.between(-1, 1);
            shape.file.uvs.push_back(at + size * (kind == 0 ? dvec2(0) : kind == 1 ? dvec2(x, 0.3 * x) : dvec2(x, y)));
        }
    }
    shape.name += ", islands";
}

void scatter(Draw& draw, Shape& shape) {
    const double reach = draw.log_between(0.05, 2);
    for (std::size_t i = 0; i < shape.file.positions.size(); ++i)
        shape.file.uvs.push_back({draw.between(-reach, reach), draw.between(-reach, reach)});
    for (Mesh::Face& face : shape.file.faces) face.uv = face.position;
    shape.name += ", scattered";
}

Shape any_shape(Draw& draw) {
    Shape (*const shapes[])(Draw&) = {grid, slivers, box, spindle, soup};
    Shape shape = shapes[draw.whole(0, 4)](draw);
    const int normals = draw.whole(0, 3);
    if (normals == 0) split_normals(shape);
    if (normals == 1) lean_normals(draw, shape);
    void (*const layouts[])(Draw&, Shape&) = {project, islands, scatter};
    layouts[draw.whole(0, 2)](draw, shape);
    return shape;
}

MapShape any_map(Draw& draw) {
    const auto side = [&] {
        const int kind = draw.whole(0, 5);
        return kind == 0 ? 1 : kind == 1 ? draw.whole(2, 7) : kind == 2 ? draw.whole(100, 200) : draw.whole(8, 100);
    };
    MapShape (*const patterns[])(int, int) = {dunes_map, noise_map, cliff_map, spike_map, ridge_map};
    const int width = side(), height = side();
    MapShape map = patterns[draw.whole(0, 4)](width, height);
    map.wrap = draw.coin() ? Wrap::repeat : Wrap::clamp;
    return map;
}

std::vector<NamedView> any_views(Draw& draw, bool flat) {
    std::vector<NamedView> views;
    for (const char* name : {"one", "another", "third"}) {
        dvec3 eye = draw.direction() * (views.size() == 2 ? draw.between(0.05, 0.6) : draw.between(1.2, 4));
        dvec3 at = draw.direction() * draw.between(0, 0.5);
        if (flat) {
            eye = {draw.between(-0.6, 1.6), draw.between(-0.6, 1.6), (draw.coin() ? 1 : -1) * draw.log_between(0.02, 2)};
            at = {draw.between(0, 1), draw.between(0, 1), draw.between(-0.05, 0.05)};
        }
        views.push_back({name, eye, at});
    }
    return views;
}

Procedural any_tiling(Draw& draw) {
    Procedural p;
    p.scale = draw.whole(0, 4) > 0 ? draw.log_between(0.2, 6) : draw.log_between(1e-3, 0.2);
    p.triangle_size = draw.whole(0, 4) > 0 ? draw.log_between(0.1, 1) : draw.log_between(1e-3, 1e3);
    p.seed = static_cast<std::uint32_t>(draw.whole(0, 1 << 30));
    const double reach = draw.coin() ? 2 : 500;
    p.offset = {draw.between(-reach, reach), draw.between(-reach, reach)};
    return p;
}

}  // namespace

IrregularCase irregular_case(unsigned seed, bool procedural) {
    Draw draw(2 * seed + (procedural ? 1 : 0));
    const Shape shape = any_shape(draw);
    const Mesh mesh = make_mesh(shape.file, glm::dmat4(1), dvec3(0), !shape.file.file_normals.empty());
    const MapShape map = any_map(draw);
    const double amplitude = (draw.coin() ? 1 : -1) * draw.log_between(1e-3, 0.4),
                 midlevel = draw.coin() ? draw.between(0, 1) : draw.whole(0, 1);
    IrregularCase result{shape.name + ", map " + std::to_string(map.width) + " x " + std::to_string(map.height) +
                             ", amplitude " + std::to_string(amplitude),
                         on_mesh(mesh, any_views(draw, shape.flat), amplitude, midlevel, map)};
    if (procedural) {
        const Procedural tiling = any_tiling(draw);
        result.surface.objects[0].procedural = tiling;
        result.surface.objects[0].wrap = Wrap::repeat;
        result.what += ", scale " + std::to_string(tiling.scale) + ", triangles " + std::to_string(tiling.triangle_size);
    }
    return result;
}

}  // namespace relievo::stability
