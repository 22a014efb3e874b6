#include <catch2/catch.hpp>

#include <scree/dynamics/islands.hpp>

using namespace scree;

namespace {

// Bodies by whether they are free, pairs, and which of those have a force.
struct Groups {
    std::vector<Body> bodies;
    std::vector<Contact> contacts;
    std::vector<ContactResult> results;
    Islands islands;

    explicit Groups(const std::vector<bool>& free) {
        for (const bool is_free : free) {
            bodies.emplace_back();
            if (is_free) {
                bodies.back().mass = 1;
            }
        }
    }
    void touch(int a, int b, ContactState state = ContactState::stick) {
        contacts.push_back({{a, nullptr, {}}, {b, nullptr, {}}, {}, {}});
        results.emplace_back();
        results.back().law.state = state;
    }
    void find() { islands.find(bodies, contacts, results); }
    [[nodiscard]] std::vector<int> members(std::size_t island) const {
        const auto span = islands.bodies(island);
        return {span.begin(), span.end()};
    }
};

}  // namespace

TEST_CASE("Bodies that touch directly or through others are one island, in ascending order", "[dynamics]") {
    Groups groups(std::vector<bool>(6, true));
    groups.touch(4, 5);
    groups.touch(0, 3);
    groups.touch(3, 5, ContactState::slip);
    groups.find();
    REQUIRE(groups.islands.count() == 3);
    CHECK(groups.members(0) == std::vector<int>{0, 3, 4, 5});
    CHECK(groups.members(1) == std::vector<int>{1});
    CHECK(groups.members(2) == std::vector<int>{2});
    CHECK(groups.islands.island_of(4) == 0);
    CHECK(groups.islands.place_of(4) == 2);
    CHECK(groups.islands.place_of(2) == 0);
}

TEST_CASE("A fixed body joins nobody and is on no island", "[dynamics]") {
    Groups groups({false, true, true, true});
    groups.touch(0, 1);
    groups.touch(0, 2);
    groups.touch(2, 3);
    groups.find();
    REQUIRE(groups.islands.count() == 2);
    CHECK(groups.members(0) == std::vector<int>{1});
    CHECK(groups.members(1) == std::vector<int>{2, 3});
    CHECK(groups.islands.island_of(0) == -1);
}

TEST_CASE("A pair without a force joins nobody", "[dynamics]") {
    Groups groups({true, true});
    groups.touch(0, 1, ContactState::open);
    groups.find();
    CHECK(groups.islands.count() == 2);
}

TEST_CASE("Islands do not depend on the order of the contacts, and can be found again", "[dynamics]") {
    Groups forth(std::vector<bool>(10, true));
    Groups back(std::vector<bool>(10, true));
    for (int i = 0; i < 9; ++i) {
        if (i != 4) {
            forth.touch(i, i + 1);
            back.touch(8 - i, 9 - i, i == 4 ? ContactState::open : ContactState::stick);
        }
    }
    forth.find();
    forth.find();
    REQUIRE(forth.islands.count() == 2);
    CHECK(forth.members(0) == std::vector<int>{0, 1, 2, 3, 4});
    CHECK(forth.members(1) == std::vector<int>{5, 6, 7, 8, 9});
    back.find();
    CHECK(back.members(0) == forth.members(0));
    CHECK(back.members(1) == forth.members(1));
    back.contacts.clear();
    back.results.clear();
    back.find();
    CHECK(back.islands.count() == 10);
    const Groups none({});
    CHECK(none.islands.count() == 0);
}
