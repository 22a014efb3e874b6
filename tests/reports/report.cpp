#include <csignal>

#include <catch2/catch.hpp>

#include <scree/reports/report.hpp>
#include <scree/scenes/scene_error.hpp>

#include <src/reports/accuracy.hpp>
#include <src/reports/cost.hpp>
#include <src/reports/stability.hpp>
#include <tests/cli/child.hpp>

using namespace scree;
using scree::test::Folder;
using scree::test::text_of;

namespace {

ReportRequest request_for(const Folder& folder, const std::string& only) {
    ReportRequest request;
    request.quick = true;
    request.out = folder.path();
    request.only = {only};
    return request;
}

/// How many cases it still measured; it stops before the one of that number.
std::size_t measured(const ReportRequest& request, std::size_t most = 1000) {
    std::size_t count = 0;
    make_report(request, [&](std::size_t done, std::size_t, const std::string&) {
        count = done < most ? done + 1 : count;
        return done < most;
    });
    return count;
}

}  // namespace

TEST_CASE("What crashes or never ends is a row that says so", "[reports]") {
    const Isolated crash = isolated_row(
        []() -> Row {
            std::raise(SIGSEGV);
            return {};
        },
        {1});
    CHECK_FALSE(crash.done);
    CHECK(crash.message == "the program crashes on it");
    const Isolated good = isolated_row([] { return Row{"a, b", "2"}; }, {1});
    CHECK(good.done);
    CHECK(good.row == Row{"a, b", "2"});
}

TEST_CASE("A report that was stopped goes on where it was, and measures nothing twice", "[reports]") {
    const Folder folder;
    ReportRequest request = request_for(folder, "stable_steps");
    request.stability = true;
    CHECK(measured(request, 2) == 2);
    const std::string first = text_of(folder / "stable_steps.csv");
    CHECK(measured(request, 1) == 1);
    CHECK_THAT(text_of(folder / "stable_steps.csv"), Catch::StartsWith(first));
    CHECK(stable_steps_table(folder.path()).rows().size() == 3);
    CHECK_THAT(text_of(folder / "report.md"), Catch::Contains("Greatest stable step"));
    CHECK_THAT(text_of(folder / "about.csv"), Catch::Contains("processor,") && Catch::Contains("commit,"));
    // Another extent has other rows.
    request.quick = false;
    CHECK(measured(request, 1) == 1);
    CHECK(stable_steps_table(folder.path()).rows().size() == 1);
}

TEST_CASE("A name that nothing has is refused", "[reports]") {
    const Folder folder;
    ReportRequest request = request_for(folder, "inclyne");
    request.accuracy = true;
    CHECK_THROWS_AS(measured(request), SceneError);
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("Accuracy of a small problem: every row has an outcome, and the exact ones beat the coarse ones",
          "[reports]") {
    const Folder folder;
    const Problem problem = cradle_problem();
    Table references = reference_table(folder.path());
    for (const MethodChoice& method :
         {adaptive_bdf(2, 1e-7), explicit_method(SteppingMethod::verlet, 1e-6)}) {
        references.add(reference_row(problem, method, {20}));
    }
    const Reference reference = reference_of(problem, references);
    REQUIRE(reference.known());
    CHECK(reference.agreement < 1e-4);
    CHECK(reference.model_error > 0.01);
    Table table = accuracy_table(folder.path());
    for (const double rtol : {1e-2, 1e-4}) {
        table.add(accuracy_row(problem, adaptive_bdf(2, rtol), reference, {10}));
    }
    table.add(accuracy_row(problem, bullet_method(1.0 / 240, 10), reference, {10}));
    const auto value = [&](std::size_t row, const char* column) {
        return table.number(table.rows()[row], column);
    };
    CHECK(value(1, "numerical_error") < value(0, "numerical_error") / 10);
    CHECK(value(0, "seconds") > 0);
    CHECK(table.at(table.rows()[0], "method") == "bdf2");
    CHECK(table.at(table.rows()[2], "method") == "bullet");
    CHECK(table.at(table.rows()[2], "settings") == "10 iterations");
    CHECK(table.at(table.rows()[2], "numerical_error").empty());
}

TEST_CASE("Stability: a cube settles by BDF at any stiffness, and an explicit method is caught failing",
          "[reports]") {
    Settling settling;
    settling.youngs_modulus = 1e12;
    const Extreme extreme{"Y [Pa]", "1e12", settling_problem(settling)};
    const Folder folder;
    Table table = stability_table(folder.path());
    table.add(stability_row(extreme, adaptive_bdf(2, 1e-3), {20}));
    table.add(stability_row(extreme, explicit_method(SteppingMethod::verlet, 1e-3), {20}));
    CHECK(table.at(table.rows()[0], "status") == "stable");
    CHECK(table.number(table.rows()[0], "energy_invented") < 1e-6);
    CHECK(table.at(table.rows()[1], "status") == "failed");
    CHECK_FALSE(table.at(table.rows()[1], "told").empty());
}

TEST_CASE("Cost: what a scene does not need leaves no trace", "[reports]") {
    const Folder folder;
    ReportRequest request = request_for(folder, "left_out");
    request.cost = true;
    CHECK(measured(request) == 20);
    const Table table = left_out_table(folder.path());
    const auto row = [&](const std::string& need, const std::string& side) {
        for (const Row& each : table.rows()) {
            if (table.at(each, "need") == need && table.at(each, "side") == side) {
                return each;
            }
        }
        FAIL("no row");
        return Row();
    };
    for (const Row& each : table.rows()) {
        CHECK(table.at(each, "status") == "done");
    }
    CHECK_THAT(table.at(row("friction", "with"), "entered"), Catch::Contains("friction"));
    CHECK_THAT(table.at(row("friction", "without"), "entered"), !Catch::Contains("friction"));
    CHECK(table.number(row("output", "with"), "written") > 0);
    CHECK(table.number(row("output", "without"), "written") == 0);
    CHECK(table.number(row("bodies that are awake", "without"), "evaluations") <
          table.number(row("bodies that are awake", "with"), "evaluations"));
    CHECK_THAT(text_of(folder / "libraries.csv"), Catch::Contains("core,"));
    CHECK_THAT(text_of(folder / "index.html"), Catch::Contains("What is left out"));
}
