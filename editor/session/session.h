// One editing session: scene, map, brushes and renderer. The window and the command line drive it by the same
// commands, and every command that changes something goes into the journal.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brushes/advance.h"
#include "brushes/alpha.h"
#include "brushes/brush.h"
#include "brushes/colour_map.h"
#include "brushes/height_map.h"
#include "brushes/map_file.h"
#include "brushes/surface.h"
#include "editor/session/journal.h"
#include "editor/session/stroke_settings.h"
#include "renderer/procedural/procedural_source.h"
#include "renderer/renderer.h"
#include "renderer/scene/scene.h"

namespace relievo {

struct SessionOptions {
    std::string device;
    bool validation = false;
    bool for_window = false;
    bool with_renderer = true;                         // false: edit maps without any Vulkan device
    std::size_t undo_budget = std::size_t{512} << 20;  // bytes
    std::filesystem::path journal;                     // a new file to record the session in; empty: none
    bool recovery = false;      // also record it in the user's state folder (recovery.h)
    std::filesystem::path map;  // start from this map instead of the scene's; save() still means the scene's
    std::filesystem::path colour_map;  // likewise, instead of the edited object's albedo map
    std::filesystem::path mask;        // start with this mask; empty: with none
    bool find_mask = false;            // start with the one that was saved beside the scene's map, if any
    std::string method;         // empty: the scene's, else the registry's default
    std::map<std::string, double> parameters;  // of the method, over the scene's
    int width = 0, height = 0;                 // pixels; 0: the scene's
    TracePath path = TracePath::automatic;
    Advance opening{};  // asked by the constructor, on its thread
};

struct StageTimes {  // milliseconds of the last dab, of what was uploaded since it (many dabs, then), and of the last frame
    double edit_ms = 0, upload_ms = 0, bounds_ms = 0, refit_ms = 0, trace_ms = 0;
};

// Where a save writes what is not the map. Empty: not at all, and that stays unsaved.
struct SaveWith {
    std::filesystem::path colours = {}, mask = {};
    bool map = true;  // false: the map's file holds it already, and stays untouched
};

class Session {
  public:
    // Throws std::invalid_argument on bad input (scene, mesh, map, journal path, method), std::runtime_error
    // when Vulkan fails or has no device.
    Session(const std::filesystem::path& scene_file, const SessionOptions& options);
    // Removes the recovery journal when nothing is unsaved; else it stays for the next start.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    const Scene& scene() const;  // as set() left it
    HeightMap& map();            // of the edited object: objects[0]
    const HeightMap& map() const;
    // Of procedural heights the map is the exemplar, which no stroke edits; bake() makes a map of them.
    std::shared_ptr<const ProceduralSource> procedural(std::size_t object) const;  // empty: the heights are a map
    // Throws std::invalid_argument where the edited object's are procedural, with what is to be done before `then`, a
    // verb.
    void require_map(const std::string& then) const;
    const HeightMap& map_of(std::size_t object) const;  // every object's; std::out_of_range beyond them
    std::uint64_t map_revision() const;                 // changes whenever map() does
    // What tools leave as it is, of the edited object's map: 65535 protects, 0 is free. Null: nothing was
    // ever masked.
    const HeightMap* mask() const;
    std::uint64_t mask_revision() const;  // changes whenever mask() does
    std::uint64_t mask_hash() const;      // HeightMap::hash() of it; where there is none, of one that is free all over
    // What strokes paint, of the edited object: its albedo map, or what make_colours() made. Null: there is
    // none.
    const ColourMap* colours() const;
    std::uint64_t colour_revision() const;  // changes whenever colours() does
    std::uint64_t surface_revision() const;  // whenever either does: what is seen of the edited object
    // sRGB-encoded red, green and blue of the surface at a hit, [0, 1]: the nearest texel of the colour map,
    // or, where the object has none in this session, the material's albedo.
    std::array<float, 3> colour_at(const PickHit& hit) const;
    const Surface& surface() const;
    bool has_renderer() const;
    // With all that dabs have changed uploaded. std::logic_error without one.
    Renderer& renderer();
    // What dabs change is uploaded where somebody looks at it, many dabs at once: by renderer(), trace() and the end
    // of the stroke. For those who keep a renderer: before they pick or trace in a stroke.
    void show_edits();
    vulkan::Context& context();
    const StageTimes& times() const;

    // A second renderer over the same scene and maps, by a method of its own, to compare two: it follows
    // every command but the method's, and no journal hears of it. Made at the first call; a later one changes
    // its method. Throws as Renderer does. `advance` here, of make_colours() and of set() (methods and procedural heights)
    // may stop it: then all is as it was.
    Renderer& compare_with(const MethodChoice& method, const Advance& advance = {});
    void stop_comparing();
    // Renderer::make_ready, of both. Stopped, the surface is shown as before, and what is compiled stays so.
    void make_ready(vulkan::Pass pass, const Advance& advance);

    // What a journal of this session starts with; its `scene` is absolute.
    const JournalHeader& header() const;

    // The brush that the next stroke takes. Its first radius is a tenth of the edited mesh's.
    Brush& brush();
    const Brush& brush() const;
    // The image that the stamp tool's next stroke presses in; null at first.
    const std::shared_ptr<const Alpha>& alpha() const;
    void set_alpha(std::shared_ptr<const Alpha> alpha);  // its path absolute: journals name it
    // Where the clone tool takes the relief from. std::out_of_range when the mesh has no such face or the
    // barycentrics are outside it.
    void set_clone_source(const FacePoint& source);
    // Where a dab at `target` would take it from; empty before set_clone_source().
    std::optional<FacePoint> clone_source(const FacePoint& target) const;
    // How the next stroke's gestures become dabs.
    StrokeSettings& stroke_settings();
    // brush().radius, or where stroke_settings() counts it in pixels or texels, that many where the pointer
    // meets the surface, in world units. `ray` and `next_ray` go through the pointer and one pixel beside it.
    // On a miss, pixels are taken at the middle of the mesh, and texels of its first face that has any.
    float world_radius(const PickHit& hit, const Ray& ray, const Ray& next_ray) const;

