#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace scree::test {

/// A binary glTF file, read independently of what writes them.
struct Glb {
    nlohmann::json json;
    std::string binary;

    /// Checks the container with Catch.
    explicit Glb(const std::string& bytes);

    /// The numbers of an accessor, whatever their type; checks that they lie within their buffer view, and
    /// that within the buffer.
    [[nodiscard]] std::vector<double> numbers(std::size_t accessor) const;
};

/// Checks what the specification of glTF 2 asks of a file like ours: references that lead somewhere,
/// accessors within their buffers and with true bounds, indices of vertices that exist, unit normals, key
/// times that rise, channels of nodes that have no matrix, unit rotations.
void check_glb(const Glb& glb);

}  // namespace scree::test
