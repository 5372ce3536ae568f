// Writes journal lines. By hand rather than through a JSON tree: floats must come out in their shortest form
// that reads back to the same bits, which a tree of doubles cannot know.
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "editor/session/journal.h"

namespace relievo {
namespace {

std::string quoted(const std::string& text) {
    try {
        return nlohmann::json(text).dump();
    } catch (const nlohmann::json::exception&) {
        throw std::invalid_argument("a name in the journal is not UTF-8: rename the file or folder");
    }
}

std::string quoted(const std::filesystem::path& path) {
    return quoted(path.generic_string());
}

template <typename Number>
std::string shortest(Number value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

std::string number(double value) {
    if (!std::isfinite(value)) throw std::invalid_argument("a number in the journal must be finite");
    return shortest(value);
}

// Readers parse a double and round it to float; where that second rounding would miss, the double's digits
// are written instead of the float's.
std::string number(float value) {
    const std::string text = shortest(value);
    double parsed = 0;
    std::from_chars(text.data(), text.data() + text.size(), parsed);
    return static_cast<float>(parsed) == value ? text : number(static_cast<double>(value));
}

// The settings of the first brushes are always written; later ones where they differ from the standard, so
// that lines stay short and older programs read what they can do.
constexpr std::size_t kAlwaysWritten = 5;

std::string curve_array(const FalloffCurve& curve) {
    std::string text(1, '[');
    for (const CurvePoint& point : curve.points())
        text.append(text.size() > 1 ? ",[" : "[")
            .append(number(point.part))
            .append(",")
            .append(number(point.weight))
            .append("]");
    return text.append("]");
}

std::string brush_object(const Brush& brush) {
    std::string text = "{\"tool\":\"";
    for (const ToolInfo& tool : tools())
        if (tool.tool == brush.tool) text += tool.name;
    text += "\",\"falloff\":\"";
    text += falloff_names()[static_cast<std::size_t>(brush.falloff)];
    text += "\"";
    const Brush standard;
    for (const BrushFlag& flag : brush_flags())
        if (flag.name == "invert" || brush.*flag.value != standard.*flag.value)
            text.append(",\"").append(flag.name).append(brush.*flag.value ? "\":true" : "\":false");
    for (std::size_t i = 0; i < brush_parameters().size(); ++i) {
        const BrushParameter& parameter = brush_parameters()[i];
        if (i >= kAlwaysWritten && brush.*parameter.value == standard.*parameter.value) continue;
        text.append(",\"").append(parameter.name).append("\":").append(number(brush.*parameter.value));
    }
    const auto choice = [&](const char* key, auto value, auto usual,
                            std::span<const std::string_view> names) {
        if (value == usual) return;
        text.append(",\"")
            .append(key)
            .append("\":\"")
            .append(names[static_cast<std::size_t>(value)])
            .append("\"");
    };
    choice("radial_axis", brush.radial_axis, standard.radial_axis, axis_names());
    choice("paint", brush.paint, standard.paint, paint_names());
    choice("erase_to", brush.erase_to, standard.erase_to, erase_to_names());
    if (brush.falloff_curve != standard.falloff_curve)
        text.append(",\"falloff_curve\":").append(curve_array(brush.falloff_curve));
    return text + "}";
}

std::string dab_array(const Dab& dab) {
    std::string text(1, '[');
    for (std::uint32_t part : {dab.time_us, dab.face, dab.b1, dab.b2, dab.pressure})
        text.append(text.size() > 1 ? "," : "").append(shortest(part));
    const bool dragged = dab.drag != decltype(dab.drag){};
    if (dragged || dab.size != Dab::kSizeOne) text.append(",").append(shortest(dab.size));
    if (dragged)
        for (const std::int32_t part : dab.drag) text.append(",").append(shortest(part));
    return text.append("]");
}

std::string points_array(const std::vector<std::vector<FacePoint>>& lists) {
    std::string text(1, '[');
    for (const std::vector<FacePoint>& list : lists) {
        text.append(text.size() > 1 ? ",[" : "[");
        for (std::size_t i = 0; i < list.size(); ++i)
            text.append(i > 0 ? ",[" : "[")
                .append(shortest(list[i].face))
                .append(",")
                .append(shortest(list[i].b1))
                .append(",")
                .append(shortest(list[i].b2))
                .append("]");
        text.append("]");
    }
    return text.append("]");
}

std::string render_options(const std::optional<int>& spp, const std::optional<ImageSize>& size) {
    std::string text;
    if (spp) text += ",\"spp\":" + shortest(*spp);
    if (size) text += ",\"size\":[" + shortest(size->width) + "," + shortest(size->height) + "]";
    return text;
}

struct Formatter {
    std::string operator()(const StrokeOp& op) const {
        std::string text = R"({"op":"stroke","brush":)" + brush_object(op.brush) + ",\"dabs\":[";
        for (std::size_t i = 0; i < op.dabs.size(); ++i) {
            if (i > 0) text += ",";
            text += dab_array(op.dabs[i]);
        }
        text += "]";
        if (!op.copies.empty()) text += ",\"copies\":" + points_array(op.copies);
        if (!op.sources.empty()) text += ",\"sources\":" + points_array(op.sources);
        if (op.alpha)
            text += ",\"alpha\":{\"file\":" + quoted(op.alpha->file) + ",\"hash\":\"" +
                    hash_text(op.alpha->hash) + "\"}";
        return text + "}";
    }
    std::string operator()(const UndoOp&) const { return R"({"op":"undo"})"; }
    std::string operator()(const RedoOp&) const { return R"({"op":"redo"})"; }
    std::string operator()(const MaskOp& op) const {
        return std::string(R"({"op":"mask","do":")")
            .append(mask_commands()[static_cast<std::size_t>(op.command)])
            .append("\"}");
    }
    std::string operator()(const SetOp& op) const {
        std::string text = R"({"op":"set","key":)" + quoted(op.key) + ",\"value\":";
        if (const auto* value = std::get_if<double>(&op.value)) {
            text += number(*value);
        } else if (const auto* word = std::get_if<std::string>(&op.value)) {
            text += quoted(*word);
        } else {
            const auto& vector = std::get<std::vector<double>>(op.value);
            text += "[";
            for (std::size_t i = 0; i < vector.size(); ++i)
                text.append(i > 0 ? "," : "").append(number(vector[i]));
            text += "]";
        }
        return text + "}";
    }
    std::string operator()(const BakeOp& op) const {
        return R"({"op":"bake","size":[)" + shortest(op.size.width) + "," + shortest(op.size.height) + "]}";
    }
    std::string operator()(const ExpectOp& op) const {
        std::string text = R"({"op":"expect","map":")" + hash_text(op.map) + "\"";
        if (op.mask) text += ",\"mask\":\"" + hash_text(*op.mask) + "\"";
        if (op.colour) text += ",\"colour\":\"" + hash_text(*op.colour) + "\"";
        return text + "}";
    }
    std::string operator()(const ExpectImageOp& op) const {
        return R"({"op":"expect_image","image":)" + quoted(op.image) +
               ",\"tolerance\":" + number(op.tolerance) + render_options(op.spp, op.size) + "}";
    }
    std::string operator()(const RenderOp& op) const {
        return R"({"op":"render","out":)" + quoted(op.out) + render_options(op.spp, op.size) + "}";
    }
    std::string operator()(const SaveOp& op) const {
        std::string text = R"({"op":"save","path":)" + quoted(op.path);
        if (op.map) text += ",\"map\":\"" + hash_text(*op.map) + "\"";
        if (!op.colour_map.empty()) text += ",\"colour_map\":" + quoted(op.colour_map);
        if (op.colour) text += ",\"colour\":\"" + hash_text(*op.colour) + "\"";
        if (op.mask) text += ",\"mask\":\"" + hash_text(*op.mask) + "\"";
        return text + "}";
    }
    std::string operator()(const ColourMapOp& op) const {
        return R"({"op":"colour_map","bits":)" + shortest(op.bits) + "}";
    }
};

}  // namespace

std::span<const std::string_view> mask_commands() {
    static constexpr std::array<std::string_view, 3> kNames{"clear", "invert", "blur"};
    return kNames;
}

std::string hash_text(std::uint64_t hash) {
    char text[16];
    const auto end = std::to_chars(text, text + sizeof text, hash, 16).ptr;
    const std::string digits(text, end);
    return std::string(16 - digits.size(), '0') + digits;
}

std::string format_header(const JournalHeader& header) {
    std::string text = R"({"relievo_journal":1)";
    if (!header.version.empty()) text += ",\"version\":" + quoted(header.version);
    if (!header.scene.empty()) text += ",\"scene\":" + quoted(header.scene);
    if (header.mesh_hash) text += ",\"mesh_hash\":\"" + hash_text(*header.mesh_hash) + "\"";
    if (header.map_hash) text += ",\"map_hash\":\"" + hash_text(*header.map_hash) + "\"";
    if (header.map_width && header.map_height)
        text += ",\"map_size\":[" + shortest(*header.map_width) + "," + shortest(*header.map_height) + "]";
    if (header.midlevel) text += ",\"midlevel\":" + number(*header.midlevel);
    if (header.amplitude) text += ",\"amplitude\":" + number(*header.amplitude);
    if (header.undo_budget) text += ",\"undo_budget\":" + shortest(*header.undo_budget);
    if (!header.colour_map.empty()) text += ",\"colour_map\":" + quoted(header.colour_map);
    if (header.colour_hash) text += ",\"colour_hash\":\"" + hash_text(*header.colour_hash) + "\"";
    if (!header.mask.empty()) text += ",\"mask\":" + quoted(header.mask);
    if (header.mask_hash) text += ",\"mask_hash\":\"" + hash_text(*header.mask_hash) + "\"";
    return text + "}";
}

std::string format_op(const JournalOp& op) {
    return std::visit(Formatter{}, op);
}

}  // namespace relievo
