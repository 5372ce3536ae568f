// The window's life: opens scenes one after another until the user quits.
#include "editor/gui/editor.h"

#include <imgui.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "editor/gui/app.h"
#include "editor/gui/file_dialog.h"
#include "editor/session/recovery.h"
#include "editor/session/replay.h"
#include "renderer/vulkan/context.h"

namespace relievo {
namespace {

using gui::Departure;

constexpr gui::PixelSize kWindow{1440, 860};

// The start without a scene: a browser, and nothing else. Empty when the user closes it.
std::optional<std::filesystem::path> ask_for_scene(gui::Window& window, const SessionOptions& options) {
    vulkan::Context context(vulkan::ContextOptions{options.device, options.validation, true});
    gui::Screen screen(context, window);
    gui::FileDialog files;
    files.open(gui::scene_purpose(), {});
    std::optional<std::filesystem::path> chosen;
    while (!chosen && files.is_open() && !window.close_wanted()) {
        window.wait(0.05);
        window.events().clear();
        if (!screen.begin()) continue;
        chosen = files.draw();
        screen.end({}, 0, 0);
    }
    return chosen;
}

std::unique_ptr<Session> open_session(const Departure& to, SessionOptions options) {
    if (to.kind != Departure::Kind::restore) return std::make_unique<Session>(to.scene, options);
    const AbandonedJournal& abandoned = *to.abandoned;
    options.map = abandoned.base_map;
    auto session = std::make_unique<Session>(abandoned.scene, options);
    replay(read_journal(abandoned.journal), *session);
    remove_recovery(abandoned.journal);
    return session;
}

// Opens scene after scene. A scene that cannot be opened from within the window leaves the last one open.
void run_scenes(gui::Window& window, gui::FrameLog& log, double most_fps, Departure to,
                SessionOptions options) {
    std::string message;
    bool first = true;
    std::filesystem::path last;
    while (to.kind != Departure::Kind::quit) {
        std::unique_ptr<Session> session;
        try {
            session = open_session(to, options);
            message.clear();
        } catch (const std::exception& trouble) {
            if (first) throw;
            message = trouble.what();
            session = open_session({Departure::Kind::open, last, {}}, options);
        }
        last = session->scene().path;
        gui::Screen screen(session->context(), window);
        gui::App app(window, screen, *session, log, most_fps, message);
        if (std::exchange(first, false)) app.offer(find_abandoned_journals());
        to = app.run();
        options.journal.clear();  // the named journal records the first scene alone
        options.map.clear();
    }
}

}  // namespace

int run_editor(const EditorOptions& options) {
    {
        SessionOptions session = options.session;
        const gui::PixelSize size{session.width > 0 ? session.width : kWindow.width,
                                  session.height > 0 ? session.height : kWindow.height};
        session.width = session.height = 0;
        gui::FrameLog log(options.frame_log);
        gui::Window window(size);
        std::optional<std::filesystem::path> scene = options.scene;
        if (scene->empty()) scene = ask_for_scene(window, session);
        if (scene) run_scenes(window, log, options.most_fps, {Departure::Kind::open, *scene, {}}, session);
    }
    if (const int messages = vulkan::Context::validation_messages(); messages > 0)
        throw std::runtime_error("the Vulkan validation layers had " + std::to_string(messages) +
                                 " messages; they stand above");
    return 0;
}

}  // namespace relievo
