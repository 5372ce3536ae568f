// From pointer events to dabs: spaced by arc length on the displaced surface, whatever the frame rate.
//
// Events are handled one by one in the order in which they came, each against the map as the dabs before it
// left it. The window's loop may hand them over in any batches: the dabs are the same at 5 and at 60 frames a
// second. An airbrush counts its dabs by the clock of the events, at the place of the last event before each.
//
// The grab tool does not walk: its dabs stay where the hand took hold, and carry how far the pointer has
// drawn it in the plane across the view.
//
// Work may be cut short: a brush that is heavy for the machine makes one event's dabs take seconds, and a
// window must not wait for them. What is left over goes on later, to the same dabs.
//
// The dabs of a stamp carry where the image's right is to lie: along the picture's right, or along the
// stroke. In the latter case the first dab of a stroke, or of a part of it behind a gap, waits until there is
// a direction, or the end.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "brushes/brush.h"
#include "editor/session/stroke_settings.h"
#include "editor/session/stroke_trail.h"
#include "renderer/renderer.h"

namespace relievo {

struct PointerEvent {
    std::uint64_t time_us = 0;  // any clock
    double x_px = 0, y_px = 0;  // in the picture, as Renderer::camera_ray takes them
    double pressure = 1;        // [0, 1], before the curve of the settings
};

class StrokeInput {
  public:
    using Pick = std::function<std::vector<PickHit>(std::span<const Ray>)>;  // one hit a ray, in order
    using CameraRay = std::function<Ray(double x_px, double y_px)>;
    using Apply = std::function<void(const Dab&)>;  // changes the surface before it returns
    using GoOn = std::function<bool()>;  // whether one more dab may be made before the call returns

    // The brush's radius and spacing are those of the whole stroke. Only hits on object 0 are sculpted.
    // std::invalid_argument when one of the `settings` is out of its range; their radius is not read, the
    // brush's is (Session::world_radius). `go_on` empty: always; a call makes at least one dab that is due.
    StrokeInput(const Brush& brush, Pick pick, CameraRay camera_ray, Apply apply,
                const StrokeSettings& settings = {}, GoOn go_on = {});

    // An event's dabs are not all made: only work() and begin() may be called.
    bool busy() const { return busy_; }
    void work();  // goes on with them

    void begin(const PointerEvent& event);  // the first dab, when it hits
    void move(const PointerEvent& event);
    // The pointer rested until then: an airbrush's dabs that are due by now. Not later than the next event.
    void rest(std::uint64_t time_us);
    void end(const PointerEvent& event);  // the last stretch

  private:
    struct Sample {
        PointerEvent at;
        PickHit hit;
        Ray ray;
    };

    struct Due {  // a dab, where the surface is not looked at yet
        PointerEvent at;
        glm::dvec3 direction;  // of the stroke there; zero: it has none
    };
    struct Placed {
        Sample sample;
        glm::dvec3 direction;
    };
    struct Arrival {
        PointerEvent at;  // of the brush, not the pointer
        bool last;
    };

    std::vector<Sample> pick_along(const std::vector<PointerEvent>& points) const;
    bool work_on();
    bool place_timed();
    bool place_waiting();
    void arrive(const Arrival& arrival);
    void stretch_to(const PointerEvent& to);
    void walk(const Sample& next, std::vector<Due>& dabs);
    void start_part(const Sample& first, std::vector<Due>& dabs);
    void place(const std::vector<Due>& dabs);
    void follow(const Sample& next, std::vector<Due>& dabs);
    PointerEvent pulled(const PointerEvent& event);
    void emit(const Sample& sample, glm::dvec3 direction);
    glm::dvec3 stamp_right(const Sample& sample, glm::dvec3 direction, std::uint32_t index) const;
    PickHit strayed(const Sample& sample, std::uint32_t index) const;
    double felt(double pressure) const;
    double size(double pressure) const;
    void draw_held(const PointerEvent& event, bool last);

    double radius_, spacing_;  // world units
    Pick pick_;
    CameraRay camera_ray_;
    Apply apply_;
    StrokeSettings settings_;
    bool grabs_, stamps_;
    StrokeTrail trail_;
    std::optional<PointerEvent> waiting_;  // the first dab of a stamp that lies along the stroke
    std::uint64_t start_us_ = 0;
    std::uint64_t timed_dabs_ = 0;       // of the airbrush so far
    std::uint32_t dabs_ = 0;             // so far
    PointerEvent brush_at_;              // where the string has pulled the brush
    std::optional<Sample> held_;         // where grab took hold
    glm::dvec3 drag_{0}, sent_drag_{0};  // of grab, world units: now, and at its last dab
    std::optional<Sample> last_;         // the newest point of the path; its hit may be a miss
    double since_dab_ = 0;               // arc length, world units
    GoOn go_on_;
    bool busy_ = false;
    std::vector<Placed> placed_;  // dabs to make, from `next_` on
    std::size_t next_ = 0;
    std::uint64_t rested_until_us_ = 0;
    std::optional<Arrival> arrival_;  // of the last event, behind the dabs of an airbrush until then
    bool ends_ = false;               // when all is made
};

// Rounds to the journal's units. Barycentrics outside the triangle (by rounding) are brought in.
Dab quantised_dab(const PickHit& hit, std::uint64_t time_us, double pressure);

}  // namespace relievo
