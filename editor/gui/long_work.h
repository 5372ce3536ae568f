// Work that may take long, such as saving a large map: done between two frames, and seen and stopped after half a second.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "brushes/advance.h"
#include "editor/gui/window.h"

namespace relievo::gui {

struct LongWork {
    std::string title;                                          // "Saving NAME"
    std::function<void(const Advance&)> run;
    std::function<void()> done{};
    std::function<void(const std::string& trouble)> failed{};  // empty: a message tells
};

constexpr double kUnseenWorkMs = 500;  // what is shorter shows nothing

// What is shown of it.
struct WorkShown {
    std::string title;
    double part = 0;       // [0, 1]
    std::string text{};    // on the bar; empty: the part
    bool stopped = false;  // the user wants it to end
};

constexpr double kWorkLookMs = 50;     // between two looks at what the user does meanwhile

// Looks at that. Behind the first `kept` events of the window are left that something was let go, and keys, which are for
// what comes. True where what is new may be meant for the work: only a frame can tell, and is drawn at once.
bool poll_behind_work(Window& window, std::size_t kept);

// Call it every frame, outside of any dialog.
void draw_long_work(std::optional<WorkShown>& work);

}  // namespace relievo::gui
