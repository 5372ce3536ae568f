// Meshes that are hard to displace.
#pragma once

#include <glm/mat4x4.hpp>

#include "renderer/scene/mesh.h"

namespace relievo::stability {

// The square cut into `count` strips side by side along x, of width `width` each and of two slivers each; uv
// = the place in the ribbon.
Mesh ribbon_mesh(int count, double width);
// A waving disc around 0: a fan of `needles` triangles of width `width` at its rim, then of 20 broad ones; uv by
// place.
Mesh needle_fan_mesh(int needles, double width);
// Two triangles on an edge along y, opened by `degrees`, smooth normals, uv by place.
Mesh wedge_mesh(double degrees);
// A closed prism whose cross section has a tip of `degrees` at x = 0, smooth normals.
Mesh blade_mesh(double degrees, int segments);
// `sheets` half-planes that share one edge along z, like a book's pages.
Mesh book_mesh(int sheets);
// The mesh without every third face.
Mesh with_holes(Mesh mesh);
// Every corner has a position of its own: no edge is shared by index.
Mesh unwelded(const Mesh& mesh);
// With faces added that have no area: two corners at one place, three on a line.
Mesh with_zero_area_faces(Mesh mesh);
// All faces turned round: N.Ng is negative everywhere.
Mesh turned_inside_out(Mesh mesh);
// As an object's transform would leave it: mirrored, squeezed and turned.
Mesh transformed(const Mesh& mesh, const glm::dmat4& world_from_object);
// The normal of every fifth position leans to a random side.
Mesh with_leaning_normals(Mesh mesh);
// Every face has the whole map's lower left half for itself, mirrored every second time.
Mesh with_overlapping_uvs(Mesh mesh);

}  // namespace relievo::stability
