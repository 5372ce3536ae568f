// What the picture shows of the surface: its light, or what is measured on it.
#pragma once

#include <span>
#include <string_view>

namespace relievo::gui {

enum class View { beauty, normals, height, steps, error, prisms };

struct ViewInfo {
    View view;
    std::string_view name, tooltip;
};
std::span<const ViewInfo> views();  // in the order of the enumeration, which is that of the menu
const ViewInfo& view_info(View view);
View next_view(View view, int step);  // round and round

// Which of the renderer's counts (Layer::counts, in this order) the view `steps` shows.
enum class RayCount { boxes, steps, fetches, cells };

struct RayCountInfo {
    std::string_view name, tooltip;
};
std::span<const RayCountInfo> ray_counts();

// Whether the picture is made of the layers of the pixels' centres, traced once, in place of light that many
// samples gather.
constexpr bool shows_layers(View view) {
    return view != View::beauty && view != View::prisms;
}

}  // namespace relievo::gui
