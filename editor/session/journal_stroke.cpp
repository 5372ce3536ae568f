// Reads the strokes of journals.
#include <nlohmann/json.hpp>

#include "editor/session/journal_fields.h"

namespace relievo {
namespace {

using nlohmann::json;
using Fields = JournalFields;

FalloffCurve read_curve(const Fields& fields, const std::string& key) {
    const json& value = fields.at(key);
    if (!value.is_array() || value.size() < FalloffCurve::kFewest || value.size() > FalloffCurve::kMost)
        fields.fail(key, "must be an array of " + std::to_string(FalloffCurve::kFewest) + " to " +
                             std::to_string(FalloffCurve::kMost) + " points [part, weight]");
    const auto place = [&](std::size_t i) { return key + "[" + std::to_string(i) + "]"; };
    std::vector<CurvePoint> points;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const json& point = value[i];
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
            fields.fail(place(i), "must be [part, weight], two numbers");
        points.push_back({point[0].get<float>(), point[1].get<float>()});
    }
    if (const auto fault = FalloffCurve::check(points)) fields.fail(place(fault->point), fault->what);
    return FalloffCurve(points);
}

Brush read_brush(const json& value, const std::string& where) {
    std::vector<std::string_view> keys{"tool",        "falloff", "falloff_curve",
                                       "radial_axis", "paint",   "erase_to"};
    for (const BrushFlag& flag : brush_flags()) keys.push_back(flag.name);
    for (const BrushParameter& parameter : brush_parameters()) keys.push_back(parameter.name);
    const Fields fields(value, where + ": brush", keys);
    Brush brush;
    if (fields.has("tool")) {
        std::vector<std::string_view> names;
        for (const ToolInfo& tool : tools()) names.push_back(tool.name);
        brush.tool = tools()[fields.choice("tool", names)].tool;
    }
    if (fields.has("falloff"))
        brush.falloff = static_cast<Falloff>(fields.choice("falloff", falloff_names()));
    if (fields.has("falloff_curve")) brush.falloff_curve = read_curve(fields, "falloff_curve");
    if (fields.has("radial_axis"))
        brush.radial_axis = static_cast<Axis>(fields.choice("radial_axis", axis_names()));
    if (fields.has("paint")) brush.paint = static_cast<Paint>(fields.choice("paint", paint_names()));
    if (fields.has("erase_to"))
        brush.erase_to = static_cast<EraseTo>(fields.choice("erase_to", erase_to_names()));
    for (const BrushFlag& flag : brush_flags()) {
        const std::string key(flag.name);
        if (fields.has(key.c_str())) brush.*flag.value = fields.boolean(key);
    }
    for (const BrushParameter& parameter : brush_parameters()) {
        const std::string key(parameter.name);
        if (!fields.has(key.c_str())) continue;
        brush.*parameter.value = static_cast<float>(
            fields.number(key, static_cast<double>(parameter.low), static_cast<double>(parameter.high)));
    }
    return brush;
}

Dab read_dab(const json& value, const Fields& fields, const std::string& key) {
    if (!value.is_array() || (value.size() != 5 && value.size() != 6 && value.size() != 9))
        fields.fail(key,
                    "must be [time_us, face, b1, b2, pressure], then size and x, y, z of the drag or not");
    const auto whole = [&](std::size_t i, std::int64_t low, std::int64_t high) {
        return fields.integer(value[i], key + "[" + std::to_string(i) + "]", low, high);
    };
    const auto part = [&](std::size_t i, std::uint32_t high) {
        return static_cast<std::uint32_t>(whole(i, 0, std::int64_t{high}));
    };
    Dab dab;
    dab.time_us = part(0, UINT32_MAX);
    dab.face = part(1, UINT32_MAX);
    dab.b1 = part(2, Dab::kBarycentricOne);
    dab.b2 = part(3, Dab::kBarycentricOne);
    dab.pressure = part(4, Dab::kPressureOne);
    if (value.size() > 5) dab.size = static_cast<std::uint32_t>(whole(5, 1, Dab::kSizeOne));
    for (std::size_t i = 6; i < value.size(); ++i)
        dab.drag[i - 6] = static_cast<std::int32_t>(whole(i, -Dab::kLargestDrag, Dab::kLargestDrag));
    if (dab.b1 + dab.b2 > Dab::kBarycentricOne)
        fields.fail(key, "b1 + b2 is " + std::to_string(dab.b1 + dab.b2) + ", must be at most " +
                             std::to_string(Dab::kBarycentricOne));
    return dab;
}

FacePoint read_point(const json& value, const Fields& fields, const std::string& key) {
    if (!value.is_array() || value.size() != 3) fields.fail(key, "must be [face, b1, b2]");
    const auto part = [&](std::size_t i, std::uint32_t high) {
        return static_cast<std::uint32_t>(
            fields.integer(value[i], key + "[" + std::to_string(i) + "]", 0, std::int64_t{high}));
    };
    const FacePoint point{part(0, UINT32_MAX), part(1, Dab::kBarycentricOne), part(2, Dab::kBarycentricOne)};
    if (point.b1 + point.b2 > Dab::kBarycentricOne)
        fields.fail(key, "b1 + b2 must be at most " + std::to_string(Dab::kBarycentricOne));
    return point;
}

// The lists under `name`, each with one place a dab.
std::vector<std::vector<FacePoint>> read_points(const std::string& name, const Fields& fields,
                                                std::size_t dabs) {
    const json& value = fields.at(name);
    if (!value.is_array()) fields.fail(name, "is " + Fields::kind(value) + ", must be an array");
    std::vector<std::vector<FacePoint>> lists;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string key = name + "[" + std::to_string(i) + "]";
        if (!value[i].is_array() || value[i].size() != dabs)
            fields.fail(key, "must be an array of one place a dab: " + std::to_string(dabs));
        lists.emplace_back();
        for (std::size_t k = 0; k < dabs; ++k)
            lists.back().push_back(read_point(value[i][k], fields, key + "[" + std::to_string(k) + "]"));
    }
    return lists;
}

