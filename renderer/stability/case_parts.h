// What the lists of cases are put together from: usual views, surfaces on usual meshes, map patterns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/stability/stability_case.h"

namespace relievo::stability {

using Value = std::function<double(int, int)>;  // a map's value in [0, 1] at a column and row

std::vector<NamedView> plane_views();     // of the square [0, 1]^2 at z = 0
std::vector<NamedView> ball_views();      // of a ball or lump of radius 1 around 0
std::vector<NamedView> triangle_views();  // of the triangle (0, 0), (1, 0), (0, 1) at z = 0

struct MapShape {
    int width, height;
    Value value;
    Wrap wrap = Wrap::repeat;
};

Case on_mesh(const Mesh& mesh, std::vector<NamedView> views, double amplitude, double midlevel,
             const MapShape& map);
Case on_plane(double amplitude, double midlevel, const MapShape& map);
Case on_ball(double amplitude, double midlevel, const MapShape& map);  // of 960 triangles
Case on_lump(double amplitude, double midlevel, const MapShape& map);

// The same, held to the limits of sampling methods too.
Case smooth(Case c);
Case irregular(Case c);  // to those of the known flaw
// Everything `scale` times as large.
Case scaled(Case c, double scale);
Case moved(Case c, const glm::dvec3& origin);

MapShape dunes_map(int width, int height);       // periodic
MapShape ball_dunes_map(int width, int height);  // flat towards a ball's poles
MapShape flat_map(double value, int width = 4, int height = 4);
MapShape noise_map(int width, int height);  // white noise
MapShape cliff_map(int width, int height);  // 0 or 65535 at random, side by side
MapShape spike_map(int width, int height);  // single texels at 1 over 0.2
MapShape ridge_map(int width, int height);  // single columns and rows

}  // namespace relievo::stability
