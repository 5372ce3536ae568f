// One editing session: scene, map, brushes and renderer. The window and the command line drive it by the same
// commands, and every command that changes something goes into the journal.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brushes/brush.h"
#include "brushes/height_map.h"
#include "brushes/map_file.h"
#include "renderer/renderer.h"

namespace relievo {

struct SessionOptions {
    std::string device;
    bool validation = false;
    bool for_window = false;
    bool with_renderer = true;              // false: edit maps without any Vulkan device
    std::size_t undo_budget = std::size_t{512} << 20;
    std::filesystem::path journal;          // empty: no journal is written
    std::string method;                     // empty: the scene's, else the registry's default
    std::map<std::string, double> parameters;
    int width = 0, height = 0;              // 0: the scene's
    TracePath path = TracePath::automatic;
};

struct StageTimes {  // milliseconds of the last dab or frame
    double edit_ms = 0, upload_ms = 0, bounds_ms = 0, refit_ms = 0, trace_ms = 0;
};

class Session {
  public:
    Session(const std::filesystem::path& scene_file, const SessionOptions& options);
    ~Session();

    const Scene& scene() const;
    HeightMap& map();  // of the edited object: objects[0]
    const Surface& surface() const;
    Renderer& renderer();  // throws std::logic_error without one
    vulkan::Context& context();
    const StageTimes& times() const;

    // The brush that the next stroke takes.
    Brush& brush();

    // Commands. Each is journaled when it is complete; a stroke is written and flushed at its end.
    void begin_stroke();                 // with brush()
    void dab(const Dab& dab);
    void end_stroke();
    void cancel_stroke();
    bool in_stroke() const;
    bool undo();  // false: nothing to undo
    bool redo();
    void set(const std::string& key, double value);  // "amplitude", "midlevel", "method.dt", ...
    void save(const std::filesystem::path& path);    // the map; format by extension, the origin's kept where equal
    void revert();

    bool unsaved() const;
    bool can_undo() const;
    bool can_redo() const;
    std::size_t undo_bytes() const;
    std::size_t undo_budget() const;
    std::size_t clipped_texels() const;
    std::optional<std::filesystem::path> map_path() const;  // where save() last wrote or the map came from

    // Called after map texels changed on the screen: the world-space ball that changed.
    struct Touched {
        glm::vec3 centre;
        float radius;
    };
    std::optional<Touched> last_dab() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace relievo
