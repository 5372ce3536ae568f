// A surface for tests: rectangles of the plane z = 0, each laid into the map by its own affine chart.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "brushes/brush.h"
#include "brushes/height_map.h"
#include "brushes/sculptor.h"
#include "brushes/surface.h"

namespace relievo {

// The rectangle [low, high] of the plane. Texel coordinates (the centre of texel (i, j) is (i + .5, j + .5))
// are origin + (p.x - low.x) * along_x + (p.y - low.y) * along_y.
struct Chart {
    glm::dvec2 low, high;
    glm::dvec2 origin, along_x, along_y;

    glm::dvec2 texel_of(glm::dvec2 point) const;
    glm::dvec2 point_of(glm::dvec2 texel) const;
    bool holds(glm::dvec2 point) const;  // with a margin of 1e-9
};

class ChartSurface : public Surface {
  public:
    ChartSurface(const HeightMap& map, std::vector<Chart> charts, float amplitude, float midlevel = 0.5f)
        : map_(map), charts_(std::move(charts)), amplitude_(amplitude), midlevel_(midlevel) {}

    SurfacePoint at(std::uint32_t face, float b1, float b2) const override;
    std::uint32_t face_count() const override { return static_cast<std::uint32_t>(2 * charts_.size()); }
    void texels_in_ball(glm::vec3 centre, float radius, std::vector<SurfaceTexel>& out) const override;
    bool owned(int x, int y) const override;
    const SeamTable& seams() const override { return table; }
    float amplitude() const override { return amplitude_; }
    float midlevel() const override { return midlevel_; }

    // The dab at a point of the plane.
    Dab dab(double x, double y, double pressure = 1.0) const;
    // Counts at a point by bilinear filtering of a chart's texels.
    double counts(std::size_t chart, glm::dvec2 point) const;
    // Adds the equations of an edge between two charts, six a texel.
    void add_equations(std::size_t chart_a, std::size_t chart_b, glm::dvec2 from, glm::dvec2 to);
    // The largest difference of the two charts' heights along an edge, in counts.
    double gap(std::size_t chart_a, std::size_t chart_b, glm::dvec2 from, glm::dvec2 to) const;

    SeamTable table;

  private:
    float height(double counts) const {
        return amplitude_ * (static_cast<float>(counts / 65535.0) - midlevel_);
    }

    const HeightMap& map_;
    std::vector<Chart> charts_;
    float amplitude_, midlevel_;
};

// The unit square over the whole map.
Chart unit_chart(const HeightMap& map);

// What stamp and clone need beside a dab: an image with a slope, and a source that lies beside the dab (for
// clone alone).
std::shared_ptr<const Alpha> sloping_alpha();
std::vector<FacePoint> sources_of(const Brush& brush, const ChartSurface& surface, glm::dvec2 at);

// A straight stroke with dabs spaced as the brush says. Does not end it.
void drag(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 from,
          glm::dvec2 to);
// The same with begin and end.
void stroke(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 from,
            glm::dvec2 to);
// One dab as a stroke.
void tap(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 at);

// Fills a map by a function of the texel.
void fill(HeightMap& map, const std::function<double(int x, int y)>& count);

}  // namespace relievo
