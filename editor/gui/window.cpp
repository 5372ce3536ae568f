// The GLFW window and its input. Dear ImGui gets the same callbacks, after ours.
#include "editor/gui/window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "editor/gui/key_layout.h"
#ifdef RELIEVO_HAS_XINPUT
#include "editor/gui/xinput_pen.h"
#endif

namespace relievo::gui {
namespace {

constexpr int kLeastWidth = 640, kLeastHeight = 400;

std::uint64_t clock_us() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(since).count());
}

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

Window& window_of(GLFWwindow* handle) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

bool ui_listens() {
    return ImGui::GetCurrentContext() != nullptr;
}

}  // namespace

struct WindowCallbacks {
    static void cursor(GLFWwindow* handle, double x, double y) {
        Window& window = window_of(handle);
        window.x_ = x;
        window.y_ = y;
        window.follow_pen(PenSample::Kind::move);
        window.add({InputEvent::Kind::move});
    }
    static void button(GLFWwindow* handle, int button, int action, int mods) {
        Window& window = window_of(handle);
        const bool press = action == GLFW_PRESS;
        window.follow_pen(press ? PenSample::Kind::press : PenSample::Kind::release);
        window.add({press ? InputEvent::Kind::press : InputEvent::Kind::release, 0, 0, 0, button, mods});
        (press ? window.pressed_at_ : window.released_at_) = glm::dvec2(window.x_, window.y_);
        if (press) window.released_at_.reset();
        if (ui_listens()) ImGui_ImplGlfw_MouseButtonCallback(handle, button, action, mods);
    }
    static void scroll(GLFWwindow* handle, double x, double y) {
        window_of(handle).add({InputEvent::Kind::scroll, 0, 0, 0, 0, 0, y});
        if (ui_listens()) ImGui_ImplGlfw_ScrollCallback(handle, x, y);
    }
    static void key(GLFWwindow* handle, int key, int scancode, int action, int mods) {
        Window& window = window_of(handle);
        key = key_on_layout(key, glfwGetKeyName(key, scancode));
        // What a held key still waits for is not asked for again: its work would go on long after it is let go.
        const auto waits = [key](const InputEvent& e) { return e.kind == InputEvent::Kind::key && e.code == key; };
        const bool repeated = action == GLFW_REPEAT, once_more = repeated && std::ranges::any_of(window.events_, waits);
        if (action != GLFW_RELEASE && !once_more) {
            window.add({InputEvent::Kind::key, 0, 0, 0, key, mods});
            window.events_.back().repeated = repeated;
        }
        if (action == GLFW_PRESS) window.pressed_.push_back(key);
        const auto& pressed = window.pressed_;
        if (action == GLFW_RELEASE && std::find(pressed.begin(), pressed.end(), key) != pressed.end()) {
            window.held_releases_.push_back({key, scancode, mods});
        } else if (ui_listens()) {
            ImGui_ImplGlfw_KeyCallback(handle, key, scancode, action, mods);
        }
    }
    static void character(GLFWwindow* handle, unsigned int code) {
        if (ui_listens()) ImGui_ImplGlfw_CharCallback(handle, code);
    }
    static void focus(GLFWwindow* handle, int focused) {
        if (ui_listens()) ImGui_ImplGlfw_WindowFocusCallback(handle, focused);
    }
    static void enter(GLFWwindow* handle, int entered) {
        if (ui_listens()) ImGui_ImplGlfw_CursorEnterCallback(handle, entered);
    }
    static void drop(GLFWwindow* handle, int count, const char** paths) {
        window_of(handle).dropped_.assign(paths, paths + std::max(0, count));
    }
    static void set_all(GLFWwindow* handle) {
        glfwSetCursorPosCallback(handle, cursor);
        glfwSetMouseButtonCallback(handle, button);
        glfwSetScrollCallback(handle, scroll);
        glfwSetKeyCallback(handle, key);
        glfwSetCharCallback(handle, character);
        glfwSetWindowFocusCallback(handle, focus);
        glfwSetCursorEnterCallback(handle, enter);
        glfwSetDropCallback(handle, drop);
    }
};

namespace {

// A window larger than the screen would hide its panels.
PixelSize fitted_to_screen(PixelSize size) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return size;
    int x = 0, y = 0, width = 0, height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
    if (width <= 0 || height <= 0) return size;
    return {std::min(size.width, width), std::min(size.height, height)};
}

}  // namespace

