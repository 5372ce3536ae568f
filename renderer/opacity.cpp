// See opacity.h.
#include "renderer/opacity.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <stdexcept>

namespace relievo {

OpacityMap load_opacity_map(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input)
        throw std::invalid_argument(path.string() + ": cannot read the opacity map: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > 16384 || spec.height > 16384)
        throw std::invalid_argument(path.string() + ": an opacity map has 1 to 16384 texels a side");
    const int channel = spec.alpha_channel >= 0 ? spec.alpha_channel : 0;
    OpacityMap map{spec.width, spec.height, {}};
    const auto row = static_cast<std::size_t>(spec.width);
    map.texels.resize(row * static_cast<std::size_t>(spec.height));
    if (!input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::UINT8, map.texels.data()))
        throw std::invalid_argument(path.string() + ": the opacity map is cut off: " + input->geterror());
    for (std::size_t low = 0, high = static_cast<std::size_t>(spec.height) - 1; low < high; ++low, --high) {
        std::swap_ranges(map.texels.begin() + static_cast<std::ptrdiff_t>(low * row),
                         map.texels.begin() + static_cast<std::ptrdiff_t>((low + 1) * row),
                         map.texels.begin() + static_cast<std::ptrdiff_t>(high * row));
    }
    return map;
}

}  // namespace relievo
