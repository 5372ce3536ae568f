// Dialogs about map files: a new map of a chosen size and format, and an export with a stated range of
// values.
#pragma once

#include <string>

#include "editor/gui/desk.h"

namespace relievo::gui {

class MapDialogs {
  public:
    // Opens with the next draw().
    void open_new(const Desk& desk);
    void open_export(const Desk& desk);
    void draw(Desk& desk);  // every frame

  private:
    enum class Values { unit, world, custom };
    void draw_new(Desk& desk);
    void draw_export(Desk& desk);
    void range_rows(const Desk& desk);
    void choose_name(const Desk& desk, const char* suffix);
    void name_row(MapFormat& format);
    void ask_anew();
    bool may_write();  // says why not, and asks once more before a file is replaced

    bool opening_new_ = false, opening_export_ = false;
    std::string name_, trouble_;
    bool confirmed_ = false;
    NewMap fresh_;
    MapFormat format_ = MapFormat::exr_float;  // of an export
    Values values_ = Values::unit;
    MapRange range_;  // chosen by hand
};

}  // namespace relievo::gui
