// Small meshes with known texture layouts, for the tests of the brush's view.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "brushes/height_map.h"
#include "brushes/surface.h"
#include "editor/session/surface/mesh_surface.h"
#include "renderer/scene/mesh.h"
#include "renderer/scene/scene.h"

namespace relievo::test {

// Collects quads and triangles whose corners are given by place, welds equal positions, and smooths the
// normals.
class MeshBuilder {
  public:
    struct Corner {
        glm::vec3 position;
        glm::vec2 uv;
    };
    void triangle(const Corner& a, const Corner& b, const Corner& c);
    void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d);  // around
    Mesh build() const;

  private:
    std::vector<std::array<Corner, 3>> triangles_;
};

// The unit square in z = 0, uv = xy.
Mesh plane();

// A box grid of a x b x c cells projected to the unit sphere: six islands of k/cells_a_side of the map, four
// cells apart at least, on multiples of 1/64. `order` shuffles, turns and mirrors the islands.
Mesh box_sphere(int a, int b, int c, unsigned order = 0);

// box_sphere(n, n, n) with each island turned by an angle of its own, and grown by a factor of its own from 1.2
// to 1.6: no seam runs along texel rows, or at one scale.
Mesh turned_box_sphere(int n);

// A flat strip cut across: cells in x with height 1, the part right of the middle turned by `turn` radians
// and scaled in the map. No island is near another.
Mesh cut_strip(double turn, double scale);

// An open cylinder about z, unrolled into one island with one seam; `cells` around.
Mesh cut_cylinder(int cells);

// The unit sphere about y, unrolled: the map repeats around it, and every triangle at a pole is a point of
// its own. As many texels around as along.
Mesh globe(int around, int along);

std::mt19937 generator(unsigned seed);
HeightMap random_map(int width, int height, unsigned seed);

// Counts by a function of space at every owned texel, the base mesh's own where the displacement is 0.
void set_owned(HeightMap& map, const MeshSurface& surface,
               const std::function<double(const glm::dvec3&)>& counts);

// The same map with every gutter a plain copy.
HeightMap with_copies_alone(HeightMap map, const SeamTable& table);

// What the brushes keep: copies, and shifts where rows bend.
void fill_gutters(HeightMap& map, const SeamTable& table);

Displacement displacement(double amplitude, double midlevel = 0.5, Wrap wrap = Wrap::repeat);

}  // namespace relievo::test
