// The plane of 2 triangles and the sphere of 960 of thesis 000, table 6.1, that methods are compared on over
// procedural heights. Their exemplar is another asset's.
#include "assets/generator/builders.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr int kAround = 32, kAlong = 16;  // a globe's columns and rows; triangles at the poles
constexpr int kCell = kLattice / kAround;

}  // namespace

Sculpture make_procedural_plane() {
    return {make_plane().shape, {}};
}

// Torn along its meridian at -z, where the camera does not look, and at the poles.
Sculpture make_procedural_sphere() {
    Shape shape;
    const auto add = [&](int column, int row) {
        const double turn = 2.0 * kPi * column / kAround, rise = kPi * row / kAlong;
        shape.positions.push_back({-sine(rise) * sine(turn), -cosine(rise), -sine(rise) * cosine(turn)});
    };
    for (int row = 1; row < kAlong; ++row)
        for (int column = 0; column < kAround; ++column) add(column, row);
    add(0, 0);
    add(0, kAlong);
    const auto vertex = [](int column, int row) {
        return static_cast<std::uint32_t>(row * kAround + column % kAround);
    };
    shape.add_island({kAround, kAlong - 2, 0, kCell, kCell, kCell}, vertex);
    const std::uint32_t south = vertex(0, kAlong - 1), north = south + 1;
    for (int column = 0; column < kAround; ++column) {
        const double u = column * kCell, top = (kAlong - 1) * kCell;
        shape.free_triangles.push_back({{south, vertex(column + 1, 0), vertex(column, 0)},
                                        {{{u + 0.5 * kCell, 0}, {u + kCell, kCell}, {u, kCell}}}});
        shape.free_triangles.push_back({{vertex(column, kAlong - 2), vertex(column + 1, kAlong - 2), north},
                                        {{{u, top}, {u + kCell, top}, {u + 0.5 * kCell, top + kCell}}}});
    }
    shape.normals = shape.positions;
    return {shape, {}};
}

}  // namespace relievo::assets
