// Replays a journal through the session's commands. It never picks: dabs carry their addresses, so the map
// comes out bit for bit as it was recorded, on any machine.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "editor/session/journal.h"
#include "editor/session/session.h"

namespace relievo {

struct ReplayOptions {
    bool force = false;  // go on though mesh, map or stamped images differ from the recorded ones
    bool live = false;  // trace the window around the brush, as the editor does while a stroke runs, at up to
                        // kLiveTraces dabs spread evenly over the journal
    int spp = 0;        // of `render` and `expect_image` lines that name none; 0: the scene's
    // Folder for pictures that `expect_image` refused; empty: the temporary one.
    std::filesystem::path failed_pictures;
    std::function<void(std::size_t done, std::size_t total)> progress;  // in operations
};

struct ReplayReport {
    std::size_t strokes = 0, dabs = 0, expectations = 0;
    std::vector<std::string> failures;  // one sentence for each expectation that failed, with FILE:LINE
    std::vector<StageTimes> dab_times;  // of every dab, in order; trace_ms only with `live`
};

constexpr int kLiveWindow = 256;  // pixels a side
constexpr std::size_t kLiveTraces = 200;

// A journal that renders needs a session with a renderer.
bool needs_renderer(const Journal& journal);

// Throws std::invalid_argument when the session's mesh or map, or an image that was stamped, is not the one
// that the journal was recorded with (with `force` only where dabs could not be applied), or when an
// operation does not fit; std::runtime_error when rendering fails. A failed expectation is no error here: the
// replay goes on, and the report tells.
ReplayReport replay(const Journal& journal, Session& session, const ReplayOptions& options = {});

struct StageSummary {
    std::string stage;  // edit, upload, bounds, refit, trace
    double median_ms = 0, p95_ms = 0, max_ms = 0;
    std::size_t count = 0;  // dabs in which the stage ran; the figures are of these
};
std::vector<StageSummary> summarize(const std::vector<StageTimes>& times);

}  // namespace relievo
