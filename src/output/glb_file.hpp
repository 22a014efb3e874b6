#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace scree {

/// A binary glTF file, taken apart. Throws std::runtime_error for what is none, as do all that look into one.
struct GlbFile {
    nlohmann::ordered_json json;
    std::string binary;

    explicit GlbFile(std::string_view bytes);
    [[nodiscard]] std::string bytes() const;

    /// The numbers that an accessor of floats has, one after the other.
    [[nodiscard]] std::vector<float> numbers(std::size_t accessor) const;
};

}  // namespace scree
