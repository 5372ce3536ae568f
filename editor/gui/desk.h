// What panels, keys and dialogs share: the session, and the commands that they give it. Every change goes
// through the session, which journals it; what it refuses becomes a message on screen.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/gui/alpha_shelf.h"
#include "editor/gui/brush_cursor.h"
#include "editor/gui/live_picture.h"
#include "editor/gui/long_work.h"
#include "editor/gui/prism_overlay.h"
#include "editor/gui/ray_panel.h"
#include "editor/gui/toasts.h"
#include "editor/session/derived_scene.h"
#include "editor/session/recovery.h"
#include "editor/session/session.h"

namespace relievo::gui {

// Where the program goes when it leaves the open scene.
struct Departure {
    enum class Kind { quit, open, restore } kind = Kind::quit;
    std::filesystem::path scene;                // open
    std::optional<AbandonedJournal> abandoned;  // restore
};

// A dialog that the next frame opens.
enum class Dialog {
    none,
    keys,
    open,
    new_map,
    save_as,
    export_map,
    save_picture,
    unsaved,
    recovery,
    exemplar,
    alpha,
    export_colours
};

// What follows the pointer until a click: a setting of the brush, or the light.
enum class BrushDrag { none, radius, strength, rotation, light };

// Red, green and blue of a brush, sRGB-encoded.
using PaintColour = std::array<float, 3>;
inline PaintColour colour_of(const Brush& brush) {
    return {brush.red, brush.green, brush.blue};
}
inline void set_colour(Brush& brush, const PaintColour& colour) {
    brush.red = colour[0], brush.green = colour[1], brush.blue = colour[2];
}

// What is shown, and no more than that: none of it is journaled.
struct ViewState {
    bool interface_hidden = false;
    float side_width = 0;  // pixels; 0 until the first layout
    Dialog wanted = Dialog::none;
    BrushDrag brush_drag = BrushDrag::none;
    bool screenshot_wanted = false;
    double full_fov_deg = 40;  // what flatten_view() goes back to
    MethodChoice second{};     // of the right part while the picture is split, and the next time
    bool hint = false;         // for a first stroke
    std::vector<PaintColour> recent_colours{};  // the newest first
    int colour_bits = 8;                        // of a colour map that the first stroke makes
    std::optional<WorkShown> work{};  // under way for long enough to be shown
    std::filesystem::path picture_folder{};  // of the last saved picture; empty: none yet
    bool asking = false;       // a click asks what happened to the pixel's ray, and does not sculpt
};

class Desk {
  public:
    Desk(Session& open_session, LivePicture& live_picture, LiveReference& live_reference, Toasts& messages)
        : session(open_session), live(live_picture), reference(live_reference), toasts(messages) {}

    Session& session;
    LivePicture& live;
    LiveReference& reference;
    Toasts& toasts;
    BrushCursor cursor;
    AlphaShelf alphas;
    ViewState view;
    PrismOverlay prisms;
    RayPanel why;
    std::vector<AbandonedJournal> abandoned;  // offered for recovery
    std::optional<Departure> pending;         // waits for the answer about unsaved work
    std::optional<Departure> departure;       // decided
    std::optional<LongWork> work;             // between two frames

    void set(const std::string& key, const SetValue& value);  // settings.h; what may take long between two frames
    void set_exemplar(const std::filesystem::path& path);     // of procedural heights
    void set_camera(const Camera& camera);
    void undo() { take_step(false); }  // between two frames
    void redo() { take_step(true); }
    void save();  // asks for a path where there is none yet
    // Between two frames; then `done` or, in the place of a message, `failed`.
    void save_to(const std::filesystem::path& path, const std::function<void()>& done = {},
                 const std::function<void(const std::string& trouble)>& failed = {});
    void bake(const ImageSize& size);
    void open_file(const std::filesystem::path& path);  // a scene, a mesh, or a map for the edited object
    // What was dropped together: a scene (the rest is taken for its parts), or a mesh and its map; else one file alone.
    void open_files(const std::vector<std::filesystem::path>& paths);
    // What is seen, without the interface; an EXR has light and the layers of the surface in any view.
    void save_picture(const std::filesystem::path& path);
    void revert();                           // to what was last saved or loaded
    void leave(const Departure& departure);  // asks first when work is unsaved
    void scale_radius(double factor);
    void start_drag(BrushDrag drag);
    void set_alpha(const std::filesystem::path& path);  // of the stamp
    // Where clone takes its relief from: what the picture's pixel shows; pixels as Renderer::camera_ray takes
    // them.
    void set_clone_source(double x_px, double y_px);
    // Views kept between runs; numbers from 1 on.
    void keep_camera(int number);
    void go_to_camera(int number);
    // All lights and the sky about an axis through look_at, in world space.
    void turn_light(double degrees, const glm::dvec3& axis);
    // Where the lights and the zenith lie, as in the scene that had them; as many lights as now.
    void place_lights(const std::vector<Light>& lights, const glm::dvec3& sky_up);
    // As a drag over the picture turns them, degrees: about the camera's up vector, and to the viewer.
    void turn_light(double across_deg, double down_deg);
    void flatten_view();                     // to nearly parallel lines of sight, or back
    void toggle_symmetry(std::size_t axis);  // 0 to 2: x, y, z
    void choose_tool(std::size_t index);     // into tools(); beyond them, nothing happens
    void next_paint();                       // height, colour, both
    void pick_colour();                      // from the surface under the pointer, for the brush
    // Before a stroke by that brush: what it still needs (a colour map, where it paints; where it masks, the program that
    // tells what the mask lies on) is made between two frames. `then`: what waits for it; else it comes at once.
    void prepare_stroke(const Brush& brush, const std::function<void()>& then);
    // Between two frames, before the picture is traced: where there is a mask to be shown, what tells what it lies on.
    void prepare_picture();
    void keep_colour(const Brush& brush);  // among the recent ones, where it paints with one
    void export_colours(const std::filesystem::path& path);
    void set_view(View view);
    // What happened to the ray through the renderer's pixel; `method`: the renderer's.
    void ask_why(Renderer& renderer, const std::string& method, const glm::ivec2& pixel);
    void show_mask(bool wanted);
    void change_mask(MaskCommand command);
    void split(bool wanted);  // the right part of the picture by the second method
    void set_second(const MethodChoice& method);

    // For a new file: the scene's name with that ending, beside it. A scene that the program wrote itself lies out of the
    // user's sight: its map, or else its mesh, takes its place.
    std::filesystem::path beside_scene(const std::string& ending) const;

    // The edited mesh's bounding-sphere radius: what brush sizes are measured by.
    float mesh_radius() const { return session.scene().objects.front().mesh.sphere_radius; }

    // Runs a command; what it throws is shown. False when it threw, or when a stroke is under way.
    bool attempt(const std::function<void()>& command);

  private:
    void take_step(bool forth);
    void finish_work();
    bool unready_for_mask() const;
    void prepare_for_mask(const std::function<void()>& then);
    void turn_light(const glm::dmat3& turn);
    void tell_saved(const std::filesystem::path& path, const SaveWith& with);
    // Where the scene would be opened again without these files, one with them, among the recent ones.
    void offer_scene_of(const std::filesystem::path& map, const std::filesystem::path& colours);

    std::pair<std::filesystem::path, std::filesystem::path> offered_;  // last
};

}  // namespace relievo::gui
