// A JSON document whose every error names the file and the path of the value, for example
// `scene.json: objects[0].mesh: is a number, must be a string`.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

struct NumberRange {
    double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();
    bool open = false;  // the ends do not belong to it
};

// A value inside a document that outlives it. The readers throw std::invalid_argument when the value is not
// what they return, or outside the range.
class JsonNode {
  public:
    JsonNode(const nlohmann::json& value, const std::string& file, std::string path)
        : value_(&value), file_(&file), path_(std::move(path)) {}

    [[noreturn]] void fail(const std::string& what) const;

    // Objects.
    void require_keys(std::span<const std::string_view> known) const;  // an object without other keys
    bool has(std::string_view key) const;
    JsonNode operator[](std::string_view key) const;  // fails when it is missing
    std::vector<std::string> keys() const;

    // Arrays: their length, at least `least` and at most `most`.
    std::size_t length(std::size_t least, std::size_t most) const;
    JsonNode operator[](std::size_t index) const;

    bool is_object() const;
    bool is_array() const;
    bool is_boolean() const;
    bool is_text() const;

    double number(const NumberRange& range = {}) const;
    int integer(int low, int high) const;
    bool boolean() const;
    std::string text() const;  // not empty
    glm::dvec3 vector3(const NumberRange& range = {}) const;
    // The index of the text in `words`.
    std::size_t one_of(std::span<const std::string_view> words) const;

  private:
    std::string kind() const;
    const nlohmann::json* value_;
    const std::string* file_;
    std::string path_;
};

class JsonDocument {
  public:
    // Throws std::invalid_argument: the file is missing or unreadable, a syntax error (with line and column),
    // a key given twice.
    explicit JsonDocument(const std::filesystem::path& path);
    ~JsonDocument();
    JsonNode root() const;

  private:
    std::string file_;
    std::unique_ptr<nlohmann::json> json_;
};

}  // namespace relievo
