// Reads and checks journals. Whatever is wrong is named by file, line and key.
#include <charconv>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string_view>

#include "brushes/height_map.h"
#include "editor/session/journal.h"
#include "editor/session/text.h"

namespace relievo {
namespace {

using nlohmann::json;

// One JSON object of a line and where it stands, for messages.
class Fields {
  public:
    Fields(const json& object, std::string where, std::initializer_list<std::string_view> known)
        : Fields(object, std::move(where), std::span(known.begin(), known.size())) {}
    Fields(const json& object, std::string where, std::span<const std::string_view> known)
        : object_(object), where_(std::move(where)) {
        if (!object.is_object()) fail("", "is " + kind(object) + ", must be an object");
        for (const auto& item : object.items()) {
            bool found = false;
            for (std::string_view key : known) found = found || key == item.key();
            if (!found) fail(item.key(), "is not a key here; known are " + joined(known));
        }
    }

    bool has(const char* key) const { return object_.contains(key); }

    const json& at(const std::string& key) const {
        const auto found = object_.find(key);
        if (found == object_.end()) fail(key, "is missing");
        return *found;
    }

    double number(const std::string& key, double low, double high) const {
        const json& value = at(key);
        if (!value.is_number()) fail(key, "is " + kind(value) + ", must be a number");
        const double result = value.get<double>();
        // Compared as float too: a float's bound (0.02f) may read back a little below the double's.
        if (!std::isfinite(result) || ((result < low || result > high) && !float_within(result, low, high)))
            fail(key, "is " + value.dump() + ", must be " + range_text(low, high));
        return result;
    }

    std::int64_t integer(const json& value, const std::string& key, std::int64_t low,
                         std::int64_t high) const {
        if (!value.is_number_integer()) fail(key, "is " + kind(value) + ", must be a whole number");
        const bool too_large =
            value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t{INT64_MAX};
        const std::int64_t result = too_large ? INT64_MAX : value.get<std::int64_t>();
        if (too_large || result < low || result > high)
            fail(key, "is " + value.dump() + ", must be " +
                          range_text(static_cast<double>(low), static_cast<double>(high)));
        return result;
    }

    bool boolean(const std::string& key) const {
        const json& value = at(key);
        if (!value.is_boolean()) fail(key, "is " + kind(value) + ", must be true or false");
        return value.get<bool>();
    }

    std::string word(const std::string& key) const {
        const json& value = at(key);
        if (!value.is_string()) fail(key, "is " + kind(value) + ", must be a string");
        if (value.get_ref<const std::string&>().empty()) fail(key, "is empty");
        return value.get<std::string>();
    }

    // The place of a word among `words`.
    std::size_t choice(const std::string& key, std::span<const std::string_view> words) const {
        const std::string given = word(key);
        for (std::size_t i = 0; i < words.size(); ++i)
            if (words[i] == given) return i;
        fail(key, "is \"" + given + "\", must be one of " + joined(words));
    }

    std::uint64_t hash(const std::string& key) const {
        const std::string text = word(key);
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
        if (error != std::errc{} || end != text.data() + text.size() || text.size() > 16)
            fail(key, "is \"" + text + "\", must be up to 16 hexadecimal digits");
        return value;
    }

    std::optional<ImageSize> size(const std::string& key, int limit) const {
        const auto found = object_.find(key);
        if (found == object_.end()) return std::nullopt;
        if (!found->is_array() || found->size() != 2) fail(key, "must be [width, height]");
        return ImageSize{static_cast<int>(integer((*found)[0], key + "[0]", 1, limit)),
                         static_cast<int>(integer((*found)[1], key + "[1]", 1, limit))};
    }

    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        throw std::invalid_argument(where_ + (key.empty() ? "" : ": " + key) + ": " + what);
    }

    static std::string kind(const json& value) {
        const std::string name = value.type_name();
        return name == "null" ? name : (name == "array" || name == "object" ? "an " : "a ") + name;
    }

