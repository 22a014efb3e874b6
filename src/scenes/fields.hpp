#pragma once

#include <array>

#include "node.hpp"

namespace scree {

/// One key of an object of the scene file, and what reading it does to the description.
template <class T>
struct Field {
    std::string_view key;
    void (*read)(const Node&, T&);
    bool required = false;
};

constexpr bool required = true;

/// The commonest reading: a value into a member.
template <auto member, auto value, class T>
void into(const Node& node, T& target) {
    target.*member = value(node);
}

/// Reads an object by its table; keys that the table does not have are refused.
template <class T, std::size_t count>
void read_fields(const Node& node, const Field<T> (&fields)[count], T& target) {
    std::array<std::string_view, count> known;
    for (std::size_t i = 0; i < count; ++i) {
        known[i] = fields[i].key;
    }
    check_keys(node, known);
    for (const Field<T>& field : fields) {
        if (node.value().contains(field.key)) {
            field.read(Node(node, field.key), target);
        } else if (field.required) {
            node.refuse("no " + in_quotes(field.key), "that key");
        }
    }
}

/// A word of the scene file and what it stands for.
template <class E>
struct Choice {
    std::string_view word;
    E value;
};

/// Reads one of the words of a table.
template <auto& choices>
auto choice(const Node& node) {
    std::string words;
    for (const auto& each : choices) {
        if (node.value() == each.word) {
            return each.value;
        }
        words += (words.empty() ? "" : ", ") + in_quotes(each.word);
    }
    node.refuse("one of " + words);
}

}  // namespace scree
