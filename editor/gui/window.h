// The GLFW window and its input: every event is stamped when it arrives and kept in order, so that strokes do
// not depend on the frame rate.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/gui/pen_track.h"

struct GLFWwindow;

namespace relievo::gui {

struct InputEvent {
    enum class Kind { move, press, release, scroll, key } kind;
    std::uint64_t time_us = 0;  // since the window opened
    double x = 0, y = 0;        // of the pointer, framebuffer pixels from the top left
    int code = 0;               // press and release: GLFW mouse button; key: GLFW key
    int mods = 0;               // GLFW_MOD_*
    double scroll = 0;          // notches, up positive
    bool repeated = false;      // key: it is held
    PenTouch touch{};           // of the pen, or whatever moves the pointer
};

struct PixelSize {
    int width = 0, height = 0;
    bool operator==(const PixelSize&) const = default;
};

class Window {
  public:
    // Throws std::runtime_error in one sentence when there is no display.
    explicit Window(PixelSize size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return handle_; }
    VkSurfaceKHR make_surface(VkInstance instance) const;

    PixelSize framebuffer() const;  // 0 x 0 while minimised
    PixelSize size() const;         // as the window's constructor takes it
    double content_scale() const;   // 1 on ordinary displays, 2 on dense ones, or what was set
    void set_content_scale(double scale) { chosen_scale_ = scale; }  // 0: the display's
    void set_title(const std::string& title);

    void poll();
    void wait(double seconds);  // until an event comes, at most so long
    std::deque<InputEvent>& events() { return events_; }
    double now_us() const;  // on the clock of the events' times
    std::uint64_t start_us() const {
        return start_us_;
    }  // of the steady clock: where the events' times begin
    // From then until now nothing was answered: that clock stood still, and what came meanwhile came then. GLFW does not
    // tell when events happen, and a press that had to wait must not count as a long one.
    void stand_still_since(double then_us);

    // Where Dear ImGui is to see the pointer in the next frame, in window coordinates, if not where it is by then: at a
    // press or release since the last one.
    std::optional<glm::dvec2> take_button_place();

    // Files that were dropped on the window together since the last call, mostly none.
    std::vector<std::filesystem::path> take_dropped() { return std::exchange(dropped_, {}); }

    bool close_wanted() const;
    void refuse_close();

  private:
    friend struct WindowCallbacks;
    void add(InputEvent event);
    void follow_pen(PenSample::Kind kind);

    GLFWwindow* handle_ = nullptr;
    struct KeyRelease {
        int key, scancode, mods;
    };
    void before_events();
    void after_events();
    void forward_releases();

    std::deque<InputEvent> events_;
    std::unique_ptr<PenReader> pen_;  // null: the display tells no pressure
    PenTrack track_;
    // Dear ImGui 1.86 looks at keys once a frame: a key that went down and up in between must be seen down.
    std::vector<int> pressed_;               // since the last poll
    std::vector<KeyRelease> held_releases_;  // given to Dear ImGui at the next poll
    // Nor does it ask where the pointer was when a button went down or up. Taken in this order, one a frame.
    std::optional<glm::dvec2> pressed_at_, released_at_;
    std::uint64_t start_us_ = 0;
    double x_ = 0, y_ = 0;  // window coordinates
    double pixels_per_unit_ = 1;
    double chosen_scale_ = 0;
    std::string title_;
    std::vector<std::filesystem::path> dropped_;
};

}  // namespace relievo::gui
