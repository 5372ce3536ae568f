// See error_map.h.
#include "editor/session/compare/error_map.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

// From dark blue through green and yellow to red, evenly brighter up to the middle; one stop a decade.
constexpr std::array<Rgb, 7> kStops{Rgb{20, 24, 82},   Rgb{28, 82, 140},  Rgb{32, 144, 140}, Rgb{94, 190, 98},
                                    Rgb{240, 224, 80}, Rgb{246, 138, 42}, Rgb{206, 24, 38}};

}  // namespace

Rgb error_color(double error) {
    const double decades = std::log10(kErrorMapHigh / kErrorMapLow);
    double place = error > 0 ? std::log10(error / kErrorMapLow) / decades : 0;
    place = std::clamp(std::isnan(place) ? 1.0 : place, 0.0, 1.0) * (kStops.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(low);
    Rgb color{};
    for (std::size_t c = 0; c < 3; ++c)
        color[c] =
            static_cast<std::uint8_t>(std::lround(kStops[low][c] * (1 - part) + kStops[low + 1][c] * part));
    return color;
}

DisplayPicture error_map(int width, int height, const std::vector<Judge::PixelError>& errors) {
    DisplayPicture picture{width, height, {}};
    picture.rgba.reserve(errors.size() * 4);
    for (const Judge::PixelError& error : errors) {
        using Kind = Judge::PixelError::Kind;
        const Rgb color = error.kind == Kind::missed     ? kMissedColor
                          : error.kind == Kind::invented ? kInventedColor
                          : error.kind == Kind::nothing  ? kNothingColor
                                                         : error_color(static_cast<double>(error.depth));
        picture.rgba.insert(picture.rgba.end(), {color[0], color[1], color[2], 255});
    }
    return picture;
}

}  // namespace relievo
