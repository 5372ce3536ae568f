// See dab_cost.h. Tools that resample the relief fit a plane for every texel, which takes about ten times as
// long as to raise it.
#include "brushes/dab_cost.h"

#include <vector>

#include "brushes/symmetry.h"

namespace relievo {

DabCost dab_cost(const Brush& brush, const SurfacePoint& centre, const Surface& surface) {
    constexpr ToolSet kResamples =
        tool_set({Tool::inflate, Tool::crease, Tool::pinch, Tool::grab, Tool::smear, Tool::clone});
    constexpr double kResampling = 10;
    std::vector<SurfaceTexel> texels;
    surface.texels_in_ball(centre.position, brush.radius, texels);
    DabCost cost{texels.size(), symmetry_copies(brush, surface.world_from_object()).size(), 0};
    cost.work = static_cast<double>(cost.texels) * static_cast<double>(cost.copies) *
                (holds(kResamples, brush.tool) ? kResampling : 1.0);
    return cost;
}

}  // namespace relievo
