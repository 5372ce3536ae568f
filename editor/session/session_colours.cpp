// See session_colours.h.
#include "editor/session/session_colours.h"

#include <cmath>
#include <stdexcept>

#include "editor/session/memory_estimate.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

void require_memory_for(const fs::path& file, const ColourInfo& info, bool on_device) {
    require_memory(file, {info.width, info.height, 0, MapFormat::png16},
                   estimate_colour_memory(info, on_device), available_memory());
}

}  // namespace

std::array<std::uint16_t, 3> encoded_colour(const glm::vec3& linear) {
    std::array<std::uint16_t, 3> counts{};
    for (int k = 0; k < 3; ++k) {
        const double value = std::min(std::max(static_cast<double>(linear[k]), 0.0), 1.0);
        const double encoded = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
        counts[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(std::lround(encoded * 65535));
    }
    return counts;
}

std::array<float, 3> as_floats(const std::array<std::uint16_t, 3>& counts) {
    const auto part = [](std::uint16_t count) { return static_cast<float>(count) / 65535.0f; };
    return {part(counts[0]), part(counts[1]), part(counts[2])};
}

SessionColours::SessionColours(const fs::path& start, const fs::path& own, bool on_device)
    : start_file_(start), file_(own) {
    if (start.empty()) return;
    require_memory_for(start, colour_info(start), on_device);
    loaded_ = load_colours(start);
}

ColourView view_of(const ColourMap& m) {
    return {m.width(),
            m.height(),
            m.bits(),
            {m.plane(0).texels().data(), m.plane(1).texels().data(), m.plane(2).texels().data()}};
}

ColourView SessionColours::view() const { return loaded_ ? view_of(loaded_->map) : ColourView{}; }

std::array<std::uint16_t, 3> SessionColours::at(const glm::dvec2& uv, bool clamp) const {
    const auto texel = [&](double position, int size) {
        const double part = clamp ? std::min(std::max(position, 0.0), 1.0) : position - std::floor(position);
        return std::min(static_cast<int>(part * size), size - 1);
    };
    const ColourMap& m = map();
    const int x = texel(uv.x, m.width()), y = texel(uv.y, m.height());
    return {m.plane(0).at(x, y), m.plane(1).at(x, y), m.plane(2).at(x, y)};
}

ColourMap SessionColours::of_one_colour(int width, int height, int bits, const glm::vec3& albedo, bool on_device) const {
    if (loaded_) throw std::invalid_argument("there is a colour map already");
    require_memory_for("new colour map", {width, height, bits, 3}, on_device);
    return ColourMap(width, height, bits, encoded_colour(albedo));
}

fs::path SessionColours::path_beside(const fs::path& height_map) const {
    const std::string ending = file_.empty() ? ".png" : file_.extension().string();
    const std::string stem = height_map.stem().string() + "_colour";
    fs::path path = height_map.parent_path() / (stem + ending);
    std::error_code ignored;
    for (int number = 2; fs::exists(path, ignored); ++number)
        path.replace_filename(stem + "_" + std::to_string(number) + ending);
    return path;
}

}  // namespace relievo
