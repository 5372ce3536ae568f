// The mask over one renderer's picture.
#include "editor/gui/mask_veil.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/gui/map_value.h"

namespace relievo::gui {
namespace {

constexpr double kDarkest = 0.35;  // share of the encoded colour that full protection leaves
constexpr glm::vec2 kUnknown{std::numeric_limits<float>::quiet_NaN()};
constexpr glm::vec2 kElsewhere{std::numeric_limits<float>::infinity()};

}  // namespace

void MaskVeil::reset(PixelSize size) {
    size_ = size;
    known_ = 0;
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    places_ = std::vector<glm::vec2>(pixels, kUnknown);
    clear_ = std::vector<std::uint8_t>(pixels * 4, 0);
    painted_ = clear_;
}

void MaskVeil::collect(const Renderer& renderer, const PixelRect& window) {
    const std::vector<float> uv = renderer.traced_layer(Layer::uv, window);
    const std::vector<float> id = renderer.traced_layer(Layer::id, window);
    std::size_t from = 0;
    for (int y = window.y0; y < window.y1; ++y) {
        for (int x = window.x0; x < window.x1; ++x, ++from) {
            glm::vec2& place = places_[index(x, y)];
            known_ += std::isnan(place.x) ? 1 : 0;
            const bool there = id[from] == 1 && std::isfinite(uv[2 * from]) && std::isfinite(uv[2 * from + 1]);
            place = there ? glm::vec2(uv[2 * from], uv[2 * from + 1]) : kElsewhere;
        }
    }
}

void MaskVeil::take(const std::vector<std::uint8_t>& rgba, const PixelRect& window) {
    const auto row = static_cast<std::ptrdiff_t>(window.x1 - window.x0) * 4;
    for (int y = window.y0; y < window.y1; ++y)
        std::copy_n(rgba.begin() + row * (y - window.y0), row,
                    clear_.begin() + static_cast<std::ptrdiff_t>(index(window.x0, y) * 4));
}

void MaskVeil::paint(const PixelRect& window, const HeightMap* mask, Wrap wrap) {
    for (int y = window.y0; y < window.y1; ++y) {
        for (int x = window.x0; x < window.x1; ++x) {
            const std::size_t at = index(x, y);
            const bool on_map = mask && std::isfinite(places_[at].x);
            const double covered = on_map ? map_value(*mask, wrap, places_[at]) / 65535 : 0;
            const double left = 1 - covered * (1 - kDarkest);
            for (std::size_t c = 4 * at; c < 4 * at + 3; ++c)
                painted_[c] = static_cast<std::uint8_t>(std::lround(clear_[c] * left));
            painted_[4 * at + 3] = 255;
        }
    }
}

}  // namespace relievo::gui
