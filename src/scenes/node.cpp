#include "node.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include <scree/scenes/scene_error.hpp>

namespace scree {

namespace {

constexpr std::size_t longest_compared = 40;  // letters; no known key comes near

/// Letters to take away and to put in; a letter changed is two, so that a shortened word finds the long one.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (const char letter : a) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (letter == b[j] ? 0 : 2);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

Node::Node(const Node& parent, std::string_view key)
    : value_(*parent.value_.find(key)), parent_(&parent), key_(key) {}

Node::Node(const Node& parent, std::size_t index)
    : value_(parent.value_[index]), parent_(&parent), index_(index) {}

std::string Node::path() const {
    if (parent_ == nullptr) {
        return "";
    }
    std::string part = std::to_string(index_);
    if (parent_->value_.is_object()) {
        part = in_quotes(key_);
        part = part.substr(1, part.size() - 2);
    }
    return parent_->parent_ == nullptr ? part : parent_->path() + "." + part;
}

void Node::refuse(const std::string& found, const std::string& expected) const {
    throw SceneError(path(), found, expected);
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> known) {
    word = word.substr(0, longest_compared);
    return *std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
        return edit_distance(word, a) < edit_distance(word, b);
    });
}

void check_keys(const Node& node, std::span<const std::string_view> known) {
    if (!node.value().is_object()) {
        node.refuse("an object");
    }
    for (const auto& [key, value] : node.value().items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            Node(node, key).refuse("an unknown key",
                                   in_quotes(nearest(key, known)) + " or another known key");
        }
    }
}

}  // namespace scree
