// Keys of the keyboard and buttons of the mouse.
#include "editor/gui/keys.h"

#include <GLFW/glfw3.h>

#include <array>

#include "editor/gui/camera_control.h"

namespace relievo::gui {
namespace {

constexpr double kSizeStep = 1.15;
constexpr int kControl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;

void look(Desk& desk, Axis axis) {
    desk.set_camera(looking_along(desk.session.scene().camera, axis));
}

using D = Desk;
using K = KeyPress;

constexpr std::array kBindings{
    Binding{"Sculpt", ""},
    Binding{"Left button", "sculpt with the tool"},
    Binding{"Ctrl + left, pen's eraser", "the opposite: lower in the place of raise"},
    Binding{"Ctrl + left, with clone", "where the relief comes from"},
    Binding{"Shift + left", "smooth; with mask, blur the mask"},
    Binding{"Esc", "cancel the stroke or the drag; so does the right button a drag that a key began"},
    Binding{"1 to 9", "the tools at the left, from the top", GLFW_KEY_1, GLFW_KEY_9, 0,
            [](D& d, const K& k) { d.choose_tool(static_cast<std::size_t>(k.key - GLFW_KEY_1)); }},
    Binding{"Shift + 1 to 9", "the tools below those", GLFW_KEY_1, GLFW_KEY_9, kShift,
            [](D& d, const K& k) { d.choose_tool(static_cast<std::size_t>(k.key - GLFW_KEY_1) + 9); }},
    Binding{"[ and ]", "smaller and larger brush", GLFW_KEY_LEFT_BRACKET, GLFW_KEY_LEFT_BRACKET, 0,
            [](D& d, const K&) { d.scale_radius(1 / kSizeStep); }, Binding::repeats},
    Binding{"", "larger", GLFW_KEY_RIGHT_BRACKET, GLFW_KEY_RIGHT_BRACKET, 0,
            [](D& d, const K&) { d.scale_radius(kSizeStep); }, Binding::repeats},
    Binding{"F", "drag the size; click or Enter keeps it", GLFW_KEY_F, GLFW_KEY_F, 0,
            [](D& d, const K&) { d.start_drag(BrushDrag::radius); }},
    Binding{"Shift + F", "drag the strength", GLFW_KEY_F, GLFW_KEY_F, kShift,
            [](D& d, const K&) { d.start_drag(BrushDrag::strength); }},
    Binding{"Alt + F", "drag the stamp's rotation", GLFW_KEY_F, GLFW_KEY_F, GLFW_MOD_ALT,
            [](D& d, const K&) { d.start_drag(BrushDrag::rotation); }},
    Binding{"X, Y, Z", "symmetry across that axis of the object", GLFW_KEY_X, GLFW_KEY_Z, 0,
            [](D& d, const K& k) { d.toggle_symmetry(static_cast<std::size_t>(k.key - GLFW_KEY_X)); }},
    Binding{"P", "what tools change: heights, colours, both", GLFW_KEY_P, GLFW_KEY_P, 0,
            [](D& d, const K&) { d.next_paint(); }},
    Binding{"S", "take the colour under the pointer", GLFW_KEY_S, GLFW_KEY_S, 0,
            [](D& d, const K&) { d.pick_colour(); }},
    Binding{"View", ""},
    Binding{"Alt + left, middle", "orbit"},
    Binding{"Alt + middle, Shift + middle", "pan"},
    Binding{"Alt + right, Ctrl + middle, wheel", "zoom"},
    Binding{"A", "show all", GLFW_KEY_A, GLFW_KEY_A, 0,
            [](D& d, const K& k) { d.set_camera(framing_all(d.session.scene(), k.picture)); }},
    Binding{"Numpad 1, 3, 7", "from the front, the right, above; again: opposite", GLFW_KEY_KP_1,
            GLFW_KEY_KP_1, 0, [](D& d, const K&) { look(d, Axis::front); }},
    Binding{"", "right", GLFW_KEY_KP_3, GLFW_KEY_KP_3, 0, [](D& d, const K&) { look(d, Axis::right); }},
    Binding{"", "above", GLFW_KEY_KP_7, GLFW_KEY_KP_7, 0, [](D& d, const K&) { look(d, Axis::top); }},
    Binding{"Numpad 5", "nearly parallel lines of sight, and back", GLFW_KEY_KP_5, GLFW_KEY_KP_5, 0,
            [](D& d, const K&) { d.flatten_view(); }},
    Binding{"Ctrl + Shift + 1 to 4", "keep this view", GLFW_KEY_1, GLFW_KEY_4, kControl | kShift,
            [](D& d, const K& k) { d.keep_camera(k.key - GLFW_KEY_0); }},
    Binding{"Ctrl + 1 to 4", "go back to the view that was kept", GLFW_KEY_1, GLFW_KEY_4, kControl,
            [](D& d, const K& k) { d.go_to_camera(k.key - GLFW_KEY_0); }},
    Binding{"M", "hide and show the mask", GLFW_KEY_M, GLFW_KEY_M, 0,
            [](D& d, const K&) { d.show_mask(!d.live.mask_shown()); }},
    Binding{"V, Shift + V", "the next view, and the one before", GLFW_KEY_V, GLFW_KEY_V, 0,
            [](D& d, const K&) { d.set_view(next_view(d.live.view(), 1)); }},
    Binding{"", "the view before", GLFW_KEY_V, GLFW_KEY_V, kShift,
            [](D& d, const K&) { d.set_view(next_view(d.live.view(), -1)); }},
    Binding{"C", "two methods side by side", GLFW_KEY_C, GLFW_KEY_C, 0,
            [](D& d, const K&) { d.split(!d.live.is_split()); }},
    Binding{"F2", "a click lists what the pixel's ray met; Esc ends it, again closes the list", GLFW_KEY_F2, GLFW_KEY_F2, 0,
            [](D& d, const K&) { d.view.asking = !d.view.asking; }},
    Binding{"L", "drag lights and sky around the object; click keeps them", GLFW_KEY_L, GLFW_KEY_L, 0,
            [](D& d, const K&) { d.start_drag(BrushDrag::light); }},
    Binding{"Tab", "hide and show the interface", GLFW_KEY_TAB, GLFW_KEY_TAB, 0,
            [](D& d, const K&) { d.view.interface_hidden = !d.view.interface_hidden; }},
    Binding{"File", ""},
    Binding{"Ctrl + N", "a new map", GLFW_KEY_N, GLFW_KEY_N, kControl,
            [](D& d, const K&) { d.view.wanted = Dialog::new_map; }},
    Binding{"Ctrl + O", "open a scene, a mesh or a map; or drop it on the window", GLFW_KEY_O, GLFW_KEY_O,
            kControl, [](D& d, const K&) { d.view.wanted = Dialog::open; }},
    Binding{"Ctrl + S, Ctrl + Shift + S", "save the map, save as", GLFW_KEY_S, GLFW_KEY_S, kControl,
            [](D& d, const K&) { d.save(); }},
    Binding{"", "save as", GLFW_KEY_S, GLFW_KEY_S, kControl | kShift,
            [](D& d, const K&) { d.view.wanted = Dialog::save_as; }},
    Binding{"Ctrl + E", "export the map with a range of values", GLFW_KEY_E, GLFW_KEY_E, kControl,
            [](D& d, const K&) { d.view.wanted = Dialog::export_map; }},
    Binding{"Ctrl + Z", "undo", GLFW_KEY_Z, GLFW_KEY_Z, kControl, [](D& d, const K&) { d.undo(); },
            Binding::repeats},
    Binding{"Ctrl + Shift + Z, Ctrl + Y", "redo", GLFW_KEY_Z, GLFW_KEY_Z, kControl | kShift,
            [](D& d, const K&) { d.redo(); }, Binding::repeats},
    Binding{"", "redo", GLFW_KEY_Y, GLFW_KEY_Y, kControl, [](D& d, const K&) { d.redo(); }, Binding::repeats},
    Binding{"F12", "screenshot of the window into the working folder", GLFW_KEY_F12, GLFW_KEY_F12, 0,
            [](D& d, const K&) { d.view.screenshot_wanted = true; }, Binding::always},
    Binding{"Ctrl + Q", "quit", GLFW_KEY_Q, GLFW_KEY_Q, kControl, [](D& d, const K&) { d.leave({}); }},
    Binding{"F1", "this list", GLFW_KEY_F1, GLFW_KEY_F1, 0,
            [](D& d, const K&) { d.view.wanted = Dialog::keys; }},
};

}  // namespace

std::span<const Binding> bindings() {
    return kBindings;
}

void on_key(Desk& desk, const InputEvent& event, PixelSize picture, bool busy) {
    const int mods = event.mods & (kControl | kShift | GLFW_MOD_ALT);
    for (const Binding& binding : kBindings)
        if (binding.run && (binding.when == Binding::always || !busy) && event.code >= binding.first &&
            event.code <= binding.last && mods == binding.mods) {
            if (!event.repeated || binding.when == Binding::repeats) binding.run(desk, {event.code, picture});
            return;
        }
}

}  // namespace relievo::gui
