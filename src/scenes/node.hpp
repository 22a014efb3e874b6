#pragma once

#include <span>
#include <string>
#include <string_view>

#include "json_text.hpp"

namespace scree {

/// A value of the scene file that knows the way to it, for error messages. Lives no longer than its parent.
class Node {
  public:
    explicit Node(const Json& value) : value_(value) {}
    Node(const Node& parent, std::string_view key);
    Node(const Node& parent, std::size_t index);

    [[nodiscard]] const Json& value() const { return value_; }
    [[nodiscard]] std::string path() const;  ///< dotted, "bodies.1.position"

    [[noreturn]] void refuse(const std::string& expected) const { refuse(shown(value_), expected); }
    [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;

  private:
    const Json& value_;
    const Node* parent_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
};

/// The known word that takes the fewest letters taken away and put in to become `word`.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

/// Refuses what is no object, and keys that are not known, naming the nearest.
void check_keys(const Node& node, std::span<const std::string_view> known);

}  // namespace scree
