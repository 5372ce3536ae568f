// Reads the keys of one JSON object of a journal; whatever is wrong is named by file, line and key. Private
// to journal_*.cpp.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "editor/session/journal.h"
#include "editor/session/text.h"

namespace relievo {

// One JSON object of a line and where it stands, for messages.
class JournalFields {
  public:
    JournalFields(const nlohmann::json& object, std::string where,
                  std::initializer_list<std::string_view> known)
        : JournalFields(object, std::move(where), std::span(known.begin(), known.size())) {}
    JournalFields(const nlohmann::json& object, std::string where, std::span<const std::string_view> known)
        : object_(object), where_(std::move(where)) {
        if (!object.is_object()) fail("", "is " + kind(object) + ", must be an object");
        for (const auto& item : object.items()) {
            bool found = false;
            for (std::string_view key : known) found = found || key == item.key();
            if (!found) fail(item.key(), "is not a key here; known are " + joined(known));
        }
    }

    bool has(const char* key) const { return object_.contains(key); }

    const nlohmann::json& at(const std::string& key) const {
        const auto found = object_.find(key);
        if (found == object_.end()) fail(key, "is missing");
        return *found;
    }

    double number(const std::string& key, double low, double high) const {
        const nlohmann::json& value = at(key);
        if (!value.is_number()) fail(key, "is " + kind(value) + ", must be a number");
        const double result = value.get<double>();
        // Compared as float too: a float's bound (0.02f) may read back a little below the double's.
        if (!std::isfinite(result) || ((result < low || result > high) && !float_within(result, low, high)))
            fail(key, "is " + value.dump() + ", must be " + range_text(low, high));
        return result;
    }

    std::int64_t integer(const nlohmann::json& value, const std::string& key, std::int64_t low,
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
        const nlohmann::json& value = at(key);
        if (!value.is_boolean()) fail(key, "is " + kind(value) + ", must be true or false");
        return value.get<bool>();
    }

    std::string word(const std::string& key) const {
        const nlohmann::json& value = at(key);
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

    static std::string kind(const nlohmann::json& value) {
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

    const nlohmann::json& object_;
    std::string where_;
};

// A line's stroke. `where`: file and line, for messages.
StrokeOp read_stroke(const nlohmann::json& value, const std::string& where);

}  // namespace relievo
