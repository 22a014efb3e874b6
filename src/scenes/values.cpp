#include "values.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double largest = 1e30;
constexpr double smallest = 1e-30;
constexpr std::size_t most_bodies = 1'000'000;
constexpr std::size_t longest_name = 200;  // bytes

}  // namespace

double number(const Node& node) {
    if (!node.value().is_number() || !(std::abs(node.value().get<double>()) <= largest)) {
        node.refuse("a number");
    }
    return node.value().get<double>();
}

double positive(const Node& node) {
    if (const double value = number(node); value >= smallest) {
        return value;
    }
    node.refuse("a number above 0");
}

double not_negative(const Node& node) {
    if (const double value = number(node); value >= 0) {
        return value;
    }
    node.refuse("a number not below 0");
}

double fraction(const Node& node) {
    if (const double value = positive(node); value <= 1) {
        return value;
    }
    node.refuse("a number above 0 and at most 1");
}

bool flag(const Node& node) {
    if (!node.value().is_boolean()) {
        node.refuse("true or false");
    }
    return node.value().get<bool>();
}

std::uint64_t seed(const Node& node) {
    if (!node.value().is_number_unsigned()) {
        node.refuse("a whole number not below 0");
    }
    return node.value().get<std::uint64_t>();
}

std::size_t count(const Node& node) {
    if (!node.value().is_number_unsigned() || node.value() < 1U || node.value() > most_bodies) {
        node.refuse("a whole number from 1 to " + std::to_string(most_bodies));
    }
    return node.value().get<std::size_t>();
}

void check_name(const Node& node, std::string_view text) {
    const bool control = std::any_of(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
    if (text.empty() || text.size() > longest_name || control) {
        node.refuse(in_quotes(text), "a name of 1 to 200 bytes without control characters");
    }
}

std::string name(const Node& node) {
    if (!node.value().is_string()) {
        node.refuse("a name");
    }
    auto text = node.value().get<std::string>();
    check_name(node, text);
    return text;
}

std::vector<double> numbers(const Node& node, std::size_t count, double (*each)(const Node&)) {
    if (!node.value().is_array() || node.value().size() != count) {
        node.refuse("a list of " + std::to_string(count) + " numbers");
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(each(Node(node, i)));
    }
    return values;
}

Vec3 vector(const Node& node) {
    return Vec3(numbers(node, 3, number).data());
}

Vec3 lengths(const Node& node) {
    return Vec3(numbers(node, 3, positive).data());
}

Vec3 scale(const Node& node) {
    if (node.value().is_array()) {
        return lengths(node);
    }
    return Vec3::Constant(positive(node));
}

Quat orientation(const Node& node) {
    const auto q = numbers(node, 4, number);
    const Quat turn(q[0], q[1], q[2], q[3]);
    if (!(turn.norm() >= smallest)) {
        node.refuse("a quaternion w, x, y, z that is not zero");
    }
    return turn.normalized();
}

std::array<double, 2> size_range(const Node& node) {
    const auto range = numbers(node, 2, positive);
    if (range[0] > range[1]) {
        node.refuse("the smaller number first");
    }
    return {range[0], range[1]};
}

}  // namespace scree
