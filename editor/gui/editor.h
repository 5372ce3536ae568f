// The window's entry: what `relievo edit` calls.
#pragma once

#include <filesystem>

#include "editor/session/session.h"

namespace relievo {

struct EditorOptions {
    std::filesystem::path scene;      // empty: the sample beside the program, else the window asks
    std::filesystem::path frame_log;  // when frames and dabs were shown (gui/frame_log.h); empty: not written
    double most_fps = 0;              // frames a second at most; 0: as many as there are to show
    SessionOptions session;           // its width and height, where not 0, are the window's (pixels)
};

// Runs the window until the user closes it; returns the exit status. Throws std::invalid_argument on a bad
// scene, std::runtime_error when there is no display or no device, or when the validation layers had anything
// to say.
int run_editor(const EditorOptions& options);

}  // namespace relievo
