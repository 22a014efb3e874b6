#include <limits>

#include <catch2/catch.hpp>

#include <scree/mesh/saved_state.hpp>

using namespace scree;

namespace {

enum class Colour { red, green };

struct Leaf {
    Vec3 place = Vec3::Zero();
    int number = 0;
};
void visit_state(auto& with, StateOf<Leaf> auto& leaf) {
    auto& [place, number] = leaf;
    with(place, number);
}

struct Tree {
    double height = 0;
    bool alive = false;
    Colour colour = Colour::red;
    std::size_t branches = 0;
    Quat turn = Quat::Identity();
    std::optional<double> age;
    std::vector<Leaf> leaves;
    std::array<double, 2> roots{};
    double cache = 0;
};
void visit_state(auto& with, StateOf<Tree> auto& tree) {
    auto& [height, alive, colour, branches, turn, age, leaves, roots, cache] = tree;
    with(height, alive, colour, turn, age, leaves, roots);
    with.up_to(5, branches);
}

Tree some_tree() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {0.1,
            true,
            Colour::green,
            5,
            Quat(0.5, -0.5, 0.5, -0.5),
            1e-300,
            {{Vec3(1, 2, 3), -4}, {}},
            {-0.0, infinity},
            7};
}

SavedState state_of(const Tree& tree) {
    SavedState state;
    StateWriter with(state);
    with(tree);
    return state;
}

}  // namespace

template <>
inline constexpr std::uint64_t scree::enumerators<Colour> = 2;

TEST_CASE("What is kept comes back to the last bit, and nothing else does") {
    const Tree tree = some_tree();
    const SavedState state = state_of(tree);
    Tree other;
    other.leaves.resize(7);
    StateReader with(state);
    with(other);
    with.finish();
    CHECK(other.height == 0.1);
    CHECK(other.alive);
    CHECK(other.colour == Colour::green);
    CHECK(other.branches == 5);
    CHECK(other.turn.coeffs() == tree.turn.coeffs());
    CHECK(other.age == 1e-300);
    REQUIRE(other.leaves.size() == 2);
    CHECK(other.leaves[0].number == -4);
    CHECK(other.leaves[0].place == Vec3(1, 2, 3));
    CHECK(std::signbit(other.roots[0]));
    CHECK(std::isinf(other.roots[1]));
    CHECK(other.cache == 0);
    CHECK(state_of(other) == state);
}

TEST_CASE("A state that is too short, too long or impossible is refused") {
    const SavedState state = state_of(some_tree());
    const auto refused = [](const SavedState& changed) {
        Tree tree;
        StateReader with(changed);
        CHECK_THROWS_AS((with(tree), with.finish()), StateError);
    };
    for (std::size_t size = 0; size < state.numbers.size(); ++size) {
        SavedState shorter = state;
        shorter.numbers.resize(size);
        refused(shorter);
    }
    for (std::size_t size = 0; size < state.counts.size(); ++size) {
        SavedState shorter = state;
        shorter.counts.resize(size);
        refused(shorter);
    }
    SavedState longer = state;
    longer.counts.push_back(0);
    refused(longer);
    for (std::size_t i = 0; i < state.counts.size(); ++i) {  // no bool, colour, size or number of branches
        SavedState huge = state;
        huge.counts[i] = std::uint64_t{1} << 40;
        refused(huge);
    }
}
