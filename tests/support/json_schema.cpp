#include <tests/support/json_schema.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace scree::test {

namespace {

using nlohmann::json;

bool is_type(const json& value, const std::string& type) {
    if (type == "integer") {
        return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
    }
    return type == "object"    ? value.is_object()
           : type == "array"   ? value.is_array()
           : type == "string"  ? value.is_string()
           : type == "boolean" ? value.is_boolean()
           : type == "number"  ? value.is_number()
                               : throw std::invalid_argument("type " + type);
}

const std::set<std::string> notes = {"$schema", "title", "description",         "definitions",
                                     "then",    "else",  "additionalProperties"};

bool any(const auto& list, const auto& test) {
    return std::any_of(list.begin(), list.end(), test);
}

bool all(const auto& list, const auto& test) {
    return std::all_of(list.begin(), list.end(), test);
}

}  // namespace

bool JsonSchema::accepts(const json& value, const json& schema) const {
    for (const auto& [keyword, argument] : schema.items()) {
        if (!holds(keyword, argument, value, schema)) {
            return false;
        }
    }
    return keys_hold(value, schema);
}

bool JsonSchema::holds(const std::string& keyword, const json& argument, const json& value,
                       const json& schema) const {
    const auto fits = [&](const json& other) { return accepts(value, other); };
    const auto has = [&](const json& key) { return value.contains(key.get<std::string>()); };
    if (keyword == "$ref") {
        return fits(root_.at(json::json_pointer(argument.get<std::string>().substr(1))));
    }
    if (keyword == "type") {
        return is_type(value, argument);
    }
    if (keyword == "enum") {
        return any(argument, [&](const json& word) { return word == value; });
    }
    if (keyword == "const") {
        return value == argument;
    }
    if (keyword == "anyOf") {
        return any(argument, fits);
    }
    if (keyword == "allOf") {
        return all(argument, fits);
    }
    if (keyword == "oneOf") {
        return std::count_if(argument.begin(), argument.end(), fits) == 1;
    }
    if (keyword == "not") {
        return !fits(argument);
    }
    if (keyword == "if") {
        const char* branch = fits(argument) ? "then" : "else";
        return !schema.contains(branch) || fits(schema[branch]);
    }
    if (keyword == "minimum") {
        return !value.is_number() || value >= argument;
    }
    if (keyword == "maximum") {
        return !value.is_number() || value <= argument;
    }
    if (keyword == "minLength") {
        return !value.is_string() || value.get<std::string>().size() >= argument;
    }
    if (keyword == "maxLength") {
        return !value.is_string() || value.get<std::string>().size() <= argument;
    }
    if (keyword == "pattern") {
        // The one that there is; std::regex knows no control characters by number.
        const auto plain = [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != '\x7f'; };
        const std::string text = value.is_string() ? value.get<std::string>() : "";
        return std::all_of(text.begin(), text.end(), plain);
    }
    if (keyword == "minItems") {
        return !value.is_array() || value.size() >= argument;
    }
    if (keyword == "maxItems") {
        return !value.is_array() || value.size() <= argument;
    }
    if (keyword == "items") {
        return !value.is_array() || all(value, [&](const json& item) { return accepts(item, argument); });
    }
    if (keyword == "contains") {
        return !value.is_array() || any(value, [&](const json& item) { return accepts(item, argument); });
    }
    if (keyword == "required") {
        return !value.is_object() || all(argument, has);
    }
    if (keyword == "exclusiveMinimum") {
        return !value.is_number() || value > argument;
    }
    if (keyword == "properties") {
        return !value.is_object() || all(argument.items(), [&](const auto& entry) {
            return !value.contains(entry.key()) || accepts(value[entry.key()], entry.value());
        });
    }
    if (keyword == "propertyNames") {
        return !value.is_object() ||
               all(value.items(), [&](const auto& entry) { return accepts(json(entry.key()), argument); });
    }
    if (!notes.contains(keyword)) {
        throw std::invalid_argument("keyword " + keyword);
    }
    return true;
}

bool JsonSchema::keys_hold(const json& value, const json& schema) const {
    if (!value.is_object() || !schema.contains("additionalProperties")) {
        return true;
    }
    const json& others = schema["additionalProperties"];
    const json known = schema.value("properties", json::object());
    for (const auto& [key, member] : value.items()) {
        if (!known.contains(key) && (others == false || (others.is_object() && !accepts(member, others)))) {
            return false;
        }
    }
    return true;
}

}  // namespace scree::test
