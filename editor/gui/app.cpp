// One open scene in the window: the loop of input, tracing and drawing.
#include "editor/gui/app.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "editor/gui/keys.h"
#include "editor/gui/panels.h"
#include "editor/gui/picture_overlay.h"
#include "editor/gui/tool_marks.h"
#include "editor/gui/widgets.h"
#include "editor/gui/work_pace.h"
#include "editor/session/derived_scene.h"
#include "editor/session/image_file.h"
#include "editor/session/preferences.h"
#include "renderer/give_memory_back.h"
#include "renderer/stopwatch.h"
#include "renderer/vulkan/programs.h"

namespace relievo::gui {
namespace {

using Clock = std::chrono::steady_clock;

// Of one turn of the loop, which the interface brings to less than 50 ms on two cores without a GPU: strokes,
// with what remains for the picture; a hand that is ahead of the dabs gets more than one that is not.
constexpr double kTurnMs = 34, kInputMs = 14, kLateInputMs = 26, kLateUs = 50e3, kLeastTraceMs = 8;
constexpr double kRestSeconds = 0.5, kAirbrushSeconds = 0.02;
constexpr double kUnhurriedMs = 100;  // between frames that show nothing new but numbers
constexpr double kMemoryMs = 20e3;   // between two times that free memory goes back
constexpr int kClosingFrames = 2;
constexpr int kSettleFrames = 3;

template <typename Work>
void timed(double& ms, Work work) {
    const auto start = Clock::now();
    work();
    ms = ms_since(start);
}

}  // namespace

App::App(Window& window, Screen& screen, Session& session, FrameLog& log, double most_fps,
         const std::string& message)
    : window_(&window),
      screen_(&screen),
      log_(&log),
      least_frame_ms_(most_fps > 0 ? 1000 / most_fps : 0),
      screenshots_([](const auto& path, const DisplayPicture& picture) { write_png(path, picture); }, glfwPostEmptyEvent),
      reference_(session, [] { glfwPostEmptyEvent(); }),
      live_(session, reference_, screen.format()),
      desk_(session, live_, reference_, toasts_),
      pointer_(desk_),
      steps_seen_(session.steps_made()) {
    const Preferences preferences = load_preferences();
    desk_.view.hint = !preferences.first_hint_seen;
    desk_.view.side_width = static_cast<float>(preferences.side_width);
    if (!message.empty()) toasts_.error(message);
    for (const std::string& warning : session.scene().warnings) toasts_.info(warning);
}

void App::offer(std::vector<AbandonedJournal> abandoned) {
    desk_.abandoned = std::move(abandoned);
    if (!desk_.abandoned.empty()) desk_.view.wanted = Dialog::recovery;
}

Departure App::run() {
    draw();  // the first picture may have to wait for a compiler
    while (!desk_.departure) {
        wait_for_input();
        timed(times_.input_ms, [&] { handle_input(); });
        do_work();
        desk_.prepare_picture();
        do_work();
        if (window_->close_wanted() && !pointer_.stroke_ends()) {
            window_->refuse_close();
            pointer_.cancel();
            desk_.leave({});
        }
        if (desk_.view.hint && pointer_.dabs() > 0 && !pointer_.in_stroke()) end_hint();
        if (!pointer_.stroke_ends()) take_dropped();
        timed(times_.trace_ms, [&] { live_.work(std::max(kLeastTraceMs, kTurnMs - times_.input_ms)); });
        note_traced();
        give_memory_back();
        timed(times_.cursor_ms, [&] { follow_pointer(); });
        // While the picture only refines, the device's time is the tracer's.
        if (frames_due_ > 0 || live_.take_changed() || ms_since(last_drawn_) > kUnhurriedMs) draw();
        do_work();
        tell_screenshots();
        tell_step_not_held();
        update_title();
        if (const std::string trouble = reference_.take_trouble(); !trouble.empty())
            toasts_.error("The reference: " + trouble);
        if (const std::string trouble = desk_.session.journal_error(); trouble != journal_trouble_) {
            journal_trouble_ = trouble;
            if (!trouble.empty()) toasts_.error(trouble);
        }
    }
    desk_.attempt([&] {
        change_preferences(
            [&](Preferences& p) { p.side_width = static_cast<double>(desk_.view.side_width); });
    });
    return *desk_.departure;
}

void App::take_dropped() {
    const std::vector<std::filesystem::path> paths = window_->take_dropped();
    if (paths.empty()) return;
    pointer_.cancel();
    desk_.open_files(paths);
    frames_due_ = kSettleFrames;
}

void App::draw() {
    if (const double early = least_frame_ms_ - ms_since(last_drawn_); early > 0)
        std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(early));
    last_drawn_ = Clock::now();
    if (frames_due_ > 0) --frames_due_;
    if (!screen_->begin()) return;
    const bool dialog_open = !picture_free();
    draw_interface();
    closing_frames_ = dialog_open && picture_free() ? kClosingFrames : std::max(0, closing_frames_ - 1);
    screen_->end(live_.strips(), layout_.picture.x, layout_.picture.y);
    times_.draw_ms = ms_since(last_drawn_);
    log_->shown(pointer_.in_stroke(), times_, desk_.session.undo_bytes());
    if (std::exchange(desk_.view.screenshot_wanted, false)) screenshots_.take(screen_->screenshot(), {});
}

