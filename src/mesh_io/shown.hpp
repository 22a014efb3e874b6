#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace scree {

/// What a file says, for an error message: the first line of it, of bearable length, without control
/// characters.
inline std::string shown(std::string_view text, std::size_t longest = 40) {
    std::string line(text.substr(0, std::min(text.find('\n'), longest)));
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
    return line;
}

}  // namespace scree
