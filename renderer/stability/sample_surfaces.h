// Small meshes and maps of extreme kinds, with closed forms where there are any.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "renderer/reference/reference.h"

namespace relievo::stability {

// A mesh with its map; owns what object() points to.
struct SampleSurface {
    Mesh mesh;
    int width = 1, height = 1;
    std::vector<std::uint16_t> texels{32768};
    double amplitude = 1, midlevel = 0;
    Wrap wrap = Wrap::repeat;
    std::vector<std::uint8_t> opacity;  // opacity_width texels a row; empty: opaque
    int opacity_width = 0;
    std::optional<Procedural> procedural = {};  // the texels are the exemplar of procedural heights

    ReferenceObject object() const;
    SceneObject scene_object() const;  // without files: the map goes beside it
    ReferenceSurface reference() const;
    // Texels from a height in [0, 1] of the column and row.
    void paint(int w, int h, const std::function<double(int, int)>& value);
};

// The square [0, 1]^2 at z = 0 as two triangles, normals +z, uv = scale * (x, y) + shift.
Mesh plane_mesh(double scale = 1, double shift = 0);
// A lat-long ball around 0: 2 columns (rows - 1) triangles, uv = (longitude, latitude), normals P/|P|.
Mesh ball_mesh(int columns, int rows, double radius = 1);
// 30 irregular triangles around 0, radii within [0.6, 1.4], smooth normals.
Mesh lump_mesh();
// One triangle with normals of its own, uv = (0, 0), (1, 0), (0, 1).
Mesh triangle_mesh(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& na,
                   const glm::dvec3& nb, const glm::dvec3& nc);

// Rolling dunes in [0, 1] of place [0, 1)^2, periodic.
double dunes(double u, double v);
// The same, fading to 0.5 towards v = 0 and 1, so that the fans at a ball's poles (16 rows or more) are not
// torn.
double ball_dunes(double u, double v);
// A number in [0, 1) from integers: the same everywhere.
double hash01(std::uint32_t a, std::uint32_t b, std::uint32_t seed);

}  // namespace relievo::stability
