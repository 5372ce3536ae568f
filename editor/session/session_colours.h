// The edited object's colour map in a session: the scene's albedo map, or one that a command made.
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "brushes/colour_file.h"
#include "renderer/renderer.h"

namespace relievo {

// sRGB-encoded counts of a linear colour in [0, 1].
std::array<std::uint16_t, 3> encoded_colour(const glm::vec3& linear);

std::array<float, 3> as_floats(const std::array<std::uint16_t, 3>& counts);  // [0, 1]

ColourView view_of(const ColourMap& map);

class SessionColours {
  public:
    // Loads `start`; empty: there is no map yet. `own`: what saving means, the scene's albedo map.
    // `on_device`: a renderer will hold it, too. Throws as load_colours, and std::invalid_argument before
    // anything is loaded when memory would not do (memory_estimate.h).
    SessionColours(const std::filesystem::path& start, const std::filesystem::path& own, bool on_device);

    bool there() const { return loaded_.has_value(); }
    ColourMap& map() { return loaded_->map; }  // where there is one
    const ColourMap& map() const { return loaded_->map; }
    ColourView view() const;  // empty where there is none
    // The nearest texel; where there is a map.
    std::array<std::uint16_t, 3> at(const glm::dvec2& uv, bool clamp) const;
    const std::filesystem::path& start_file() const { return start_file_; }
    // The map's own: the scene's, or where it was last saved; empty: none yet.
    const std::filesystem::path& file() const { return file_; }

    // A map of one colour, to be taken. std::invalid_argument where there is one already, on bits other than 8 and 16, and
    // when memory would not do.
    ColourMap of_one_colour(int width, int height, int bits, const glm::vec3& albedo, bool on_device) const;
    void take(ColourMap map) { loaded_ = LoadedColours{std::move(map), nullptr}; }  // whose texels stay where they are

    // A new file beside a displacement map of that name: NAME_colour.png, or with the ending that the file
    // has now; with a number where that exists.
    std::filesystem::path path_beside(const std::filesystem::path& height_map) const;
    void save(const std::filesystem::path& path, const Advance& advance = {}) const {
        save_colours(map(), path, loaded_->origin.get(), advance);
    }
    void set_file(const std::filesystem::path& path) { file_ = path; }

  private:
    std::filesystem::path start_file_, file_;
    std::optional<LoadedColours> loaded_;
};

}  // namespace relievo
