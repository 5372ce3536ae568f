// What the picture shows of the surface.
#include "editor/gui/views.h"

#include <array>

namespace relievo::gui {
namespace {

constexpr std::array kViews{
    ViewInfo{View::beauty, "Beauty", "The surface in its light."},
    ViewInfo{View::normals, "Normals",
             "The surface's own normal: x, y and z of the scene as red, green and blue."},
    ViewInfo{View::height, "Height", "How far the surface stands over its base mesh, in world units."},
    ViewInfo{View::steps, "Steps",
             "What each pixel's ray costs the method: which count is chosen under Method."},
    ViewInfo{
        View::error, "Error",
        "Depth beside the double-precision reference, over the amplitude. The reference is traced on the "
        "processor while you look, coarse to fine."},
    ViewInfo{View::prisms, "Prisms",
             "The base mesh over the picture, and the prism of each triangle between the least and the "
             "greatest height of its part "
             "of the map."},
};

constexpr std::array kCounts{
    RayCountInfo{"boxes", "Triangles whose box the ray met."},
    RayCountInfo{"steps", "Stretches or samples of the ray that the method looked at."},
    RayCountInfo{"fetches", "Reads of the map and of its pyramid."},
    RayCountInfo{"cells", "Texel cells whose surface was solved."},
};

}  // namespace

std::span<const ViewInfo> views() {
    return kViews;
}

const ViewInfo& view_info(View view) {
    return kViews[static_cast<std::size_t>(view)];
}

View next_view(View view, int step) {
    const int count = static_cast<int>(kViews.size());
    return static_cast<View>(((static_cast<int>(view) + step) % count + count) % count);
}

std::span<const RayCountInfo> ray_counts() {
    return kCounts;
}

}  // namespace relievo::gui
