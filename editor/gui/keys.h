// Keys of the keyboard and buttons of the mouse: one table that says what they do, does it, and is what F1
// shows.
#pragma once

#include <span>
#include <string_view>

#include "editor/gui/desk.h"

namespace relievo::gui {

struct KeyPress {
    int key = 0;        // GLFW's
    PixelSize picture;  // for views
};

struct Binding {
    std::string_view keys, meaning;  // for F1; an empty meaning: a heading; no keys: not listed on its own
    int first = 0, last = 0;         // GLFW keys, from first to last; 0: of the mouse, or a heading
    int mods = 0;                    // GLFW_MOD_CONTROL, _ALT and _SHIFT, exactly these
    void (*run)(Desk& desk, const KeyPress& press) = nullptr;
    enum { once, repeats, always } when = once;  // repeats: as long as it is held; always: in a stroke, and while a
                                                 // dialog is open or text is being typed, too
};
std::span<const Binding> bindings();

// `picture`: its size. `busy`: in a stroke or drag, or while a dialog has the keyboard.
void on_key(Desk& desk, const InputEvent& event, PixelSize picture, bool busy);

}  // namespace relievo::gui
