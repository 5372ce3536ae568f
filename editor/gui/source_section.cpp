// The side panel's section about procedural heights: the exemplar, how it is tiled, and the bake that makes a map of it.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/widgets.h"
#include "editor/session/bake.h"

namespace relievo::gui {
namespace {

constexpr float kShownOffset = 4;  // exemplar periods that the sliders reach; Ctrl+click types more
constexpr int kShownSeeds = 999;

void exemplar_row(Desk& desk, const Procedural& source) {
    row_label("File");
    if (push_button((source.exemplar.filename().string() + "##exemplar").c_str(), true,
                    "Choose the image whose relief goes on without end: a 16-bit PNG or TIFF, or an EXR."))
        desk.view.wanted = Dialog::exemplar;
}

void tiling_rows(Desk& desk, const Procedural& source) {
    auto scale = static_cast<float>(source.scale);
    if (slider_row("Scale", scale, {0.05f, 50, true, "%.3f"}, "Exemplar periods over the map. More is finer.", "periods"))
        desk.set("procedural.scale", std::clamp(static_cast<double>(scale), Procedural::kLeastScale, Procedural::kMostScale));
    auto size = static_cast<float>(source.triangle_size);
    if (slider_row("Triangles", size, {0.02f, 2, true, "%.3f"},
                   "Edge of the triangles that pieces of the exemplar are blended over. Large ones keep large shapes, and "
                   "show more of the exemplar as it is.",
                   "periods"))
        desk.set("procedural.triangle_size",
                 std::clamp(static_cast<double>(size), Procedural::kLeastTriangle, Procedural::kMostTriangle));
    for (int axis = 0; axis < 2; ++axis) {
        auto offset = static_cast<float>(source.offset[axis]);
        if (!slider_row(axis == 0 ? "Offset u" : "Offset v", offset, {-kShownOffset, kShownOffset},
                        "Moves over the endless surface.", "periods"))
            continue;
        std::vector<double> moved{source.offset.x, source.offset.y};
        moved[static_cast<std::size_t>(axis)] =
            std::clamp(static_cast<double>(offset), -Procedural::kMostOffset, Procedural::kMostOffset);
        desk.set("procedural.offset", moved);
    }
    auto seed = static_cast<float>(source.seed);
    if (slider_row("Seed", seed, {0, kShownSeeds, false, "%.0f"}, "Another seed, another surface of the same kind."))
        desk.set("procedural.seed", std::clamp(std::round(static_cast<double>(seed)), 0.0, double{Procedural::kMostSeed}));
}

void bake_row(Desk& desk, const Procedural& source) {
    const HeightMap& exemplar = desk.session.map();
    const ImageSize size = bake_size(source, exemplar.width(), exemplar.height());
    const std::string texels = std::to_string(size.width) + " x " + std::to_string(size.height);
    if (push_button("Bake and sculpt", true,
                    "Makes a map of " + texels + " texels of these heights, which brushes can work on. The sliders go; undo "
                    "does not bring them back."))
        desk.bake(size);
}

}  // namespace

void draw_source_section(Desk& desk) {
    const auto& source = desk.session.scene().objects.front().displacement.procedural;
    if (!source || !section("Procedural heights")) return;
    const Procedural shown = *source;
    exemplar_row(desk, shown);
    tiling_rows(desk, shown);
    bake_row(desk, shown);
}

}  // namespace relievo::gui
