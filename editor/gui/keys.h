// Keys of the keyboard: what they do, and the list that F1 shows.
#pragma once

#include <span>
#include <string_view>

#include "editor/gui/desk.h"

namespace relievo::gui {

struct KeyHelp {
    std::string_view keys, meaning;  // an empty meaning: a heading
};
std::span<const KeyHelp> key_help();

// A key press while no dialog is open and no text is being typed. `picture`: its size, for views.
void on_key(Desk& desk, const InputEvent& event, PixelSize picture);

}  // namespace relievo::gui
