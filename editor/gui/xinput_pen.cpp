// Pressure on X11 through XInput2 (the protocol's text: XI2proto.txt of xorgproto), over a connection of its
// own to the same window, so that GLFW's queue stays GLFW's.
//
// Only slave devices are listened to. What a window's master pointer does is delivered either as XInput2's
// event or as the core event, not as both: whoever asked for the former would take GLFW's pointer away.
#include "editor/gui/xinput_pen.h"

#include <X11/extensions/XInput2.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "editor/gui/pen_axis.h"

// As glfw3native.h declares them, which wants the headers of other extensions, too. A GLFW that was built for
// Wayland alone lacks them.
extern "C" {
[[gnu::weak]] Display* glfwGetX11Display();
[[gnu::weak]] Window glfwGetX11Window(GLFWwindow* window);
}

namespace relievo::gui {
namespace {

constexpr int kFirstWheelButton = 4, kLastWheelButton = 7;

// A device may go while we ask for its events. Xlib's own answer to an error is to end the program.
class ErrorsIgnored {
  public:
    explicit ErrorsIgnored(Display* display) : display_(display) {
        before_ = XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    }
    ErrorsIgnored(const ErrorsIgnored&) = delete;
    ErrorsIgnored& operator=(const ErrorsIgnored&) = delete;
    ~ErrorsIgnored() {
        XSync(display_, False);
        XSetErrorHandler(before_);
    }

  private:
    Display* display_;
    XErrorHandler before_;
};

struct Device {
    int id = 0;
    std::optional<PressureAxis> axis;
    PenTouch touch;  // the last; events name only axes that changed
};

class XinputPen : public PenReader {
  public:
    // `opcode`: of the extension. The display is closed at the end.
    XinputPen(Display* display, ::Window window, int opcode)
        : display_(display), window_(window), opcode_(opcode) {
        select(DefaultRootWindow(display_), XIAllDevices, {XI_HierarchyChanged});
        find_devices();
    }
    ~XinputPen() override { XCloseDisplay(display_); }
    void read(PenTrack& track) override;

  private:
    void select(::Window window, int device, std::initializer_list<int> events);
    void find_devices();
    std::optional<PressureAxis> pressure_axis_of(const XIDeviceInfo& info);
    void on_pointer(const XIDeviceEvent& event, PenSample::Kind kind, PenTrack& track);

    Display* display_;
    ::Window window_;
    int opcode_;
    std::vector<Device> devices_;  // the slave pointers
};

void XinputPen::select(::Window window, int device, std::initializer_list<int> events) {
    std::array<unsigned char, XIMaskLen(XI_LASTEVENT)> bits{};
    for (const int event : events) XISetMask(bits.data(), event);
    XIEventMask mask{device, static_cast<int>(bits.size()), bits.data()};
    const ErrorsIgnored guard(display_);
    XISelectEvents(display_, window, &mask, 1);
}

void XinputPen::find_devices() {
    int count = 0;
    XIDeviceInfo* infos = XIQueryDevice(display_, XIAllDevices, &count);
    if (infos == nullptr) return;
    devices_.clear();
    for (const XIDeviceInfo* info = infos; info != infos + count; ++info) {
        if (info->use != XISlavePointer || !info->enabled) continue;
        const auto axis = pressure_axis_of(*info);
        const double pressure = axis ? pressure_of(axis->value, *axis) : 1.0;
        devices_.push_back({info->deviceid, axis, {pressure, is_eraser(info->name)}});
        select(window_, info->deviceid, {XI_Motion, XI_ButtonPress, XI_ButtonRelease, XI_DeviceChanged});
    }
    XIFreeDeviceInfo(infos);
}

std::optional<PressureAxis> XinputPen::pressure_axis_of(const XIDeviceInfo& info) {
    std::vector<PointerAxis> axes;
    for (int i = 0; i < info.num_classes; ++i) {
        if (info.classes[i]->type != XIValuatorClass) continue;
        const auto& valuator = *reinterpret_cast<const XIValuatorClassInfo*>(info.classes[i]);
        if (valuator.label == None) continue;
        char* label = XGetAtomName(display_, valuator.label);
        axes.push_back({valuator.number, label ? label : "", valuator.min, valuator.max, valuator.value});
        XFree(label);
    }
    return pressure_axis(axes);
}

void XinputPen::read(PenTrack& track) {
    while (XPending(display_) > 0) {
        XEvent event;
        XNextEvent(display_, &event);
        XGenericEventCookie& cookie = event.xcookie;
        if (cookie.type != GenericEvent || cookie.extension != opcode_) continue;
        if (!XGetEventData(display_, &cookie)) continue;
        const auto* pointer = static_cast<const XIDeviceEvent*>(cookie.data);
        switch (cookie.evtype) {
            case XI_Motion:
                on_pointer(*pointer, PenSample::Kind::move, track);
                break;
            case XI_ButtonPress:
                on_pointer(*pointer, PenSample::Kind::press, track);
                break;
            case XI_ButtonRelease:
                on_pointer(*pointer, PenSample::Kind::release, track);
                break;
            default:  // another device, or other axes
                find_devices();
        }
        XFreeEventData(display_, &cookie);
    }
}

void XinputPen::on_pointer(const XIDeviceEvent& event, PenSample::Kind kind, PenTrack& track) {
    const bool wheel = event.detail >= kFirstWheelButton && event.detail <= kLastWheelButton;
    if (kind != PenSample::Kind::move && wheel) return;
    const auto device = std::find_if(devices_.begin(), devices_.end(),
                                     [&](const Device& known) { return known.id == event.deviceid; });
    if (device == devices_.end()) return;
    // Values are given for the axes of the mask alone, in their order.
    const double* value = event.valuators.values;
    for (int axis = 0; axis < event.valuators.mask_len * 8; ++axis) {
        if (!XIMaskIsSet(event.valuators.mask, axis)) continue;
        if (device->axis && device->axis->number == axis)
            device->touch.pressure = pressure_of(*value, *device->axis);
        ++value;
    }
    track.add({kind, event.event_x, event.event_y, device->touch});
}

}  // namespace

std::unique_ptr<PenReader> open_xinput_pen(GLFWwindow* window) {
    if (glfwGetX11Display == nullptr || glfwGetX11Window == nullptr) return nullptr;
    Display* glfws = glfwGetX11Display();
    if (glfws == nullptr) return nullptr;
    Display* display = XOpenDisplay(DisplayString(glfws));
    if (display == nullptr) return nullptr;
    int opcode = 0, ignored = 0, major = 2, minor = 0;
    const bool there = XQueryExtension(display, "XInputExtension", &opcode, &ignored, &ignored) &&
                       XIQueryVersion(display, &major, &minor) == Success;
    if (!there) {
        XCloseDisplay(display);
        return nullptr;
    }
    return std::make_unique<XinputPen>(display, glfwGetX11Window(window), opcode);
}

}  // namespace relievo::gui