  private:
    static bool float_within(double value, double low, double high) {
        return static_cast<float>(value) >= static_cast<float>(low) &&
               static_cast<float>(value) <= static_cast<float>(high);
    }
    static std::string joined(std::span<const std::string_view> words) {
        std::string text;
        for (std::string_view word : words) text.append(text.empty() ? "" : ", ").append(word);
        return text;
    }

    const json& object_;
    std::string where_;
};

constexpr int kMaxImage = 16384;  // pixels a side
constexpr int kMaxSpp = 1 << 20;  // samples a pixel
constexpr double kMaxReal = 1e30;

Brush read_brush(const json& value, const std::string& where) {
    std::vector<std::string_view> keys{"tool", "falloff", "radial_axis", "paint", "erase_to"};
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

StrokeOp read_stroke(const json& value, const std::string& where) {
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

SetOp read_set(const json& value, const std::string& where) {
    const Fields fields(value, where, {"op", "key", "value"});
    const json& given = fields.at("value");
    const std::string key = fields.word("key");
    if (given.is_string()) return {key, given.get<std::string>()};
    if (given.is_boolean()) return {key, given.get<bool>() ? 1.0 : 0.0};
    if (given.is_number()) return {key, fields.number("value", -kMaxReal, kMaxReal)};
    if (!given.is_array())
        fields.fail("value", "is " + Fields::kind(given) + ", must be a number, string or array");
    std::vector<double> numbers;
    for (const json& item : given) {
        if (!item.is_number()) fields.fail("value", "holds " + Fields::kind(item) + ", must hold numbers");
        numbers.push_back(item.get<double>());
    }
    return {key, numbers};
}

std::optional<int> read_spp(const Fields& fields) {
    if (!fields.has("spp")) return std::nullopt;
    return static_cast<int>(fields.integer(fields.at("spp"), "spp", 1, kMaxSpp));
}

JournalOp read_op(const json& value, const std::string& where) {
    if (!value.is_object() || !value.contains("op") || !value["op"].is_string())
        throw std::invalid_argument(where + ": op: must be a string: the operation's name");
    const std::string name = value["op"].get<std::string>();
    if (name == "stroke") return read_stroke(value, where);
    if (name == "undo") return Fields(value, where, {"op"}), UndoOp{};
    if (name == "redo") return Fields(value, where, {"op"}), RedoOp{};
    if (name == "mask") {
        const Fields fields(value, where, {"op", "do"});
        return MaskOp{static_cast<MaskCommand>(fields.choice("do", mask_commands()))};
    }
    if (name == "set") return read_set(value, where);
    if (name == "bake") {
        const Fields fields(value, where, {"op", "size"});
        fields.at("size");
        return BakeOp{*fields.size("size", HeightMap::kMaxSize)};
    }
    if (name == "expect") {
        const Fields fields(value, where, {"op", "map", "mask", "colour"});
        ExpectOp op{fields.hash("map")};
        if (fields.has("mask")) op.mask = fields.hash("mask");
        if (fields.has("colour")) op.colour = fields.hash("colour");
        return op;
    }
    if (name == "expect_image") {
        const Fields fields(value, where, {"op", "image", "tolerance", "spp", "size"});
        return ExpectImageOp{fields.word("image"), fields.number("tolerance", 0, 1), read_spp(fields),
                             fields.size("size", kMaxImage)};
    }
    if (name == "render") {
        const Fields fields(value, where, {"op", "out", "spp", "size"});
        return RenderOp{fields.word("out"), read_spp(fields), fields.size("size", kMaxImage)};
    }
    if (name == "save") {
        const Fields fields(value, where, {"op", "path", "map", "colour_map", "colour"});
        SaveOp op{fields.word("path"), std::nullopt};
        if (fields.has("map")) op.map = fields.hash("map");
        if (fields.has("colour_map")) op.colour_map = fields.word("colour_map");
        if (fields.has("colour")) op.colour = fields.hash("colour");
        return op;
    }
    if (name == "colour_map") {
        const Fields fields(value, where, {"op", "bits"});
        const std::int64_t bits = fields.integer(fields.at("bits"), "bits", 8, 16);
        if (bits != 8 && bits != 16) fields.fail("bits", "is " + std::to_string(bits) + ", must be 8 or 16");
        return ColourMapOp{static_cast<int>(bits)};
    }
    throw std::invalid_argument(
        where + ": op: is \"" + name +
        "\", must be one of stroke, undo, redo, mask, set, bake, expect, expect_image, render, save, "
        "colour_map");
}

JournalHeader read_header(const json& value, const std::string& where) {
    if (!value.is_object() || !value.contains("relievo_journal"))
        throw std::invalid_argument(where +
                                    R"(: not a journal: the first line must be {"relievo_journal":1,...})");
    const Fields fields(value, where,
                        {"relievo_journal", "version", "scene", "mesh_hash", "map_hash", "map_size",
                         "midlevel", "amplitude", "undo_budget", "colour_map", "colour_hash"});
    if (fields.at("relievo_journal") != 1)
        fields.fail("relievo_journal", "is " + value["relievo_journal"].dump() + ", this program reads 1");
    JournalHeader header;
    if (fields.has("version")) header.version = fields.word("version");
    if (fields.has("scene")) header.scene = fields.word("scene");
    if (fields.has("mesh_hash")) header.mesh_hash = fields.hash("mesh_hash");
    if (fields.has("map_hash")) header.map_hash = fields.hash("map_hash");
    if (const auto size = fields.size("map_size", 16384)) {
        header.map_width = size->width;
        header.map_height = size->height;
    }
    if (fields.has("midlevel")) header.midlevel = fields.number("midlevel", 0, 1);
    if (fields.has("amplitude")) header.amplitude = fields.number("amplitude", -kMaxReal, kMaxReal);
    if (fields.has("undo_budget"))
        header.undo_budget =
            static_cast<std::uint64_t>(fields.integer(fields.at("undo_budget"), "undo_budget", 0, INT64_MAX));
    if (fields.has("colour_map")) header.colour_map = fields.word("colour_map");
    if (fields.has("colour_hash")) header.colour_hash = fields.hash("colour_hash");
    return header;
}

// The parser's own message carries an error number and a byte offset; keep only what a person can use.
std::string syntax_message(const json::parse_error& error) {
    const std::string text = error.what();
    const auto at = text.find(": ");
    return "column " + std::to_string(error.byte) + ": not JSON" +
           (at == std::string::npos ? "" : " (" + text.substr(at + 2) + ")");
}

}  // namespace

std::filesystem::path Journal::resolve(const std::filesystem::path& written) const {
    return (std::filesystem::absolute(path).parent_path() / written).lexically_normal();
}

Journal read_journal(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw std::invalid_argument(path.string() + ": is a folder, must be a journal file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::invalid_argument(path.string() + ": no such journal, or it cannot be read");
    Journal journal{path, {}, {}, {}};
    std::string text;
    bool have_header = false;
    for (int line = 1; std::getline(file, text); ++line) {
        const bool last_is_cut = file.eof();  // no newline at its end
        const std::string where = path.string() + ":" + std::to_string(line);
        if (!text.empty() && text.back() == '\r') text.pop_back();
        // A power failure can leave a tail of zeros where the last line should be.
        const bool lost = !text.empty() && text.front() == '\0';
        if (text.find_first_not_of(" \t") == std::string::npos) continue;
        json value;
        try {
            value = json::parse(text);
        } catch (const json::parse_error& error) {
            if (!have_header || !(last_is_cut || lost))
                throw std::invalid_argument(where + ": " + syntax_message(error));
            journal.warnings.push_back(where + ": the last line was cut off and is left out");
            break;
        }
        if (have_header) {
            journal.entries.push_back({line, read_op(value, where)});
        } else {
            journal.header = read_header(value, where);
            have_header = true;
        }
    }
    if (!have_header)
        throw std::invalid_argument(path.string() + ": is empty, must begin with a journal's header");
    return journal;
}

}  // namespace relievo
