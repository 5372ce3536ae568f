// What the desk opens, saves and leaves.
#include <exception>
#include <stdexcept>
#include <system_error>

#include "editor/gui/desk.h"
#include "editor/session/preferences.h"
#include "editor/session/render_output.h"

namespace relievo::gui {

void Desk::save() {
    if (const auto path = session.map_path()) {
        save_to(*path);
    } else {
        view.wanted = Dialog::save_as;
    }
}

void Desk::save_to(const std::filesystem::path& path, const std::function<void()>& done,
                   const std::function<void(const std::string&)>& failed) {
    attempt([&] {
        const SaveWith with = session.save_with(path);
        work = LongWork{"Saving " + path.filename().string(),
                        [this, path, with](const Advance& advance) { session.save(path, with, advance); },
                        [this, path, with, done] {
                            tell_saved(path, with);
                            if (done) done();
                        },
                        failed};
    });
}

void Desk::tell_saved(const std::filesystem::path& path, const SaveWith& with) {
    std::string text = "Saved ";
    int left = with.map + !with.colours.empty() + !with.mask.empty();
    const auto tell = [&](const std::filesystem::path& file, bool first) {
        text += first ? file.string() : file.filename().string();
        if (--left > 0) text += left == 1 ? " and " : ", ";
    };
    if (with.map) tell(path, true);
    if (!with.colours.empty()) tell(with.colours, !with.map);
    if (!with.mask.empty()) tell(with.map || !with.colours.empty() ? "the mask" : with.mask, true);
    toasts.info(text);
    offer_scene_of(path, session.colours() ? session.colour_path().value_or("") : "");
}

void Desk::offer_scene_of(const std::filesystem::path& map, const std::filesystem::path& colours) {
    const Scene& scene = session.scene();
    const SceneObject& object = scene.objects.front();
    std::error_code ignored;
    const bool names_map = std::filesystem::equivalent(map, object.displacement.map, ignored);
    const bool names_colours = colours.empty() || colours == object.material.albedo_map;
    if ((names_map && names_colours) || offered_ == std::pair(map, colours)) return;
    attempt([&] {
        const auto fresh = names_colours ? scene_with_map(scene.path, map) : scene_with_maps(scene.path, map, colours);
        change_preferences([&](Preferences& p) { add_recent(p, fresh); });
        offered_ = {map, colours};
        toasts.info("The scene does not name what was saved: open " + scene_name(fresh) + " from Recent, which does");
    });
}

void Desk::open_file(const std::filesystem::path& path) {
    std::filesystem::path scene = path;
    const bool can = attempt([&] {
        switch (kind_of_file(path)) {
            case FileKind::scene:
                return;
            case FileKind::mesh:
                scene = scene_of_mesh(path);
                return;
            case FileKind::map:
                scene = scene_with_map(session.scene().path, path);
                return;
            case FileKind::unknown:
                throw std::invalid_argument(
                    path.string() +
                    ": is no scene (.json), mesh (.obj, .ply, .off) or map (.png, .tif, "
                    ".tiff, .exr)");
        }
    });
    if (can) leave({Departure::Kind::open, scene, {}});
}

void Desk::open_files(const std::vector<std::filesystem::path>& paths) {
    if (paths.size() == 1) return open_file(paths.front());
    std::vector<std::filesystem::path> scenes, meshes, maps;
    for (const auto& path : paths) {
        const FileKind kind = kind_of_file(path);
        if (kind == FileKind::scene) scenes.push_back(path);
        if (kind == FileKind::mesh) meshes.push_back(path);
        if (kind == FileKind::map) maps.push_back(path);
    }
    if (scenes.size() == 1) return open_file(scenes.front());
    std::filesystem::path scene;
    const bool can = attempt([&] {
        if (!scenes.empty() || meshes.size() != 1 || maps.size() != 1)
            throw std::invalid_argument(
                "Several files were dropped: drop one scene, or one mesh and one map, or one file alone");
        scene = scene_with_map(scene_of_mesh(meshes.front()), maps.front());
    });
    if (can) leave({Departure::Kind::open, scene, {}});
}

void Desk::save_picture(const std::filesystem::path& path) {
    attempt([&] {
        work = LongWork{"Saving " + path.filename().string(),
                        [this, path](const Advance& all) {
                            constexpr double kTraced = 0.3;  // part of the time, about
                            live.come_to_rest(within(all, 0, kTraced));
                            const Advance advance = within(all, kTraced, 1);
                            // A view of layers leaves the light as it was.
                            const bool no_light = shows_layers(live.view());
                            if (is_png(path) && no_light) return write_png(path, live.layers(), advance);
                            if (is_png(path)) return write_render(live.parts(), path, {}, advance);
                            const double share = no_light ? 0.4 : 0;
                            if (no_light) render_afresh(live.parts(), within(advance, 0, share));
                            write_render(live.parts(), path, {Layer::depth, Layer::normal, Layer::uv, Layer::id},
                                         within(advance, share, 1));
                        },
                        [this, path] {
                            view.picture_folder = path.parent_path();
                            toasts.info("Saved " + path.string());
                        }};
    });
}

std::filesystem::path Desk::beside_scene(const std::string& ending) const {
    std::filesystem::path own = session.scene().path;
    if (is_derived(own)) own = session.map_path().value_or(session.scene().objects.front().mesh_path);
    return own.parent_path() / (own.stem().string() + ending);
}

void Desk::revert() {
    attempt([&] {
        if (!session.unsaved()) {
            toasts.info("Nothing to revert: the map is as it was saved");
            return;
        }
        const auto back = [this](const Advance& advance) {
            if (!session.revert(advance))
                throw std::runtime_error(
                    "The steps back to the saved map are gone from the undo memory; open the file again");
        };
        work = LongWork{"Reverting", back, [this] { live.restart(); },
                        [this](const std::string& trouble) {
                            live.restart();
                            toasts.error(trouble);
                        }};
    });
}

void Desk::leave(const Departure& wanted) {
    if (session.in_stroke()) return;
    if (!session.unsaved()) {
        departure = wanted;
        return;
    }
    pending = wanted;
    view.wanted = Dialog::unsaved;
}

void Desk::export_colours(const std::filesystem::path& path) {
    attempt([&] {
        work = LongWork{"Saving " + path.filename().string(),
                        [this, path](const Advance& advance) { session.export_colours(path, advance); },
                        [this, path] { toasts.info("Saved " + path.string()); }};
    });
}

}  // namespace relievo::gui
