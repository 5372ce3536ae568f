// Frame times in interleaved rounds: every point once a round, so that what slows the machine meets all
// alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "editor/session/compare/budget.h"
#include "editor/session/compare/method_renderers.h"
#include "editor/session/compare/result.h"

namespace relievo {

struct TimedPoint {
    const PointChoice* choice;
    ComparedPoint* result;
    double frame_ms;  // expected of a primary and a preview frame
};

// `tell` hears of the round under way, out of how many.
using TellRound = std::function<void(int round, int rounds)>;

// Leaves out, with a sentence in `cut`, the slowest points that would leave no time for three rounds; the
// first point stays.
void fit_points(std::vector<TimedPoint>& points, double seconds, std::vector<std::string>& cut);

// Warm-up rounds for half a second, as the clock of a GPU that rested rises with its work; then as many as the
// budget has time for, up to a limit; one at least. Returns their number.
int time_frames(MethodRenderers& renderers, const std::vector<TimedPoint>& points, const Budget& budget,
                double kept_seconds, const TellRound& tell);

// Traces a primary frame, uploads a changed rectangle of the first object's map around `uv`, traces another
// frame, and puts the map back; three rounds, fewer where the budget ends. Fills ComparedPoint::edit.
void time_edits(MethodRenderers& renderers, const std::vector<TimedPoint>& points, const HeightMap& map,
                const glm::dvec2& uv, const Budget& budget, const TellRound& tell);

}  // namespace relievo
