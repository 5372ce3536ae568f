// See dab_cost.h. Tools that resample the relief fit a plane for every texel, which takes about ten times as
// long as to raise it, and hold the relief around the brush; grab looks for where each came from, too, and
// takes hold of more than twice the brush's reach. Inflate adds every texel to the moments of corners around,
// which takes as long, and holds the corners alone.
#include "brushes/dab_cost.h"

#include <algorithm>

#include "brushes/symmetry.h"

namespace relievo {

namespace {

constexpr ToolSet kResamples = tool_set({Tool::crease, Tool::pinch, Tool::grab, Tool::smear, Tool::clone});
constexpr ToolSet kLists =
    tool_set({Tool::smooth, Tool::flatten, Tool::clay, Tool::stamp, Tool::mask});  // mask: where it blurs

double work_of_texel(Tool tool) {
    if (tool == Tool::grab) return 17;
    return tool == Tool::inflate || holds(kResamples, tool) ? 10 : 1;
}

}  // namespace

DabCost dab_cost(const Brush& brush, const SurfacePoint& centre, const Surface& surface) {
    DabCost cost{surface.count_in_ball(centre.position, brush.radius),
                 symmetry_copies(brush, surface.world_from_object()).size(), 0};
    cost.work =
        static_cast<double>(cost.texels) * static_cast<double>(cost.copies) * work_of_texel(brush.tool);
    return cost;
}

std::size_t bytes_of_copy(Tool tool, std::size_t texels) {
    constexpr std::size_t kAtLeast = std::size_t{4} << 20;  // parts of the ball, and blocks of changes
    const std::size_t each = tool == Tool::grab        ? 500
                             : holds(kResamples, tool) ? 130
                             : holds(kLists, tool)     ? 90
                                                       : 50;
    return kAtLeast + each * texels;
}

std::size_t copies_at_once(Tool tool, std::size_t texels) {
    return std::max(std::size_t{1}, kDabBytes / bytes_of_copy(tool, texels));
}

}  // namespace relievo
