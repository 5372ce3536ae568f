// The methods and their parameters as data: menus, the command line's help, tests and comparison read this table.
// To add a method: shaders/methods/<name>/intersect.glsl, renderer/methods/<name>.cpp, one line in methods/all.h.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace relievo {

struct MethodParameter {
    std::string_view name, unit, tooltip;
    double low, high, standard;
    bool is_switch = false;  // 0 or 1
    // What trades error against time: the values that `compare` tries, coarse and quick ones first. Empty: left as it is.
    std::span<const double> sweep{};
    // Over a procedural source, where any parameter of the method has it: these alone are tried.
    std::span<const double> procedural_sweep{};
    std::span<const std::string_view> names{};  // of the values 0, 1, ...; empty: a number
    bool shapes_build = false;  // what is built depends on it: a change builds anew
};

// Which boxes and per-triangle data a method's rays meet.
enum class GeometryKind {
    parallel_prisms,
    surface_bounds,
    triangles,  // micro-triangles of S: a driver's structure holds themselves, and the method's intersect.glsl defines
                // RELIEVO_TRIANGLES (shaders/trace/triangles.glsl); our own tree holds boxes around them
};

// Where what a method returns may lie: rays pass a triangle by that do not meet that.
enum class HitPlace {
    on_surface,  // on S, but for rounding; its prisms may be slanted (gpu::kPrimitiveSlanted), as enter_prism() meets them
    in_prism,    // between samples in the triangle's prism, widened by the shell margin where it is S that is sampled
    in_box,      // anywhere in the triangle's box
};

// What bounds the map's heights over its cells.
enum class MapBounds {
    none,
    heights,  // the least and the greatest (renderer/height_pyramid.h)
    planes,   // the same of the height over a plane (renderer/height_slabs.h); heights of an exemplar as above
};

struct Method {
    std::string_view name, title, paper, limits;
    GeometryKind geometry;
    HitPlace hits;
    MapBounds map_bounds;
    std::span<const MethodParameter> parameters;  // at most 8, passed to the shader in this order
    std::uint32_t most_steps = 0;  // that a ray takes in one triangle (Layer::counts), whatever the ray
};

std::span<const Method* const> methods();  // the first is the default
// Throws std::invalid_argument that lists the known names.
const Method& find_method(std::string_view name);
// The value that a method's parameter calls `word`; nothing where no method knows it.
std::optional<double> named_value(std::string_view parameter, std::string_view word);
// The same of one method's parameter; std::invalid_argument lists the words that it knows.
double parameter_word(const Method& method, const std::string& parameter, const std::string& word);
// Every parameter, defaults filled in. std::invalid_argument on an unknown name or a value out of range.
std::map<std::string, double> resolve_parameters(const Method& method, const std::map<std::string, double>& given);

}  // namespace relievo
