// The plots of a comparison: error against time, for one scene and over all of them.
#pragma once

#include "editor/session/compare/result.h"
#include "editor/session/compare/svg_plot.h"

namespace relievo {

enum class PlottedError {
    p99,
    p999,  // of the depth, over the unit
    gap,   // p99 of the gap along edges, over the unit
};

Plot scene_plot(const Comparison& comparison, const ComparedScene& scene, PlottedError error);
// Times over the subject's in the same scene: scenes of any weight in one picture.
Plot overall_plot(const Comparison& comparison, PlottedError error);

}  // namespace relievo
