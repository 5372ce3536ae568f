// Box spheres, tubes and sheets: positions shared between islands, so that the meshes are closed.
#include "assets/generator/builders.h"

#include <glm/geometric.hpp>
#include <map>

#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

// A face's axes: columns and rows run along axis s and t, forwards or backwards; s x t points outwards.
struct FaceAxes {
    int s, t, out;
    bool s_back, t_back, out_back;
};
constexpr FaceAxes kFaces[6] = {
    {2, 1, 0, true, false, false}, {2, 1, 0, false, false, true},  {0, 2, 1, false, true, false},
    {0, 2, 1, false, false, true}, {0, 1, 2, false, false, false}, {0, 1, 2, true, false, true},
};

int gap_between(int width, int count) {
    return (kLattice - kGap - width * count) / (count - 1);
}

}  // namespace

glm::dvec3 BoxSphere::direction(int face, double s, double t) const {
    const FaceAxes& axes = kFaces[face];
    const auto on_cube = [&](int axis, double cell, bool back) {
        const double across = 2.0 * cell / cells[static_cast<std::size_t>(axis)] - 1.0;
        return tangent((back ? -across : across) * kPi / 4.0);
    };
    glm::dvec3 p;
    p[axes.out] = axes.out_back ? -1.0 : 1.0;
    p[axes.s] = on_cube(axes.s, s, axes.s_back);
    p[axes.t] = on_cube(axes.t, t, axes.t_back);
    return glm::normalize(p);
}

Shape make_box_sphere(const BoxSphere& box, const std::array<Place, 6>& places, int cell,
                      const std::function<glm::dvec3(glm::dvec3)>& position) {
    Shape shape;
    std::map<std::array<int, 3>, std::uint32_t> known;  // box grid point to position
    for (int face = 0; face < 6; ++face) {
        const FaceAxes& axes = kFaces[face];
        const auto count = [&](int axis) { return box.cells[static_cast<std::size_t>(axis)]; };
        const auto vertex = [&](int column, int row) {
            std::array<int, 3> point{};
            point[static_cast<std::size_t>(axes.out)] = axes.out_back ? 0 : count(axes.out);
            point[static_cast<std::size_t>(axes.s)] = axes.s_back ? count(axes.s) - column : column;
            point[static_cast<std::size_t>(axes.t)] = axes.t_back ? count(axes.t) - row : row;
            const auto [at, added] = known.try_emplace(point, static_cast<std::uint32_t>(known.size()));
            if (added) {
                const glm::dvec3 direction = box.direction(face, column, row);
                shape.positions.push_back(position(direction));
                shape.normals.push_back(direction);
            }
            return at->second;
        };
        const Place& place = places[static_cast<std::size_t>(face)];
        shape.add_island({count(axes.s), count(axes.t), place.x, place.y, cell, cell, place.turned}, vertex);
    }
    return shape;
}

Shape make_ball() {
    constexpr int kCell = 5, kMargin = 4;
    constexpr int kStep = 16 * kCell + kGap, kTallStep = 23 * kCell + kGap;
    const std::array<Place, 6> places{{{kMargin, kMargin},
                                       {kMargin, kMargin + kTallStep},
                                       {kMargin + 2 * kStep, kMargin},
                                       {kMargin + 2 * kStep, kMargin + kStep},
                                       {kMargin + kStep, kMargin},
                                       {kMargin + kStep, kMargin + kTallStep}}};
    return make_box_sphere(kBall, places, kCell, [](glm::dvec3 direction) { return direction; });
}

Shape make_tube(const Tube& tube, double radius, const std::function<TubeFrame(double)>& frame) {
    Shape shape;
    for (int row = 0; row < tube.along; ++row) {
        const TubeFrame f = frame(static_cast<double>(row) / tube.along);
        for (int column = 0; column < tube.around; ++column) {
            const double angle = 2.0 * kPi * column / tube.around;
            const glm::dvec3 out = f.first * cosine(angle) + f.second * sine(angle);
            shape.positions.push_back(f.centre + radius * out);
            shape.normals.push_back(out);
        }
    }
    const int width = tube.around * tube.cell_w;
    for (int piece = 0; piece < tube.pieces; ++piece) {
        const int first = tube.first_row(piece), rows = tube.first_row(piece + 1) - first;
        const int x = kGap / 2 + piece * (width + gap_between(width, tube.pieces));
        shape.add_island({tube.around, rows, x, kGap / 2, tube.cell_w, tube.cell_h},
                         [&](int column, int row) {
                             return static_cast<std::uint32_t>((first + row) % tube.along * tube.around +
                                                               column % tube.around);
                         });
    }
    return shape;
}

Shape make_sheet(const Sheet& sheet, const std::function<glm::dvec3(double, double)>& position) {
    Shape shape;
    for (int row = 0; row <= sheet.rows; ++row)
        for (int column = 0; column <= sheet.columns; ++column)
            shape.positions.push_back(
                position(static_cast<double>(column) / sheet.columns, static_cast<double>(row) / sheet.rows));
    int x = kGap / 2;
    for (int piece = 0; piece < sheet.pieces; ++piece) {
        const int first = sheet.first_column(piece), columns = sheet.first_column(piece + 1) - first;
        shape.add_island({columns, sheet.rows, x, kGap / 2, sheet.cell, sheet.cell},
                         [&](int column, int row) {
                             return static_cast<std::uint32_t>(row * (sheet.columns + 1) + first + column);
                         });
        x += columns * sheet.cell + kGap;
    }
    shape.make_normals();
    return shape;
}

}  // namespace relievo::assets
