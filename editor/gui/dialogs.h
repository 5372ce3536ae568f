// The dialogs over the picture: keys, open, new map, save as, export, unsaved work, recovery after a crash.
// One at a time.
#pragma once

#include <optional>
#include <string>

#include "editor/gui/desk.h"
#include "editor/gui/file_dialog.h"
#include "editor/gui/map_dialogs.h"

namespace relievo::gui {

class Dialogs {
  public:
    // Opens what desk.view.wanted asks for, and draws what is open.
    void draw(Desk& desk);

  private:
    void open(Desk& desk, Dialog dialog);
    void draw_files(Desk& desk);
    void draw_unsaved(Desk& desk);

    FileDialog files_;
    MapDialogs maps_;
    Dialog file_purpose_ = Dialog::none;
    std::optional<Departure> after_saving_;  // of a save on the way out
    std::string unsaved_trouble_;  // why the map could not be saved on the way out
};

// The browser for what can be opened, which the start without a scene needs too.
FileDialog::Purpose open_purpose();

}  // namespace relievo::gui
