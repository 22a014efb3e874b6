#pragma once

#include <stdexcept>
#include <string>

namespace scree {

/// A scene that is refused. The message is one line: file, key or line, what was found, what was expected.
class SceneError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
    /// "PLACE: found FOUND, expected EXPECTED".
    SceneError(const std::string& place, const std::string& found, const std::string& expected)
        : SceneError((place.empty() ? "" : place + ": ") + "found " + found + ", expected " + expected) {}

    /// The same, with the file in front.
    [[nodiscard]] SceneError in_file(const std::string& file) const {
        return SceneError(file + ": " + what());
    }
};

}  // namespace scree
