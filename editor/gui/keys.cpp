// Keys of the keyboard.
#include "editor/gui/keys.h"

#include <GLFW/glfw3.h>

#include <array>

#include "editor/gui/camera_control.h"

namespace relievo::gui {
namespace {

constexpr double kSizeStep = 1.15;

constexpr std::array kHelp{
    KeyHelp{"Sculpt", ""},
    KeyHelp{"Left button", "sculpt with the tool"},
    KeyHelp{"Ctrl + left", "lower in the place of raise"},
    KeyHelp{"Shift + left", "smooth"},
    KeyHelp{"Esc", "cancel the stroke"},
    KeyHelp{"1 to 5", "draw, smooth, flatten, level, erase"},
    KeyHelp{"[ and ]", "smaller and larger brush"},
    KeyHelp{"F, Shift + F", "drag size, strength; click keeps"},
    KeyHelp{"View", ""},
    KeyHelp{"Alt + left, middle", "orbit"},
    KeyHelp{"Alt + middle, Shift + middle", "pan"},
    KeyHelp{"Alt + right, Ctrl + middle, wheel", "zoom"},
    KeyHelp{"A", "show all"},
    KeyHelp{"Numpad 1, 3, 7", "from the front, the right, above; again: opposite"},
    KeyHelp{"V, Shift + V", "the next view, and the one before"},
    KeyHelp{"C", "two methods side by side"},
    KeyHelp{"F2", "a click lists what the pixel's ray met; Esc ends it"},
    KeyHelp{"Tab", "hide and show the interface"},
    KeyHelp{"File", ""},
    KeyHelp{"Ctrl + S, Ctrl + Shift + S", "save the map, save as"},
    KeyHelp{"Ctrl + O", "open a scene"},
    KeyHelp{"Ctrl + Z", "undo"},
    KeyHelp{"Ctrl + Shift + Z, Ctrl + Y", "redo"},
    KeyHelp{"F12", "screenshot of the window into the working folder"},
    KeyHelp{"Ctrl + Q", "quit"},
    KeyHelp{"F1", "this list"},
};

void on_control_key(Desk& desk, int key, bool shift) {
    switch (key) {
        case GLFW_KEY_Z:
            return shift ? desk.redo() : desk.undo();
        case GLFW_KEY_Y:
            return desk.redo();
        case GLFW_KEY_S:
            if (!shift) return desk.save();
            desk.view.wanted = Dialog::save_as;
            return;
        case GLFW_KEY_O:
            desk.view.wanted = Dialog::open_scene;
            return;
        case GLFW_KEY_Q:
            return desk.leave({});
        default:
            return;
    }
}

void look(Desk& desk, Axis axis) {
    desk.set_camera(looking_along(desk.session.scene().camera, axis));
}

}  // namespace

std::span<const KeyHelp> key_help() {
    return kHelp;
}

void on_key(Desk& desk, const InputEvent& event, PixelSize picture) {
    const bool shift = event.mods & GLFW_MOD_SHIFT;
    if (event.mods & GLFW_MOD_CONTROL) return on_control_key(desk, event.code, shift);
    if (event.mods & GLFW_MOD_ALT) return;
    if (event.code >= GLFW_KEY_1 && event.code <= GLFW_KEY_9)
        return desk.choose_tool(static_cast<std::size_t>(event.code - GLFW_KEY_1));
    switch (event.code) {
        case GLFW_KEY_LEFT_BRACKET:
            return desk.scale_radius(1 / kSizeStep);
        case GLFW_KEY_RIGHT_BRACKET:
            return desk.scale_radius(kSizeStep);
        case GLFW_KEY_F:
            desk.view.brush_drag = shift ? BrushDrag::strength : BrushDrag::radius;
            return;
        case GLFW_KEY_A:
            return desk.set_camera(framing_all(desk.session.scene(), picture));
        case GLFW_KEY_KP_1:
            return look(desk, Axis::front);
        case GLFW_KEY_KP_3:
            return look(desk, Axis::right);
        case GLFW_KEY_KP_7:
            return look(desk, Axis::top);
        case GLFW_KEY_V:
            return desk.set_view(next_view(desk.live.view(), shift ? -1 : 1));
        case GLFW_KEY_C:
            return desk.split(!desk.live.is_split());
        case GLFW_KEY_F2:
            desk.view.asking = !desk.view.asking;
            return;
        case GLFW_KEY_TAB:
            desk.view.interface_hidden = !desk.view.interface_hidden;
            return;
        case GLFW_KEY_F1:
            desk.view.wanted = Dialog::keys;
            return;
        default:
            return;
    }
}

}  // namespace relievo::gui