// After each compiler, and now and then.
void App::give_memory_back() {
    const std::uint64_t compiled = desk_.session.context().programs().compiled();
    if (compiled == programs_seen_ && (pointer_.in_stroke() || ms_since(memory_given_) < kMemoryMs)) return;
    programs_seen_ = compiled;
    relievo::give_memory_back();
    memory_given_ = Clock::now();
}

void App::end_hint() {
    desk_.view.hint = false;
    desk_.attempt([] { change_preferences([](Preferences& p) { p.first_hint_seen = true; }); });
}

void App::note_traced() {
    const Box& at = layout_.picture;
    for (const PixelRect& r : live_.take_traced())
        log_->traced({r.x0 + at.x, r.y0 + at.y, r.x1 + at.x, r.y1 + at.y});
    if (!pointer_.in_stroke()) log_->cancelled();
}

void App::wait_for_input() {
    const bool busy = !live_.idle() || pointer_.busy() || pointer_stale_ || !window_->events().empty() ||
                      frames_due_ > 0 || desk_.view.wanted != Dialog::none;
    if (busy) {
        window_->poll();
    } else {
        const bool airbrush = pointer_.in_stroke() && desk_.session.stroke_settings().rate > 0;
        window_->wait(airbrush ? kAirbrushSeconds : toasts_.empty() ? 60 : kRestSeconds);
        frames_due_ = 1;
    }
    if (!window_->events().empty()) frames_due_ = kSettleFrames;
}

// Dialogs and open menus keep the pointer to themselves. Asked at each press: Dear ImGui's own answer is as
// old as its last frame.
bool App::picture_free() const {
    return !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

// The panel that lists a ray keeps its place to itself, too.
bool App::picture_free_at(double x, double y) const {
    return picture_free() && !desk_.why.holds(x, y);
}

// What waits because the hand is ahead of the dabs is not worth doing where Esc follows it.
void App::skip_to_escape() {
    using Kind = InputEvent::Kind;
    auto& events = window_->events();
    const auto end = std::find_if(events.begin(), events.end(), [](const InputEvent& e) {
        return e.kind == Kind::press || e.kind == Kind::key;
    });
    if (end == events.end() || end->kind != Kind::key || end->code != GLFW_KEY_ESCAPE) return;
    pointer_.cancel();
    events.erase(events.begin(), end + 1);
}

void App::handle_input() {
    const auto start = Clock::now();
    auto& events = window_->events();
    if (pointer_.in_stroke()) skip_to_escape();
    const bool late =
        !events.empty() && window_->now_us() - static_cast<double>(events.front().time_us) > kLateUs;
    const auto end = start + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double, std::milli>(late ? kLateInputMs : kInputMs));
    pointer_.allow_until(end);
    pointer_.work();
    while (!events.empty() && !pointer_.busy() && Clock::now() < end) {
        const InputEvent event = events.front();
        events.pop_front();
        if (event.kind == InputEvent::Kind::key) {
            handle_key(event);
            // The dialog that Esc closes is there until the next frame; what follows is meant for what lies behind it.
            if (event.code == GLFW_KEY_ESCAPE && !picture_free()) break;
            if (desk_.work) break;  // what follows waits for it
            continue;
        }
        const std::uint64_t dabs = pointer_.dabs();
        pointer_.on_event(event, layout_.picture, picture_free_at(event.x, event.y));
        if (pointer_.dabs() != dabs) log_->sculpted(event, window_->start_us());
        x_ = event.x;
        y_ = event.y;
        pointer_stale_ = true;
        if (desk_.work) break;
    }
    if (events.empty() && pointer_.in_stroke() && !pointer_.busy())
        pointer_.rest(static_cast<std::uint64_t>(window_->now_us()));
    pointer_.apply_moves();
}

