#pragma once

#include <array>
#include <bitset>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// What something is at one time, to be put back into its like, so that both go on alike. A row of numbers,
/// and one of whole numbers; whoever writes them knows their order.
///
/// What a type has to keep is named in one place, a function beside it,
///
///     void visit_state(auto& with, StateOf<T> auto& t) {
///         auto& [first, second, buffer] = t;
///         with(first, second);
///     }
///
/// which serves for writing and for reading. The binding names all members, so that one that is added does
/// not go unnoticed: nothing compiles until it is decided whether it is kept.
struct SavedState {
    std::vector<double> numbers;        ///< all that is a double, in the order of writing
    std::vector<std::uint64_t> counts;  ///< whole numbers, flags and enumerations, likewise

    /// Number by number.
    bool operator==(const SavedState&) const = default;
};

/// A saved state that does not fit what it is to be put into.
class StateError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// T itself, to be filled, or a constant one to be kept.
template <class T, class Type>
concept StateOf = std::same_as<std::remove_const_t<T>, Type>;

/// How many values an enumeration has, for those that are kept.
template <class Enumeration>
inline constexpr std::uint64_t enumerators = 0;

/// Appends what it is called with to a saved state.
class StateWriter {
  public:
    /// Appends to `state`, which must outlive the writer.
    explicit StateWriter(SavedState& state) : state_(state) {}

    /// Appends values, one after the other.
    template <class... T>
    void operator()(const T&... values) {
        (write(values), ...);
    }
    /// A whole number that is `most` at most.
    void up_to(std::uint64_t /*most*/, const std::size_t& value) { write(value); }
    /// The first `count` of a list.
    template <class T>
    void first(std::size_t count, const std::vector<T>& list) {
        for (std::size_t i = 0; i < count; ++i) {
            write(list[i]);
        }
    }
    /// A list that is as long already when it is read.
    template <class T>
    void each(const std::vector<T>& list) {
        write(list);
    }

  private:
    void write(double value) { state_.numbers.push_back(value); }
    template <class T>
    requires std::integral<T> || std::is_enum_v<T>
    void write(T value) { state_.counts.push_back(static_cast<std::uint64_t>(value)); }
    template <int rows, int columns>
    void write(const Eigen::Matrix<double, rows, columns>& matrix) {
        state_.numbers.insert(state_.numbers.end(), matrix.data(), matrix.data() + rows * columns);
    }
    void write(const Quat& quaternion) { write(quaternion.coeffs()); }
    template <class T, std::size_t size>
    void write(const std::array<T, size>& list) {
        for (const T& value : list) {
            write(value);
        }
    }
    template <std::size_t size>
    void write(const std::bitset<size>& bits) {
        write(bits.to_ullong());
    }
    template <class T>
    void write(const std::vector<T>& list) {
        write(list.size());
        first(list.size(), list);
    }
    template <class T>
    void write(const std::optional<T>& value) {
        write(value.has_value());
        if (value) {
            write(*value);
        }
    }
    template <class T>
    requires std::is_class_v<T>
    void write(const T& value) { visit_state(*this, value); }

    SavedState& state_;
};

/// Takes back what a writer has written, in the same order. Throws StateError for what cannot be.
class StateReader {
  public:
    /// Reads `state` from its start; it must outlive the reader.
    explicit StateReader(const SavedState& state) : state_(state) {}

    /// Fills values, one after the other.
    template <class... T>
    void operator()(T&... values) {
        (read(values), ...);
    }
    /// A whole number that must be `most` at most.
    void up_to(std::uint64_t most, std::size_t& value) {
        read(value);
        require(value <= most);
    }
    /// Makes the list `count` long and fills it.
    template <class T>
    void first(std::size_t count, std::vector<T>& list) {
        require(count <= left());
        list.resize(count);
        for (T& value : list) {
            read(value);
        }
    }
    /// Fills a list, which must have the length that was written.
    template <class T>
    void each(std::vector<T>& list) {
        const std::size_t size = list.size();
        read(list);
        require(list.size() == size);
    }

    /// For those that know more of what can be.
    static void require(bool possible) {
        if (!possible) {
            throw StateError("a state that does not fit the scene");
        }
    }
    /// Nothing may be left.
    void finish() const { require(left() == 0); }

  private:
    [[nodiscard]] std::size_t left() const {
        return state_.numbers.size() - number_ + state_.counts.size() - count_;
    }

    void read(double& value) {
        require(number_ < state_.numbers.size());
        value = state_.numbers[number_++];
    }
    template <class T>
    requires std::integral<T> || std::is_enum_v<T>
    void read(T& value) {
        require(count_ < state_.counts.size());
        const std::uint64_t count = state_.counts[count_++];
        value = static_cast<T>(count);
        require(static_cast<std::uint64_t>(value) == count);
        if constexpr (std::is_enum_v<T>) {
            require(count < enumerators<T>);
        }
    }
    template <int rows, int columns>
    void read(Eigen::Matrix<double, rows, columns>& matrix) {
        for (double& value : matrix.reshaped()) {
            read(value);
        }
    }
    void read(Quat& quaternion) { read(quaternion.coeffs()); }
    template <class T, std::size_t size>
    void read(std::array<T, size>& list) {
        for (T& value : list) {
            read(value);
        }
    }
    template <std::size_t size>
    void read(std::bitset<size>& bits) {
        unsigned long long value = 0;
        read(value);
        bits = std::bitset<size>(value);
        require(bits.to_ullong() == value);
    }
    template <class T>
    void read(std::vector<T>& list) {
        std::size_t size = 0;
        read(size);
        first(size, list);
    }
    template <class T>
    void read(std::optional<T>& value) {
        bool has_value = false;
        read(has_value);
        value.reset();
        if (has_value) {
            read(value.emplace());
        }
    }
    template <class T>
    requires std::is_class_v<T>
    void read(T& value) { visit_state(*this, value); }

    const SavedState& state_;
    std::size_t number_ = 0, count_ = 0;  ///< next to be read
};

}  // namespace scree
