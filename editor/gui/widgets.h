// Rows of a panel: a label, a control, and a tooltip that says what it means.
#pragma once

#include <functional>
#include <string>
#include <string_view>

struct ImVec2;

namespace relievo::gui {

struct Range {
    float low, high;
    bool logarithmic = false;
    const char* format = "%.3f";
};

// A bar filled up to the value, with the number on it; as wide as the item width. Ctrl+click types a value.
bool bar_slider(const char* label, float& value, const Range& range, const char* format);

// Each returns true when the user changed the value. `unit` and `tooltip` may be empty.
bool slider_row(std::string_view label, float& value, const Range& range, std::string_view tooltip,
                std::string_view unit = {});
bool switch_row(std::string_view label, bool& value, std::string_view tooltip);
bool color_row(std::string_view label, float (&rgb)[3], std::string_view tooltip);  // linear
// Three numbers and a patch, which opens a picker: no larger than the window, it scrolls then. ImGuiColorEditFlags.
bool color_edit(const char* label, float (&rgb)[3], int flags);
void text_row(std::string_view label, std::string_view value);

// A path's end says which file it is: where there is no room for the whole, that is what is seen of it.
// "..." and as much of the end as fits, of UTF-8; all of it where it does.
std::string fitting_end(std::string_view path, float room, const std::function<float(std::string_view)>& width_of);
float text_width(std::string_view text);  // pixels
void path_text(const std::string& path);  // dim, up to the line's end; a tooltip has the whole where it is cut off
// True when the user changed it. A click takes all of it and goes to its end.
bool path_input(const char* label, std::string& path);

// A heading that folds what follows; returns whether it is open.
bool section(const char* title);

// A button that may be greyed out or lit as chosen.
bool push_button(const char* label, bool enabled, std::string_view tooltip);

// Over the last item.
void tooltip(std::string_view text, std::string_view title = {});

// A dialog in the window's middle, `width` points wide and as tall as what it holds, but no larger than the window: it
// scrolls then. Pair with ImGui::EndPopup() where it returns true. `keep`, where given, becomes false when the user
// closes it.
bool begin_modal(const char* title, float width, bool* keep = nullptr);

// A dialog's button; the suggested one is what Enter pushes.
bool dialog_button(const char* label, bool suggested = false);
// The next one goes beside the last where there is room, else below.
void beside_dialog_button();
bool escape_pressed();  // but for a list over a dialog, which alone it closes
// Lists that unfold and pickers of colours, which Dear ImGui 1.86 leaves open. Called once a frame, after all else.
void close_list_on_escape();
// Where the window has shrunk under them, they go back into it: Dear ImGui 1.86 places them once, and leaves no more than
// an edge within. Called once a frame, before all else.
void keep_lists_in_window();
// For the list that is begun next and unfolds downwards from `top`: it ends where the window does, and scrolls then.
void end_list_in_window(float top);
// In a list that is begun: what the wheel brings under a pointer at rest does not unfold until that moves.
void keep_folded_while_scrolling();
void note(std::string_view text);  // a line about what is wrong in a dialog; it keeps its place when empty

// Puts the cursor where a control of the row begins, after drawing its label.
void row_label(std::string_view label);

}  // namespace relievo::gui
