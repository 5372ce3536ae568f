// The command line: verbs, their options, exit status (DESIGN.md section 6).
#pragma once

#include <filesystem>
#include <functional>

#include "editor/session/session.h"

namespace relievo {

// What `relievo edit` asks of the window.
struct EditRequest {
    std::filesystem::path scene;      // empty: none was given
    std::filesystem::path frame_log;  // empty: none
    double most_fps = 0;              // frames a second at most; 0: no limit
    SessionOptions session;
};
using EditorEntry = std::function<int(const EditRequest&)>;

// Runs one verb. Returns the exit status: 0 done, 1 failed, 2 bad usage or bad input; an error is one line on
// stderr. `editor` is empty in a build without a window.
int run_cli(int argc, const char* const* argv, const EditorEntry& editor);

}  // namespace relievo
