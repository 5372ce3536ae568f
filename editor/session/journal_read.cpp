// Reads and checks journals (strokes: journal_stroke.cpp). Whatever is wrong is named by file, line and key.
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "brushes/height_map.h"
#include "editor/session/journal.h"
#include "editor/session/journal_fields.h"

namespace relievo {
namespace {

using nlohmann::json;
using Fields = JournalFields;

constexpr int kMaxImage = 16384;  // pixels a side
constexpr int kMaxSpp = 1 << 20;  // samples a pixel
constexpr double kMaxReal = 1e30;

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
        const Fields fields(value, where, {"op", "path", "map", "colour_map", "colour", "mask"});
        SaveOp op{fields.word("path"), std::nullopt};
        if (fields.has("map")) op.map = fields.hash("map");
        if (fields.has("colour_map")) op.colour_map = fields.word("colour_map");
        if (fields.has("colour")) op.colour = fields.hash("colour");
        if (fields.has("mask")) op.mask = fields.hash("mask");
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
                         "midlevel", "amplitude", "undo_budget", "colour_map", "colour_hash", "mask", "mask_hash"});
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
    if (fields.has("mask")) header.mask = fields.word("mask");
    if (fields.has("mask_hash")) header.mask_hash = fields.hash("mask_hash");
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
