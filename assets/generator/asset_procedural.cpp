// The plane of 2 triangles and the sphere of 960 of thesis 000, table 6.1, that methods are compared on over
// procedural heights. Their exemplar is another asset's.
#include "assets/generator/builders.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr int kGlobeAround = 32, kGlobeAlong = 16;  // a globe's columns and rows; triangles at the poles
constexpr int kGlobeCell = kLattice / kGlobeAround;

}  // namespace

Sculpture make_procedural_plane() {
    return {make_plane().shape, {}};
}

// Torn along its meridian at -z, where the camera does not look, and at the poles.
Sculpture make_procedural_sphere() {
    Shape shape;
    const auto add = [&](int column, int row) {
        const double turn = 2.0 * kPi * column / kGlobeAround, rise = kPi * row / kGlobeAlong;
        shape.positions.push_back({-sine(rise) * sine(turn), -cosine(rise), -sine(rise) * cosine(turn)});
    };
    for (int row = 1; row < kGlobeAlong; ++row)
        for (int column = 0; column < kGlobeAround; ++column) add(column, row);
    add(0, 0);
    add(0, kGlobeAlong);
    const auto vertex = [](int column, int row) {
        return static_cast<std::uint32_t>(row * kGlobeAround + column % kGlobeAround);
    };
    shape.add_island({kGlobeAround, kGlobeAlong - 2, 0, kGlobeCell, kGlobeCell, kGlobeCell}, vertex);
    const std::uint32_t south = vertex(0, kGlobeAlong - 1), north = south + 1;
    for (int column = 0; column < kGlobeAround; ++column) {
        const double u = column * kGlobeCell, top = (kGlobeAlong - 1) * kGlobeCell;
        shape.free_triangles.push_back({{south, vertex(column + 1, 0), vertex(column, 0)},
                                        {{{u + 0.5 * kGlobeCell, 0}, {u + kGlobeCell, kGlobeCell}, {u, kGlobeCell}}}});
        shape.free_triangles.push_back({{vertex(column, kGlobeAlong - 2), vertex(column + 1, kGlobeAlong - 2), north},
                                        {{{u, top}, {u + kGlobeCell, top}, {u + 0.5 * kGlobeCell, top + kGlobeCell}}}});
    }
    shape.normals = shape.positions;
    return {shape, {}};
}

}  // namespace relievo::assets