// What stamp and clone need beside dabs, and other tools must not have.
void read_extras(StrokeOp& op, const Fields& fields, const json& value, const std::string& where) {
    const auto wants = [&](const char* key, Tool tool, const char* name) {
        if (op.brush.tool == tool) return fields.at(key), true;
        if (fields.has(key))
            fields.fail(key, std::string("belongs to strokes of the ") + name + " tool alone");
        return false;
    };
    if (wants("alpha", Tool::stamp, "stamp")) {
        const Fields alpha(value["alpha"], where + ": alpha", {"file", "hash"});
        op.alpha = AlphaRef{alpha.word("file"), alpha.hash("hash")};
    }
    if (wants("sources", Tool::clone, "clone")) {
        op.sources = read_points("sources", fields, op.dabs.size());
        if (op.sources.size() != op.copies.size() + 1)
            fields.fail("sources", "has " + std::to_string(op.sources.size()) +
                                       " lists, must have one for the hand and one for each of " +
                                       std::to_string(op.copies.size()) + " copies");
    }
}

}  // namespace

StrokeOp read_stroke(const nlohmann::json& value, const std::string& where) {
    const Fields fields(value, where, {"op", "brush", "dabs", "copies", "sources", "alpha"});
    StrokeOp op{read_brush(fields.at("brush"), where), {}};
    const json& dabs = fields.at("dabs");
    if (!dabs.is_array()) fields.fail("dabs", "is " + Fields::kind(dabs) + ", must be an array");
    op.dabs.reserve(dabs.size());
    for (std::size_t i = 0; i < dabs.size(); ++i)
        op.dabs.push_back(read_dab(dabs[i], fields, "dabs[" + std::to_string(i) + "]"));
    if (fields.has("copies")) op.copies = read_points("copies", fields, op.dabs.size());
    read_extras(op, fields, value, where);
    return op;
}

}  // namespace relievo
