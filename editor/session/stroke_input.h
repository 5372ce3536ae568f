// From pointer events to dabs: spaced by arc length on the displaced surface, whatever the frame rate.
//
// Events are handled one by one in the order in which they came, each against the map as the dabs before it
// left it. The window's loop may hand them over in any batches: the dabs are the same at 5 and at 60 frames a
// second.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "brushes/brush.h"
#include "renderer/renderer.h"

namespace relievo {

struct PointerEvent {
    std::uint64_t time_us = 0;  // any clock
    double x_px = 0, y_px = 0;  // in the picture, as Renderer::camera_ray takes them
    double pressure = 1;        // [0, 1]
};

class StrokeInput {
  public:
    using Pick = std::function<std::vector<PickHit>(std::span<const Ray>)>;  // one hit a ray, in order
    using CameraRay = std::function<Ray(double x_px, double y_px)>;
    using Apply = std::function<void(const Dab&)>;  // changes the surface before it returns

    // The brush's radius and spacing are those of the whole stroke. Only hits on object 0 are sculpted.
    StrokeInput(const Brush& brush, Pick pick, CameraRay camera_ray, Apply apply);

    void begin(const PointerEvent& event);  // the first dab, when it hits
    void move(const PointerEvent& event);
    void end(const PointerEvent& event);  // the last stretch

  private:
    struct Sample {
        PointerEvent at;
        PickHit hit;
        Ray ray;
    };

    std::vector<Sample> pick_along(const std::vector<PointerEvent>& points) const;
    void stretch_to(const PointerEvent& to);
    void walk(const Sample& next, std::vector<PointerEvent>& dabs);
    void place(const std::vector<PointerEvent>& points);

    double radius_, spacing_;  // world units
    Pick pick_;
    CameraRay camera_ray_;
    Apply apply_;
    std::uint64_t start_us_ = 0;
    std::optional<Sample> last_;  // the newest point of the path; its hit may be a miss
    double since_dab_ = 0;        // arc length, world units
};

// Rounds to the journal's units. Barycentrics outside the triangle (by rounding) are brought in.
Dab quantised_dab(const PickHit& hit, std::uint64_t time_us, double pressure);

}  // namespace relievo
