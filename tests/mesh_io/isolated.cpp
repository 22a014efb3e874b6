#include <csignal>
#include <string>

#include <catch2/catch.hpp>

#include <scree/mesh_io/isolated.hpp>

using namespace scree;

namespace {

constexpr IsolationLimits modest{1, std::uintmax_t{64} << 20};

}  // namespace

TEST_CASE("Work in a process of its own gives its result, however long", "[mesh_io]") {
    const std::string large(3'000'000, 'x');
    CHECK(run_isolated([&] { return large + "y"; }, modest) == large + "y");
    CHECK(run_isolated([] { return std::string(); }, modest).empty());
}

TEST_CASE("What such work does to itself is an error here and no more", "[mesh_io]") {
    const auto crash = [] {
        std::raise(SIGSEGV);
        return std::string();
    };
    CHECK_THROWS_WITH(run_isolated(crash, modest), "the importer crashes on it");
    const auto spin = [] {
        for (volatile bool on = true; on;) {
        }
        return std::string();
    };
    CHECK_THROWS_WITH(run_isolated(spin, modest), "it takes too long");
    const auto fail = []() -> std::string { throw 3; };
    CHECK_THROWS_WITH(run_isolated(fail, modest), "the importer fails on it");
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("Such work gets no more memory than its limit", "[mesh_io]") {
    const auto fill = [] {
        std::string all;
        for (int i = 0; i < 100; ++i) {
            all += std::string(10'000'000, 'x');
        }
        return all;
    };
    CHECK_THROWS_WITH(run_isolated(fill, modest), "the importer fails on it");
}
#endif
