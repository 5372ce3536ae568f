// See bake.h.
#include "editor/session/bake.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "brushes/shared_work.h"
#include "editor/session/text.h"

namespace relievo {

void check_bakeable(const SceneObject& object) {
    for (const glm::vec2& uv : object.mesh.uvs) {
        if (std::min(uv.x, uv.y) >= 0 && std::max(uv.x, uv.y) <= 1) continue;
        throw std::invalid_argument(object.name + ": texture coordinates (" + number_text(uv.x) + ", " +
                                    number_text(uv.y) + ") leave [0, 1], which is all that a baked map holds");
    }
}

ImageSize bake_size(const Procedural& settings, int exemplar_width, int exemplar_height) {
    const auto texels = [&](int side) {
        return static_cast<int>(std::clamp(std::round(settings.scale * side), 1.0, double{HeightMap::kMaxSize}));
    };
    return {texels(exemplar_width), texels(exemplar_height)};
}

HeightMap bake(const ProceduralSource& source, const ImageSize& size, const Advance& advance) {
    constexpr int kRows = 64;  // between two looks at `advance`
    HeightMap map(size.width, size.height);
    const auto fill = [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const glm::dvec2 uv((x + 0.5) / size.width, (y + 0.5) / size.height);
            map.set(x, y, static_cast<std::uint16_t>(std::lround(65535 * source.value(source.texel_at(uv)))));
        }
    };
    for (int low = 0; low < size.height; low += kRows) {
        tell(advance, static_cast<double>(low) / size.height, "The bake was stopped");
        const int rows = std::min(kRows, size.height - low);
        share_work(static_cast<std::size_t>(rows), [&](std::size_t row) { fill(low + static_cast<int>(row)); });
    }
    return map;
}

Displacement baked_displacement(const Displacement& procedural, const std::filesystem::path& map) {
    Displacement d = procedural;
    d.procedural.reset();
    d.map = map;
    d.wrap = Wrap::clamp;
    d.range_low = 0;
    d.range_high = 1;
    return d;
}

}  // namespace relievo
