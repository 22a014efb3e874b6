#include <catch2/catch.hpp>

#include <scree/scenes/output_times.hpp>

using scree::OutputTimes;

TEST_CASE("Output times are i times the interval, and the end", "[scenes]") {
    const OutputTimes times(0.02, 2);
    CHECK(times.last() == 100);
    CHECK(times.at(0) == 0);
    CHECK(times.at(3) == 3 * 0.02);
    CHECK(times.at(99) == 99 * 0.02);
    CHECK(times.at(100) == 2);
}

TEST_CASE("An end that is no multiple makes a shorter last tick", "[scenes]") {
    const OutputTimes times(0.3, 1);
    CHECK(times.last() == 4);
    CHECK(times.at(3) == 3 * 0.3);
    CHECK(times.at(4) == 1);
    CHECK(OutputTimes(5, 1).last() == 1);
}

TEST_CASE("Rounding makes no tick of its own", "[scenes]") {
    const OutputTimes times(0.1, 0.3);  // 3 · 0.1 is above 0.3
    CHECK(times.last() == 3);
    CHECK(times.at(3) == 0.3);
    CHECK(OutputTimes(0.1, 3 * 0.1).last() == 3);
    CHECK(OutputTimes(1e-3, 1e6).last() == 1'000'000'000);
}

TEST_CASE("A run stops at the last output time up to the one asked for", "[scenes]") {
    const OutputTimes times(0.1, 1);
    CHECK(times.last_until(0) == 0);
    CHECK(times.last_until(0.05) == 0);
    CHECK(times.last_until(0.3) == 3);  // although 3 · 0.1 is above 0.3
    CHECK(times.last_until(0.299999) == 2);
    CHECK(times.last_until(0.95) == 9);
    CHECK(times.last_until(1) == 10);
    CHECK(times.last_until(1e300) == 10);
    const OutputTimes uneven(0.3, 1);
    CHECK(uneven.last_until(0.95) == 3);
    CHECK(uneven.last_until(1) == 4);
}
