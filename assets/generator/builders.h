// The families of base meshes that the sample assets are made of.
#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>

#include "assets/generator/atlas.h"
#include "assets/generator/shape.h"

namespace relievo::assets {

// What an asset's file makes: the mesh and the functions that its maps are painted from.
struct Sculpture {
    Shape shape;
    HeightFunction height;  // empty, and no exemplar: no map is made
    FreeHeightFunction free_height = {};  // for texels in no island
    HeightFunction opacity = {};          // empty: opaque; else over 0.5 is solid
    std::function<double(double, double)> exemplar = {};  // of u and v: the map is a whole image, not of islands
};

// A box's grid projected to the sphere at evenly spaced angles: six islands, one a face.
struct BoxSphere {
    std::array<int, 3> cells;  // along x, y and z: 4 (xy + yz + zx) triangles

    // Unit direction of the point (s, t), in cells, of a face: 0 +x, 1 -x, 2 +y, 3 -y, 4 +z, 5 -z.
    glm::dvec3 direction(int face, double s, double t) const;
};

struct Place {
    int x, y;  // lower left corner in the map, lattice units
    bool turned = false;
};

// Every vertex stands at `position(direction)`; normals are the directions.
Shape make_box_sphere(const BoxSphere& box, const std::array<Place, 6>& places, int cell,
                      const std::function<glm::dvec3(glm::dvec3)>& position);

// The sphere of 3,968 triangles and its six islands, shared by the orb and the leather ball.
inline constexpr BoxSphere kBall{{16, 23, 16}};
Shape make_ball();

// A closed tube: columns around, rows along, cut all around into pieces, each one island wide as the tube's
// girth.
struct Tube {
    int around, along;   // cells
    int pieces;          // islands, side by side in the map
    int cell_w, cell_h;  // lattice units

    int first_row(int piece) const { return along * piece / pieces; }
    double around01(const Sample& p) const { return p.s / around; }  // [0, 1)
    double along01(const Sample& p) const { return (first_row(p.island) + p.t) / along; }
};

// `frame` gives, at 0 <= along < 1, the centre and two unit vectors across the tube: columns turn from the
// first to the second, and first x second points along the rows.
struct TubeFrame {
    glm::dvec3 centre, first, second;
};
Shape make_tube(const Tube& tube, double radius, const std::function<TubeFrame(double)>& frame);

// A sheet over [0, 1] x [0, 1], cut between columns into pieces side by side in the map.
struct Sheet {
    int columns, rows;
    int pieces;
    int cell;  // lattice units

    int first_column(int piece) const { return columns * piece / pieces; }
    double s01(const Sample& p) const { return (first_column(p.island) + p.s) / columns; }
    double t01(const Sample& p) const { return p.t / rows; }
};
Shape make_sheet(const Sheet& sheet, const std::function<glm::dvec3(double, double)>& position);

Sculpture make_plane();
Sculpture make_asteroid();
Sculpture make_chainmail();
Sculpture make_leather();
Sculpture make_orb();
Sculpture make_stump();
Sculpture make_knot();
Sculpture make_fur();
Sculpture make_scree();
Sculpture make_procedural_plane();
Sculpture make_procedural_sphere();

}  // namespace relievo::assets