    // Commands. Each is journaled when it is complete; a stroke is written and flushed at its end, with its
    // dabs; one without dabs leaves no trace. All but dab, end_stroke and cancel_stroke throw
    // std::logic_error in a stroke.
    // With brush(). std::invalid_argument when a setting is out of its range, the heights are procedural, stamp
    // has no image, clone no source, or the brush paints and there is no colour map of the map's size.
    void begin_stroke();
    // Copies that the brush's symmetry makes are found here, and so are clone's sources and the turn that the
    // dab holds of them; both are journaled with it. std::out_of_range when the mesh has no such face.
    void dab(const Dab& dab);
    // The same with the places of the copies and the sources given, as a journal has them: one for each copy,
    // and for clone one for the dab itself and one for each copy.
    void dab(const Dab& dab, std::span<const FacePoint> copies, std::span<const FacePoint> sources = {});
    void end_stroke();
    void cancel_stroke();
    bool in_stroke() const;
    // False: nothing to undo. `advance` may stop it, and what follows: then all is as it was.
    bool undo(const Advance& advance = {});
    bool redo(const Advance& advance = {});
    // One undo step.
    void change_mask(MaskCommand command, const Advance& advance = {});
    // A colour map of the map's size, filled with the material's albedo, that the renderer shows in the
    // albedo's place. No undo step. std::invalid_argument where there is one already, on bits other than 8
    // and 16, while the heights are procedural, or when memory would not do.
    void make_colours(int bits, const Advance& advance = {});
    void set(const std::string& key, const SetValue& value, const Advance& advance = {});  // keys: settings.h; std::invalid_argument
    void set_camera(const Camera& camera);
    // Procedural heights become a map of that many texels, to be sculpted; there is no way back but to open the scene
    // again. Undo steps end here. std::invalid_argument when the heights are a map, or cannot be baked (bake.h).
    void bake(const ImageSize& size, const Advance& advance = {});
    // Writes the map and what `with` says. The extension names the format; metadata and exact values of the file that was loaded
    // are kept where the format is the same. std::invalid_argument when it cannot be written (the old file
    // stays whole), and while the heights are procedural. Colour map and mask are written first; a mask that
    // protects nothing has no file, and one that is there goes. `advance` may stop this and the two exports below.
    void save(const std::filesystem::path& path, const SaveWith& with, const Advance& advance = {});
    void save(const std::filesystem::path& path) { save(path, save_with(path)); }
    // All that is to be saved with the map; where that is as its file has it, the rest alone.
    SaveWith save_with(const std::filesystem::path& map) const;
    // Where save() writes the colour map when it writes the map to `map`: its own file where the map goes to
    // its own, else a new NAME_colour.png (or the ending that it has) beside it. Empty where there is nothing
    // to write: no colour map, or one that its file holds already.
    std::filesystem::path colour_path_for(const std::filesystem::path& map) const;
    // The same of the mask: beside the map (session_mask.h), where opening the scene finds it. Empty where the file
    // there, or that there is none, says what the mask is.
    std::filesystem::path mask_path_for(const std::filesystem::path& map) const;
    // Writes the map as another file, with the values of `range` where the format holds floats; what save()
    // would write, and whether that is due, stays. std::invalid_argument as save().
    void export_map(const std::filesystem::path& path, MapFormat format, MapRange range,
                    const Advance& advance = {}) const;
    // The same of the colour map, with its bits: PNG or TIFF. std::invalid_argument where there is none.
    void export_colours(const std::filesystem::path& path, const Advance& advance = {}) const;
    // Undoes or redoes back to what was last saved or loaded. False when those steps were dropped for memory.
    bool revert(const Advance& advance = {});

    bool unsaved() const;  // map, colour map or mask differs from what was last saved or loaded
    // Steps so far that changed anything, those included that the undo memory does not hold: of them, can_undo()
    // is false at once.
    std::uint64_t steps_made() const;
    bool can_undo() const;
    bool can_redo() const;
    std::size_t undo_bytes() const;
    std::size_t undo_budget() const;
    std::size_t clipped_texels() const;
    // The colour map's own file: the scene's, or where save() last wrote it.
    std::optional<std::filesystem::path> colour_path() const;
    std::optional<std::filesystem::path> map_path() const;  // where save() last wrote or the map came from

    // The map and what `with` names, as they are now, are what the files hold: replaying the record of a save says
    // so.
    void confirm_saved(const std::filesystem::path& path, const SaveWith& with = {});
    // The user chose to lose what is unsaved: the recovery journal goes.
    void discard_recovery();
    // Why a journal could not be written (a full disk, say); empty while all is well. The session goes on
    // without.
    std::string journal_error() const;

    // The ball of the displaced surface that the last dab of the stroke may have changed (rebased world
    // space).
    struct Touched {
        glm::vec3 centre;
        float radius;
    };
    std::optional<Touched> last_dab() const;  // empty before a stroke's first dab

    // Traces a window afresh in preview quality, and times it as trace_ms. Needs a renderer.
    void trace(const PixelRect& window);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace relievo
