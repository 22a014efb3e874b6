#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace scree::test {

/// As much of JSON Schema, draft 7, as the schema of scenes uses; what it does not know it refuses to use.
class JsonSchema {
  public:
    explicit JsonSchema(nlohmann::json schema) : root_(std::move(schema)) {}

    [[nodiscard]] bool accepts(const nlohmann::json& value) const { return accepts(value, root_); }

  private:
    [[nodiscard]] bool accepts(const nlohmann::json& value, const nlohmann::json& schema) const;
    [[nodiscard]] bool holds(const std::string& keyword, const nlohmann::json& argument,
                             const nlohmann::json& value, const nlohmann::json& schema) const;
    [[nodiscard]] bool keys_hold(const nlohmann::json& value, const nlohmann::json& schema) const;

    nlohmann::json root_;
};

}  // namespace scree::test