void App::handle_key(const InputEvent& event) {
    const bool typing = ImGui::GetIO().WantTextInput && closing_frames_ == 0;
    if (event.code == GLFW_KEY_ESCAPE) {
        // Once to sculpt beside the list, again to close it.
        const bool to_end = pointer_.dragging() || desk_.view.brush_drag != BrushDrag::none || desk_.view.asking;
        if (!to_end && !typing && picture_free() && !event.repeated) desk_.why.close();
        return pointer_.cancel();
    }
    const bool busy = pointer_.dragging() || typing || !picture_free();
    if (!busy) pointer_.apply_moves();
    if (event.code == GLFW_KEY_ENTER || event.code == GLFW_KEY_KP_ENTER) pointer_.keep_drag();
    on_key(desk_, event, {layout_.picture.width, layout_.picture.height}, busy);
    pointer_stale_ = true;
}

void App::follow_pointer() {
    const bool over = layout_.picture.holds(x_, y_) && picture_free_at(x_, y_);
    const bool camera_moves = (pointer_.dragging() && !pointer_.in_stroke()) ||
                              desk_.view.brush_drag == BrushDrag::light;
    const bool not_sculpting = desk_.view.asking || on_divider(desk_, x_ - layout_.picture.x);
    if (!over || camera_moves || (not_sculpting && !pointer_.in_stroke())) {
        desk_.cursor.hide();
        pointer_stale_ = false;
        return;
    }
    if (desk_.view.brush_drag == BrushDrag::none && (pointer_stale_ || !live_.idle()))
        desk_.cursor.follow(desk_.session, live_, x_ - layout_.picture.x, y_ - layout_.picture.y);
    if (desk_.view.brush_drag != BrushDrag::none) desk_.cursor.resize(desk_.session);
    pointer_stale_ = false;
}

void App::draw_interface() {
    layout_ = make_layout(screen_->size(), desk_.view.interface_hidden, desk_.view.side_width);
    // What is being saved keeps its size.
    if (!desk_.view.work) live_.resize({layout_.picture.width, layout_.picture.height});
    keep_lists_in_window();
    draw_over_picture();
    if (!desk_.view.interface_hidden) {
        draw_top_bar(desk_, layout_.top);
        draw_tool_column(desk_, layout_.tools);
        draw_side_panel(desk_, layout_.side);
        draw_status_bar(desk_, layout_.status);
    }
    desk_.why.draw(desk_.session, reference_, layout_.picture);
    dialogs_.draw(desk_);
    draw_long_work(desk_.view.work);
    close_list_on_escape();
    const float margin = 14;
    toasts_.draw(static_cast<float>(layout_.picture.x) + margin,
                 static_cast<float>(layout_.picture.y + layout_.picture.height) - margin,
                 static_cast<float>(layout_.picture.width) * 0.6f);
}