Window::Window(PixelSize size) : start_us_(clock_us()) {
    if (!glfwInit())
        throw std::runtime_error("cannot open a window: " + last_glfw_error() +
                                 "; relievo render and relievo replay work without a display");
    if (!glfwVulkanSupported()) {
        glfwTerminate();
        throw std::runtime_error(
            "cannot open a window: no Vulkan driver shows pictures on this display; install the package "
            "mesa-vulkan-drivers");
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    size = fitted_to_screen(size);
    handle_ = glfwCreateWindow(size.width, size.height, "Relievo", nullptr, nullptr);
    if (!handle_) {
        const std::string reason = last_glfw_error();
        glfwTerminate();
        throw std::runtime_error("cannot open a window: " + reason);
    }
    glfwSetWindowSizeLimits(handle_, kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(handle_, this);
    glfwGetCursorPos(handle_, &x_, &y_);
    WindowCallbacks::set_all(handle_);
#ifdef RELIEVO_HAS_XINPUT
    pen_ = open_xinput_pen(handle_);
#endif
}

Window::~Window() {
    pen_.reset();
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

VkSurfaceKHR Window::make_surface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(instance, handle_, nullptr, &surface) != VK_SUCCESS)
        throw std::runtime_error("cannot show pictures in the window: " + last_glfw_error());
    return surface;
}

PixelSize Window::framebuffer() const {
    PixelSize size;
    glfwGetFramebufferSize(handle_, &size.width, &size.height);
    return size;
}

PixelSize Window::size() const {
    PixelSize size;
    glfwGetWindowSize(handle_, &size.width, &size.height);
    return size;
}

double Window::content_scale() const {
    if (chosen_scale_ > 0) return chosen_scale_;
    float x = 1, y = 1;
    glfwGetWindowContentScale(handle_, &x, &y);
    return std::clamp(static_cast<double>(std::max(x, y)), 1.0, 4.0);
}

void Window::set_title(const std::string& title) {
    if (title == title_) return;
    glfwSetWindowTitle(handle_, title.c_str());
    title_ = title;
}

double Window::now_us() const {
    return static_cast<double>(clock_us() - start_us_);
}

void Window::stand_still_since(double then_us) {
    const auto then = static_cast<std::uint64_t>(then_us);
    for (InputEvent& event : events_) event.time_us = std::min(event.time_us, then);
    start_us_ = clock_us() - then;
}

void Window::poll() {
    before_events();
    glfwPollEvents();
    after_events();
}

void Window::wait(double seconds) {
    before_events();
    glfwWaitEventsTimeout(seconds);
    after_events();
}

void Window::before_events() {
    forward_releases();
    int units = 1, ignored = 1;
    glfwGetWindowSize(handle_, &units, &ignored);
    if (const PixelSize size = framebuffer(); size.width > 0 && units > 0)
        pixels_per_unit_ = static_cast<double>(size.width) / units;
}

// A pen that is pressed harder where it is tells GLFW nothing.
void Window::after_events() {
    if (!pen_) return;
    pen_->read(track_);
    if (track_.settle()) add({InputEvent::Kind::move});
}

void Window::follow_pen(PenSample::Kind kind) {
    if (!pen_) return;
    pen_->read(track_);
    track_.touch_at(kind, x_, y_);
}

void Window::forward_releases() {
    for (const KeyRelease& key : held_releases_)
        if (ui_listens()) ImGui_ImplGlfw_KeyCallback(handle_, key.key, key.scancode, GLFW_RELEASE, key.mods);
    held_releases_.clear();
    pressed_.clear();
}

std::optional<glm::dvec2> Window::take_button_place() {
    return std::exchange(pressed_at_ ? pressed_at_ : released_at_, std::nullopt);
}

bool Window::close_wanted() const {
    return glfwWindowShouldClose(handle_) == GLFW_TRUE;
}

void Window::refuse_close() {
    glfwSetWindowShouldClose(handle_, GLFW_FALSE);
}

void Window::add(InputEvent event) {
    event.time_us = clock_us() - start_us_;
    event.x = x_ * pixels_per_unit_;
    event.y = y_ * pixels_per_unit_;
    event.touch = track_.now();
    events_.push_back(event);
}

}  // namespace relievo::gui
