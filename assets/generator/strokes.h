// Sample journals: strokes on the base meshes that someone would make, as JSON Lines that `relievo replay`
// reads (editor/session/journal.h states the format). Dabs are addressed by face and barycentrics of the mesh
// file.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "assets/generator/shape.h"

namespace relievo::assets {

struct StrokeBrush {
    std::string tool;       // draw, smooth, flatten, level or erase
    double radius;          // world units
    double strength;        // [0, 1]
    double hardness = 0.0;  // [0, 1)
    double spacing = 0.15;  // of the radius
    bool lower = false;     // draw lowers
    std::string falloff = "smooth";
    double level = 0.5;  // map value that the level tool moves to
};

class StrokeJournal {
  public:
    // `scene` as the journal names it, relative to the journal's folder.
    StrokeJournal(const Shape& shape, const std::string& scene);

    // A stroke along a line near the surface: its points go to the nearest ones of the base mesh, and dabs
    // are spaced along those by arc length. Pressure sets in and fades out, as a hand's does. `speed` in
    // world units a second.
    void stroke(const StrokeBrush& brush, const std::vector<glm::dvec3>& line, double speed);
    void undo();

    // The nearest point of the base mesh, and the outward normal of its triangle.
    struct Foot {
        glm::dvec3 point, normal;
        std::size_t face;
        double b1, b2;
    };
    Foot nearest(glm::dvec3 p) const;

    // Throws std::runtime_error that names the file when it cannot be written.
    void write(const std::filesystem::path& path) const;

  private:
    struct Face {
        glm::dvec3 a, b, c, centre;
        double reach;  // from the centre to the farthest corner
    };
    std::vector<Face> faces_;
    std::string text_;
};

// Makes a sample's journals in `folder`: none for most.
void write_sample_strokes(const std::string& asset, const Shape& shape, const std::filesystem::path& folder);

}  // namespace relievo::assets
