// JSON with paths in its errors, over nlohmann::json: see the header.
#include "renderer/scene/json_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "renderer/scene/scene_keys.h"
#include "renderer/scene/text_scan.h"

namespace relievo {

namespace {

// The shortest text that reads back as the same number.
std::string short_number(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string range_text(const NumberRange& range) {
    const bool has_low = range.low > -std::numeric_limits<double>::max();
    const bool has_high = range.high < std::numeric_limits<double>::max();
    if (has_low && has_high) {
        return "must be in " + std::string(range.open ? "(" : "[") + short_number(range.low) + ", " +
               short_number(range.high) + (range.open ? ")" : "]");
    }
    if (has_low)
        return (range.open ? "must be greater than " : "must be at least ") + short_number(range.low);
    return (range.open ? "must be less than " : "must be at most ") + short_number(range.high);
}

// nlohmann keeps the last of two equal keys in silence; this refuses them.
class DuplicateKeys {
  public:
    bool operator()(int, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
        using Event = nlohmann::json::parse_event_t;
        if (event == Event::object_start) open_.emplace_back();
        if (event == Event::object_end) open_.pop_back();
        if (event == Event::key && !open_.back().insert(parsed.get<std::string>()).second) {
            throw std::invalid_argument("the key " + in_quotes(parsed.get<std::string>()) +
                                        " is given twice");
        }
        return true;
    }

  private:
    std::vector<std::set<std::string>> open_;
};

// "[json.exception.parse_error.101] parse error at line 3, column 5: ..." without its first part.
std::string readable(std::string message) {
    if (const std::size_t end = message.find("] "); end != std::string::npos) message.erase(0, end + 2);
    constexpr std::string_view kPrefix = "parse error at ";
    if (message.starts_with(kPrefix)) message.erase(0, kPrefix.size());
    return message;
}

}  // namespace

void JsonNode::fail(const std::string& what) const {
    throw std::invalid_argument(*file_ + ": " + (path_.empty() ? "" : path_ + ": ") + what);
}

std::string JsonNode::kind() const {
    switch (value_->type()) {
        case nlohmann::json::value_t::null:
            return "null";
        case nlohmann::json::value_t::object:
            return "an object";
        case nlohmann::json::value_t::array:
            return "an array";
        case nlohmann::json::value_t::string:
            return "a string";
        case nlohmann::json::value_t::boolean:
            return "true or false";
        default:
            return "a number";
    }
}

void JsonNode::require_keys(std::span<const std::string_view> known) const {
    for (const std::string& key : keys()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw std::invalid_argument(*file_ + ": " + (path_.empty() ? key : path_ + "." + key) + ": " +
                                    unknown_key_message(key, known));
    }
}

bool JsonNode::has(std::string_view key) const {
    return value_->contains(key);
}

JsonNode JsonNode::operator[](std::string_view key) const {
    const auto found = value_->find(key);
    if (found == value_->end()) fail("the key '" + std::string(key) + "' is missing");
    return {*found, *file_, (path_.empty() ? "" : path_ + ".") + std::string(key)};
}

std::vector<std::string> JsonNode::keys() const {
    if (!value_->is_object()) fail("is " + kind() + ", must be an object");
    std::vector<std::string> names;
    for (const auto& item : value_->items()) names.push_back(item.key());
    return names;
}

std::size_t JsonNode::length(std::size_t least, std::size_t most) const {
    if (!value_->is_array()) fail("is " + kind() + ", must be an array");
    const std::size_t n = value_->size();
    if (n >= least && n <= most) return n;
    fail("has " + std::to_string(n) + " items, must have " +
         (n < least ? (least == most ? "" : "at least ") + std::to_string(least)
                    : (least == most ? "" : "at most ") + std::to_string(most)));
}

JsonNode JsonNode::operator[](std::size_t index) const {
    return {(*value_)[index], *file_, path_ + "[" + std::to_string(index) + "]"};
}

bool JsonNode::is_object() const {
    return value_->is_object();
}
bool JsonNode::is_array() const {
    return value_->is_array();
}
bool JsonNode::is_boolean() const {
    return value_->is_boolean();
}

bool JsonNode::is_text() const {
    return value_->is_string();
}

double JsonNode::number(const NumberRange& range) const {
    if (!value_->is_number()) fail("is " + kind() + ", must be a number");
    const double value = value_->get<double>();
    const bool inside =
        range.open ? value > range.low && value < range.high : value >= range.low && value <= range.high;
    if (!inside) fail("is " + short_number(value) + ", " + range_text(range));
    return value;
}

int JsonNode::integer(int low, int high) const {
    const double value = number();
    const NumberRange range{static_cast<double>(low), static_cast<double>(high)};
    if (value != std::floor(value)) fail("is " + short_number(value) + ", must be a whole number");
    return static_cast<int>(number(range));
}

bool JsonNode::boolean() const {
    if (!value_->is_boolean()) fail("is " + kind() + ", must be true or false");
    return value_->get<bool>();
}

std::string JsonNode::text() const {
    if (!value_->is_string()) fail("is " + kind() + ", must be a string");
    std::string text = value_->get<std::string>();
    if (text.empty()) fail("is an empty string");
    return text;
}

glm::dvec3 JsonNode::vector3(const NumberRange& range) const {
    length(3, 3);
    return {(*this)[0].number(range), (*this)[1].number(range), (*this)[2].number(range)};
}

std::size_t JsonNode::one_of(std::span<const std::string_view> words) const {
    const std::string given = text();
    const auto found = std::find(words.begin(), words.end(), given);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string list;
    for (const std::string_view word : words)
        list += (list.empty() ? "'" : " or '") + std::string(word) + "'";
    fail("is " + in_quotes(given) + ", must be " + list);
}

JsonDocument::JsonDocument(const std::filesystem::path& path)
    : file_(path.string()), json_(std::make_unique<nlohmann::json>()) {
    const std::string text = read_file(path);
    try {
        *json_ = nlohmann::json::parse(text, DuplicateKeys());
    } catch (const nlohmann::json::exception& e) {
        throw std::invalid_argument(file_ + ": " + readable(e.what()));
    } catch (const std::invalid_argument& e) {
        throw std::invalid_argument(file_ + ": " + e.what());
    }
}

JsonDocument::~JsonDocument() = default;

JsonNode JsonDocument::root() const {
    return {*json_, file_, ""};
}

}  // namespace relievo
