// The schema says what the loader does: the same keys, and the same verdict on every document of the table.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "renderer/scene/scene_keys.h"
#include "tests/scene/scene_documents.h"
#include "tests/scene/test_files.h"

namespace relievo::scene_schema_test {
namespace {

using nlohmann::json;

// The part of JSON Schema 2020-12 that scene.schema.json uses; a keyword beyond it is a test failure.
class SchemaChecker {
  public:
    explicit SchemaChecker(const json& schema) : root_(schema) {}
    bool accepts(const json& value) const { return accepts(root_, value); }

  private:
    bool accepts(const json& schema, const json& value) const {
        for (const auto& [keyword, rule] : schema.items()) {
            if (!obeys(schema, keyword, rule, value)) return false;
        }
        return true;
    }

    bool obeys(const json& schema, const std::string& keyword, const json& rule, const json& value) const {
        if (keyword == "$ref")
            return accepts(root_.at(json::json_pointer(rule.get<std::string>().substr(1))), value);
        if (keyword == "anyOf") {
            return std::any_of(rule.begin(), rule.end(), [&](const json& s) { return accepts(s, value); });
        }
        if (keyword == "not") return !accepts(rule, value);
        if (keyword == "const") return value == rule;
        if (keyword == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
        if (keyword == "type") {
            if (rule.is_string()) return has_type(rule.get<std::string>(), value);
            return std::any_of(rule.begin(), rule.end(), [&](const json& t) { return has_type(t, value); });
        }
        if (value.is_object()) return obeys_object(schema, keyword, rule, value);
        if (value.is_array()) {
            if (keyword == "minItems") return value.size() >= rule.get<std::size_t>();
            if (keyword == "maxItems") return value.size() <= rule.get<std::size_t>();
            if (keyword == "items") {
                return std::all_of(value.begin(), value.end(),
                                   [&](const json& v) { return accepts(rule, v); });
            }
        }
        if (value.is_string() && keyword == "minLength")
            return value.get<std::string>().size() >= rule.get<std::size_t>();
        if (value.is_number()) {
            if (keyword == "minimum") return value.get<double>() >= rule.get<double>();
            if (keyword == "maximum") return value.get<double>() <= rule.get<double>();
            if (keyword == "exclusiveMinimum") return value.get<double>() > rule.get<double>();
            if (keyword == "exclusiveMaximum") return value.get<double>() < rule.get<double>();
        }
        EXPECT_TRUE(kKnown.contains(keyword)) << "the checker does not know " << keyword;
        return true;
    }

    bool obeys_object(const json& schema, const std::string& keyword, const json& rule,
                      const json& value) const {
        if (keyword == "required") {
            return std::all_of(rule.begin(), rule.end(),
                               [&](const json& key) { return value.contains(key.get<std::string>()); });
        }
        for (const auto& [key, member] : value.items()) {
            const bool listed = schema.contains("properties") && schema["properties"].contains(key);
            if (keyword == "properties" && listed && !accepts(rule[key], member)) return false;
            if (keyword == "additionalProperties" && !listed) {
                if (rule.is_boolean() ? !rule.get<bool>() : !accepts(rule, member)) return false;
            }
        }
        return true;
    }

    static bool has_type(const std::string& type, const json& value) {
        if (type == "integer")
            return value.is_number() && value.get<double>() == std::floor(value.get<double>());
        if (type == "number") return value.is_number();
        if (type == "boolean") return value.is_boolean();
        if (type == "string") return value.is_string();
        if (type == "array") return value.is_array();
        return type == "object" && value.is_object();
    }

    const json& root_;
    const std::set<std::string> kKnown = {"$schema",
                                          "$defs",
                                          "title",
                                          "description",
                                          "properties",
                                          "required",
                                          "additionalProperties",
                                          "items",
                                          "minItems",
                                          "maxItems",
                                          "minLength",
                                          "minimum",
                                          "maximum",
                                          "exclusiveMinimum",
                                          "exclusiveMaximum"};
};

json schema() {
    std::ifstream in(RELIEVO_SCENE_SCHEMA);
    return json::parse(in);
}

TEST(SceneSchema, judges_every_document_as_the_loader_does) {
    const json document = schema();
    const SchemaChecker checker(document);
    for (const SceneDocument& scene : kSceneDocuments) {
        EXPECT_EQ(checker.accepts(json::parse(whole_document(scene.json))), scene.verdict != Verdict::bad)
            << scene.json;
    }
}

TEST(SceneSchema, lists_the_keys_of_the_loader) {
    const json document = schema();
    const std::pair<const char*, const char*> places[] = {
        {"", "/properties"},
        {"objects[]", "/$defs/object/properties"},
        {"objects[].displacement", "/$defs/displacement/properties"},
        {"objects[].displacement.procedural", "/$defs/procedural/properties"},
        {"objects[].material", "/$defs/material/properties"},
        {"objects[].transform", "/$defs/transform/anyOf/1/properties"},
        {"camera", "/$defs/camera/properties"},
        {"image", "/$defs/image/properties"},
        {"lights[] sun", "/$defs/sun/properties"},
        {"lights[] point", "/$defs/point/properties"},
        {"environment", "/$defs/environment/properties"},
    };
    EXPECT_EQ(std::size(places), all_scene_keys().size());
    for (const auto& [where, pointer] : places) {
        std::set<std::string> in_schema;
        for (const auto& item : document.at(json::json_pointer(pointer)).items())
            in_schema.insert(item.key());
        const auto keys = scene_keys(where);
        EXPECT_EQ(in_schema, std::set<std::string>(keys.begin(), keys.end())) << where;
    }
}

}  // namespace
}  // namespace relievo::scene_schema_test