void App::draw_over_picture() {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Box& picture = layout_.picture;
    const bool over = picture.holds(x_, y_) && picture_free_at(x_, y_);
    const double x = x_ - picture.x, y = y_ - picture.y;
    if (live_.view() == View::prisms)
        desk_.prisms.draw(list, desk_.session, picture,
                          over ? std::optional(glm::dvec2(x, y)) : std::nullopt);
    desk_.cursor.draw(list, desk_.session, live_.size(), picture.x, picture.y, pointer_.in_stroke());
    draw_tool_marks(list, desk_.session, desk_.cursor, live_.size(), picture.x, picture.y);
    desk_.why.draw_mark(list, desk_.session, picture);
    const bool divider = pointer_.drags_divider() || (over && !pointer_.dragging() && on_divider(desk_, x));
    draw_picture_overlay(desk_, picture, divider);
    draw_dragged_value(desk_, picture, x_, y_);
    if (desk_.view.hint) draw_first_hint(picture);
    if (divider) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (over && !divider && desk_.view.asking) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

void App::update_title() {
    const Session& session = desk_.session;
    const auto path = session.map_path();
    const std::string map = path ? path->filename().string() : "new map";
    window_->set_title((session.unsaved() ? "* " : "") + map + " - " +
                       scene_name(session.scene().path) + " - Relievo");
}

void App::do_work() {
    const auto work = std::exchange(desk_.work, std::nullopt);
    if (!work) return;
    const auto start = Clock::now();
    const double since_us = window_->now_us();
    // What was compiled is now tried: some drivers stand still then, and a bar must be there before that.
    const auto compiled = [this] { return desk_.session.context().programs().compiled(); };
    const std::uint64_t compiled_before = compiled();
    WorkPace pace;
    double look_ms = kUnseenWorkMs;
    std::size_t waiting = 0;
    std::string trouble;
    try {
        work->run([&](double part) {
            const double now_ms = ms_since(start);
            const bool first = !desk_.view.work;
            if (now_ms < look_ms && !(first && compiled() != compiled_before)) return true;
            look_ms = now_ms + kWorkLookMs;
            if (!first) {
                if (!poll_behind_work(*window_, waiting) && !pace.due(now_ms)) return true;
            } else {
                // What was done before the work could be seen is still to come, but for an Esc, which is for the work.
                window_->poll();
                std::erase_if(window_->events(), [](const InputEvent& event) {
                    return event.kind == InputEvent::Kind::key && event.code == GLFW_KEY_ESCAPE;
                });
                waiting = window_->events().size();
                desk_.view.work = WorkShown{work->title};
            }
            desk_.view.work->part = part;
            if (first) draw();  // Dear ImGui shows a new dialog from its second frame on
            draw();
            pace.drawn(now_ms, ms_since(start));
            return !desk_.view.work->stopped;
        });
    } catch (const std::exception& error) {
        trouble = error.what();
    }
    desk_.view.work.reset();
    window_->stand_still_since(since_us);
    frames_due_ = kSettleFrames;
    if (trouble.empty()) {
        if (work->done) work->done();
    } else if (work->failed) {
        work->failed(trouble);
    } else {
        toasts_.error(trouble);
    }
}

// What is undone can be redone; a step that the undo memory does not hold can be neither.
void App::tell_step_not_held() {
    const Session& session = desk_.session;
    const std::uint64_t seen = std::exchange(steps_seen_, session.steps_made());
    if (steps_seen_ <= seen || session.can_undo() || session.can_redo()) return;  // fewer: baked heights begin anew
    toasts_.error("That step is larger than the undo memory of " + std::to_string(session.undo_budget() >> 20) +
                  " MB: neither it nor those before it can be undone");
    frames_due_ = kSettleFrames;
}

void App::tell_screenshots() {
    for (const auto& [path, trouble] : screenshots_.take_done()) {
        if (trouble.empty())
            toasts_.info("Saved " + std::filesystem::absolute(path).string());
        else
            toasts_.error(trouble);
        frames_due_ = kSettleFrames;
    }
}

}  // namespace relievo::gui
