#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <scree/mesh/vectors.hpp>

#include "node.hpp"

namespace scree {

// Each reads one value of the scene file and refuses what is not of its kind or range. Numbers end at 1e30,
// and positive ones begin at 1e-30, so that no product of a few of them leaves the range of doubles.
double number(const Node& node);
double positive(const Node& node);
double not_negative(const Node& node);
/// In (0, 1].
double fraction(const Node& node);
bool flag(const Node& node);
std::uint64_t seed(const Node& node);
std::size_t count(const Node& node);
/// A name of the user's: not empty, at most 200 bytes, no control characters.
std::string name(const Node& node);
void check_name(const Node& node, std::string_view text);

/// A list of numbers, each read by `each`.
std::vector<double> numbers(const Node& node, std::size_t count, double (*each)(const Node&));
Vec3 vector(const Node& node);
/// w, x, y, z; normalised.
Quat orientation(const Node& node);
/// One number for all, or three.
Vec3 scale(const Node& node);
Vec3 lengths(const Node& node);
/// Two numbers, the second not the smaller.
std::array<double, 2> size_range(const Node& node);

/// Calls read(node, list) for each entry.
template <class T>
std::vector<T> list(const Node& node, void (*read)(const Node&, T&)) {
    if (!node.value().is_array()) {
        node.refuse("a list");
    }
    std::vector<T> entries(node.value().size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        read(Node(node, i), entries[i]);
    }
    return entries;
}

}  // namespace scree
