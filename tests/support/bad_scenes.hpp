#pragma once

#include <string>
#include <vector>

namespace scree::test {

/// A scene that is refused, and a part of the line that does it.
struct BadScene {
    std::string text;
    std::string setting;  ///< KEY=VALUE that spoils it; empty: the text is bad itself
    std::string message;
};

/// Texts that are no scene, for a file named small.json.
std::vector<BadScene> bad_texts();
/// The small scene with one value changed.
std::vector<BadScene> bad_values();
/// The same with a value that a scene file may have but this build cannot do.
std::vector<BadScene> absent_values();

}  // namespace scree::test
