// The dialogs over the picture: keys, open, save as, unsaved work, recovery after a crash. One at a time.
#pragma once

#include "editor/gui/desk.h"
#include "editor/gui/file_dialog.h"

namespace relievo::gui {

class Dialogs {
  public:
    // Opens what desk.view.wanted asks for, and draws what is open.
    void draw(Desk& desk);

  private:
    void open(Desk& desk, Dialog dialog);
    void draw_files(Desk& desk);

    FileDialog files_;
    Dialog file_purpose_ = Dialog::none;
};

// The browser for scene files, which the start without a scene needs too.
FileDialog::Purpose scene_purpose();

}  // namespace relievo::gui
