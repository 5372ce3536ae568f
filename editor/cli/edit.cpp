// relievo edit [SCENE]: the window.
#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "editor/cli/verbs.h"
#include "editor/session/derived_scene.h"

namespace relievo {
namespace {

struct EditOptions {
    std::string scene, journal, frame_log;
    double most_fps = 0;
    CommonOptions common;
    MethodOptions method;
    PictureOptions window;
};

int run_edit(const EditOptions& options, const EditorEntry& editor) {
    const bool bare_mesh = kind_of_file(options.scene) == FileKind::mesh;
    EditRequest request{bare_mesh ? scene_of_mesh(options.scene).string() : options.scene, options.frame_log,
                        options.most_fps, session_options(options.common, options.method, options.window)};
    request.session.for_window = true;
    request.session.recovery = true;
    request.session.journal = options.journal;
    if (!editor)
        throw std::runtime_error(
            "this build has no window; install libglfw3-dev and libimgui-dev and build again, or use render "
            "and replay");
    return editor(request);
}

}  // namespace

void add_edit(CLI::App& app, Command& command, const EditorEntry& editor) {
    CLI::App& verb = *app.add_subcommand("edit", "Sculpt in a window (what relievo does without a verb)");
    const auto options = std::make_shared<EditOptions>();
    verb.add_option("SCENE", options->scene, "Scene file (JSON), or a mesh for a new map");
    verb.add_option("--journal", options->journal, "Record the session in this new file")->type_name("FILE");
    verb.add_option("--size", options->window.size, "Size of the window, like 1440x860")->type_name("WxH");
    verb.add_option("--most-fps", options->most_fps, "Show at most so many frames a second")
        ->type_name("N")
        ->check(CLI::Range(0.5, 1000.0));
    verb.add_option("--frame-log", options->frame_log, "Write when frames and dabs were shown, as JSON Lines")
        ->type_name("FILE");
    add_common(verb, options->common);
    add_method(verb, options->method);
    verb.callback([options, &command, &editor] {
        command = [options, &editor] { return run_edit(*options, editor); };
    });
}

}  // namespace relievo
