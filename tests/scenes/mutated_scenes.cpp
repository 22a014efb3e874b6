#include <catch2/catch.hpp>

#include <tests/support/random.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

namespace {

const std::string pieces[] = {
    "{",     "}",    "[",    "]",       ",",    ":",        "\"",        "//", "/*",     "-",
    "1e308", "null", "true", "\\u0000", "\xc3", "\"fill\"", "\"count\"", "0",  "1e-400", "[[0,0,0],[1,1,1]]",
    "\n"};

std::size_t place_in(const std::string& text, Random& random) {
    return static_cast<std::size_t>(random.uniform(0, static_cast<double>(text.size())));
}

/// One to four random changes: something put in, taken out, doubled or exchanged for another byte.
std::string mutated(std::string text, Random& random) {
    const double changes = random.uniform(1, 5);
    for (int i = 1; i < changes && !text.empty(); ++i) {
        const std::size_t at = place_in(text, random);
        const std::size_t length = place_in(text.substr(at), random) % 20;
        const double kind = random.uniform();
        if (kind < 0.4) {
            text.insert(at, pieces[place_in(std::string(std::size(pieces), ' '), random)]);
        } else if (kind < 0.6) {
            text.erase(at, length);
        } else if (kind < 0.8) {
            text.insert(at, text.substr(at, length));
        } else {
            text[at] = static_cast<char>(random.uniform(0, 256));
        }
    }
    return text;
}

}  // namespace

TEST_CASE("A damaged scene is accepted or refused by one line, never more", "[scenes]") {
    Random random(17);
    int accepted = 0;
    for (int i = 0; i < 20'000; ++i) {
        const std::string text = mutated(small_scene, random);
        try {
            parse_scene(text, "small.json");
            ++accepted;
        } catch (const SceneError& error) {
            const std::string message = error.what();
            if (message.find('\n') != std::string::npos || message.size() > 300 ||
                message.rfind("small.json:", 0) != 0) {
                FAIL(message << "\nfor\n" << text);
            }
        }
    }
    CHECK(accepted > 20);
}
