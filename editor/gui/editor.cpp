// The window's life: opens scenes one after another until the user quits.
#include "editor/gui/editor.h"

#include <imgui.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "editor/gui/app.h"
#include "editor/gui/file_dialog.h"
#include "editor/gui/wait_screen.h"
#include "editor/session/derived_scene.h"
#include "editor/session/memory_estimate.h"
#include "editor/session/preferences.h"
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
    files.open(gui::open_purpose(), {});
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

// On a thread of its own, so that the window is drawn meanwhile: by `context`, or by one of its own where that is empty.
std::unique_ptr<Session> open_beside_window(const std::filesystem::path& scene, SessionOptions options, gui::Window& window,
                                            vulkan::Context* context) {
    constexpr auto kBetweenLooks = std::chrono::milliseconds(20);
    gui::WaitScreen shown(window, context, {options.device, options.validation, true}, "Opening " + scene_name(scene));
    std::atomic<double> part = 0;
    std::atomic<bool> stopped = false;
    options.opening = [&](double now) {
        part = now;
        return !stopped;
    };
    auto made = std::async(std::launch::async, [&] { return std::make_unique<Session>(scene, options); });
    while (made.wait_for(kBetweenLooks) != std::future_status::ready)
        if (!shown.show(part)) stopped = true;
    auto session = made.get();
    if (stopped) throw Stopped("Opening was stopped");
    return session;
}

std::unique_ptr<Session> open_session(const Departure& to, SessionOptions options, gui::Window& window,
                                      Session* before) {
    vulkan::Context* const context = before ? &before->context() : nullptr;
    options.find_mask = to.kind != Departure::Kind::restore;
    if (options.find_mask) return open_beside_window(to.scene, options, window, context);
    const AbandonedJournal& abandoned = *to.abandoned;
    options.map = abandoned.base_map;
    options.colour_map = abandoned.base_colours;
    options.mask = abandoned.base_mask;
    auto session = open_beside_window(abandoned.scene, options, window, context);
    try {
        gui::WaitScreen shown(window, &session->context(), {}, "Restoring; if stopped, the next start offers it again");
        ReplayOptions how;
        how.progress = [&](std::size_t done, std::size_t total) {
            const double part = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 0;
            if (!shown.show(part, std::to_string(done) + " of " + std::to_string(total) + " edits"))
                throw Stopped("Restoring was stopped; the next start offers the edits again");
        };
        replay(read_journal(abandoned.journal), *session, how);
    } catch (...) {
        session->discard_recovery();  // half of the old journal, which stays
        throw;
    }
    // Its strokes are in the new session's own journal now, unless that could not be written.
    if (session->journal_error().empty()) remove_recovery(abandoned.journal);
    return session;
}

void remember(const std::filesystem::path& scene, std::string& message) {
    try {
        change_preferences([&](Preferences& p) { add_recent(p, scene); });
    } catch (const std::invalid_argument& trouble) {
        if (message.empty()) message = trouble.what();
    }
}

// The sample that lies beside the program; empty where there is none.
std::filesystem::path sample_scene() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto scene = program.parent_path() / "assets" / "scenes" / "asteroid.json";
    return std::filesystem::exists(scene, error) ? scene : std::filesystem::path();
}

// Opens `to` in the place of what is open. That is let go only when `to` is there, so that a file that cannot be opened
// takes nothing away. Returns what went wrong, for the user. Throws where nothing is open.
std::string change_scene(std::unique_ptr<Session>& session, const Departure& to, const SessionOptions& options,
                         gui::Window& window) {
    std::string message;
    const auto let_go = [&] {
        if (session) session->discard_recovery();  // the user was asked about what is not saved
        session.reset();
    };
    try {
        auto next = open_session(to, options, window, session.get());
        let_go();
        session = std::move(next);
        remember(session->scene().path, message);
    } catch (const MemoryShortage&) {
        if (!session) throw;
        const Departure back{Departure::Kind::open, session->scene().path, {}};
        let_go();  // there may be room for one, where there is none for both
        try {
            message = change_scene(session, to, options, window);
        } catch (const std::exception& trouble) {
            session = open_session(back, options, window, nullptr);
            message = trouble.what();
        }
    } catch (const std::exception& trouble) {
        if (!session) throw;
        message = trouble.what();
    }
    return message;
}

void run_scenes(gui::Window& window, gui::FrameLog& log, double most_fps, Departure to,
                SessionOptions options) {
    std::unique_ptr<Session> session;
    while (to.kind != Departure::Kind::quit) {
        const bool first = !session;
        const std::string message = change_scene(session, to, options, window);
        window.set_content_scale(load_preferences().interface_scale);
        gui::Screen screen(session->context(), window);
        gui::App app(window, screen, *session, log, most_fps, message);
        if (first) app.offer(find_abandoned_journals());
        to = app.run();
        options.journal.clear();  // the named journal records the first scene alone
        options.map.clear();
    }
    if (session) session->discard_recovery();  // as above
}

void keep_size(gui::PixelSize size) {
    try {
        if (size.width > 0 && size.height > 0)
            change_preferences([&](Preferences& p) {
                p.window_width = size.width;
                p.window_height = size.height;
            });
    } catch (const std::invalid_argument&) {
        // A full disk must not turn a good end into a bad one.
    }
}

}  // namespace

int run_editor(const EditorOptions& options) {
    {
        SessionOptions session = options.session;
        const Preferences kept = load_preferences();
        const bool sized = session.width > 0;
        const gui::PixelSize size = sized ? gui::PixelSize{session.width, session.height}
                                    : kept.window_width > 0
                                        ? gui::PixelSize{kept.window_width, kept.window_height}
                                        : kWindow;
        session.width = session.height = 0;
        gui::FrameLog log(options.frame_log);
        gui::Window window(size);
        std::optional<std::filesystem::path> scene = options.scene;
        if (scene->empty()) scene = sample_scene();
        if (scene->empty()) scene = ask_for_scene(window, session);
        try {
            if (scene) run_scenes(window, log, options.most_fps, {Departure::Kind::open, *scene, {}}, session);
        } catch (const Stopped&) {
            // By the user, while there was nothing yet to go back to.
        }
        if (!sized) keep_size(window.size());
    }
    if (const int messages = vulkan::Context::validation_messages(); messages > 0)
        throw std::runtime_error("the Vulkan validation layers had " + std::to_string(messages) +
                                 " messages; they stand above");
    return 0;
}

}  // namespace relievo
