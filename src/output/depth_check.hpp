#pragma once

#include <string_view>

namespace scree {

/// Whether CBOR has lists or maps within one another deeper than `most`. The parser goes as deep as its input
/// does, which may be too deep for the stack. Bytes that are no CBOR do not, up to where they are none.
bool nests_deeper(std::string_view cbor, std::size_t most);

}  // namespace scree
