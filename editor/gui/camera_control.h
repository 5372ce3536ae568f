// Moving the camera around its look_at point: a turntable about the camera's up vector.
#pragma once

#include "editor/gui/window.h"
#include "renderer/scene/scene.h"

namespace relievo::gui {

// Pointer movement in pixels, right and down positive; the picture's height gives the scale.
Camera orbited(const Camera& camera, double dx_px, double dy_px, int height_px);
Camera panned(const Camera& camera, double dx_px, double dy_px, int height_px);  // the look_at plane follows
// Notches: positive is nearer. Where look_at is so near that its direction is lost in rounding, or the scene
// too small to be seen, there is no way back: it ends before.
Camera zoomed(const Camera& camera, double notches, const Scene& scene);

// Another field of view (degrees, vertical), from where the plane through look_at is seen as large as before.
Camera with_fov(const Camera& camera, double fov_deg);

enum class Axis { front, right, top };
Camera looking_along(const Camera& camera, Axis axis);  // same distance; opposite when it looks so already

// Keeps the direction of view and shows all objects.
Camera framing_all(const Scene& scene, PixelSize picture);

}  // namespace relievo::gui
