// What a session holds, and the one way in which its edits reach map, journal and device. Private to
// session*.cpp.
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "brushes/sculptor.h"
#include "editor/session/recorder.h"
#include "editor/session/scene_input.h"
#include "editor/session/session.h"
#include "editor/session/session_colours.h"
#include "editor/session/session_mask.h"
#include "editor/session/session_view.h"
#include "editor/session/steps.h"
#include "editor/session/surface/clone_source.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/symmetric_dabs.h"

namespace relievo {
namespace fs = std::filesystem;

// What a save's record knows its files by; 0 of what is not saved.
struct SavedHashes {
    std::uint64_t map = 0, colours = 0, mask = 0;
};

struct Session::State {
    State(const fs::path& scene_file, const SessionOptions& given);

    const fs::path& albedo_map() const { return scene.objects.front().material.albedo_map; }

    const Displacement& displacement() const { return scene.objects.front().displacement; }

    const MethodChoice* traced_by() const { return options.with_renderer ? &scene.method : nullptr; }

    void open_view();
    // After a setting has changed, of any scope but heights.
    void follow(SettingScope scope, const Advance& advance);
    std::vector<const HeightMap*> maps() const;
    // Other heights for the edited object: another map or exemplar where `fresh` holds one. Undo steps end
    // there. Throws before anything has changed.
    void take_heights(const Displacement& wanted, std::optional<LoadedMap> fresh, const Advance& advance);
    // What brushes work on, over file.map.
    void make_surface();
    // The mask that the session starts with, if any.
    void load_start_mask();
    // Hands the colour map to the sculptor, once. Throws where it has another size than the map.
    void allow_painting();
    // The finder of the copies of a stroke under way.
    const SymmetricDabs& symmetry();

    void require_no_stroke() const {
        if (sculptor->in_stroke()) throw std::logic_error("end the stroke first");
    }

    // Runs one edit of the map and books it. What it changed waits for show_edits(): what happened to the map is
    // recorded even if the device fails to show it.
    template <typename Edit, typename Book>
    void apply(Edit edit, Book book) {
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        const std::vector<TexelRect> rects = edit();
        times = {};
        times.edit_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        const std::vector<TexelRect> painted = sculptor->take_painted();
        if (!rects.empty()) ++revision;
        if (!painted.empty()) ++colour_revision;
        book();
        if (!view) return;
        unshown.insert(unshown.end(), rects.begin(), rects.end());
        unshown_colours.insert(unshown_colours.end(), painted.begin(), painted.end());
    }
    void show_edits();  // where dabs overlap, their texels are uploaded once

    // What a step changed.
    struct Change {
        std::vector<TexelRect> heights, painted;
    };
    // Undo and redo; session_steps.cpp.
    bool take_step(bool forth, const Advance& advance);
    Change swap_step(bool forth);
    void show(const Change& change, const Advance& advance, Change& shown);  // `shown`: of it, when stopped, too

    SavedHashes hashes_of(const SaveWith& with, const WorkPart& part) const;
    void book_save(const fs::path& path, const SaveWith& with, const SavedHashes& hashes);
    std::uint64_t mask_hash() const;

    // `write` writes `path`. Where the session began with that, the recovery journal keeps it first.
    void replace_file(const fs::path& path, const std::function<void()>& write) {
        for (const auto& [which, start] : start_files())
            if (is_file(start, path)) recorder->keep_base(which, start);
        write();
        for (const auto& [which, start] : start_files())
            if (is_file(start, path)) recorder->base_replaced(which);
    }
    std::array<std::pair<BaseFile, fs::path>, 3> start_files() const {
        return {{{BaseFile::map, start_map}, {BaseFile::colours, colours.start_file()}, {BaseFile::mask, start_mask}}};
    }
    bool is_own_map(const fs::path& map) const;  // where save() last wrote it or it came from
    bool is_in_its_file(const fs::path& map) const;  // as it is now
    static bool is_file(const fs::path& file, const fs::path& other) {
        std::error_code ignored;
        return !file.empty() && fs::equivalent(file, other, ignored);
    }

    // On the base mesh, and within its face.
    bool exists(const FacePoint& point) const {
        return point.face < surface->face_count() && point.b1 <= Dab::kBarycentricOne &&
               point.b2 <= Dab::kBarycentricOne - point.b1;
    }
    // Of procedural heights nothing can be saved, a mask of the exemplar no more than the rest.
    void add_step(bool changes_heights, bool changes_colours, bool changes_mask) {
        steps.add(!changes_mask || !source);
        height_steps.add(changes_heights);
        colour_steps.add(changes_colours);
        mask_steps.add(changes_mask && !source);
    }
    std::array<Steps*, 4> all_steps() { return {&steps, &height_steps, &colour_steps, &mask_steps}; }
    void undo_step() {
        for (Steps* each : all_steps()) each->undo();
    }
    void redo_step() {
        for (Steps* each : all_steps()) each->redo();
    }

    void opened(double part) const { tell(options.opening, part, kOpeningStopped); }  // by the constructor
    void restart_image() {
        if (view) view->restart();
    }
    bool masks() const { return stroke.brush.tool == Tool::mask; }  // of the stroke: its picture stays

    SessionOptions options;
    Scene scene;
    fs::path start_map;   // empty: a new flat map
    fs::path start_mask;  // empty: none
    LoadedMap file;
    std::vector<LoadedMap> others;  // of the objects that are not edited, where there is a renderer
    std::vector<std::shared_ptr<const ProceduralSource>> other_sources;
    std::uint64_t revision = 0;                      // of file.map
    std::shared_ptr<const ProceduralSource> source;  // of file.map as the exemplar; empty: it is the heights
    SessionColours colours;
    std::uint64_t colour_revision = 0;
    bool can_paint = false;  // the sculptor has the colours
    std::optional<MeshSurface> surface;
    std::optional<Sculptor> sculptor;
    std::unique_ptr<SessionView> view;
    JournalHeader header;
    std::unique_ptr<Recorder> recorder;
    std::optional<fs::path> map_path;
    Steps steps, height_steps, colour_steps, mask_steps;  // of all, and of each alone
    bool starts_as_file = true;  // the state that height_steps began with, or was saved, is the file's
    Brush brush;
    StrokeSettings stroke_settings;
    std::shared_ptr<const Alpha> alpha;  // of stamp
    CloneSource clone_source;
    StrokeOp stroke;                         // under way
    std::size_t copies = 0;                  // of each of its dabs
    std::optional<SymmetricDabs> symmetric;  // made at a stroke's first dab that needs it
    std::optional<Touched> touched;
    StageTimes times;
    std::vector<TexelRect> unshown, unshown_colours;  // changed since the device was last told
};

}  // namespace relievo
