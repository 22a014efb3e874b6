#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/output/energy_csv.hpp>
#include <scree/output/run_summary.hpp>
#include <scree/version.hpp>

using namespace scree;
using nlohmann::json;

TEST_CASE("summary.json has the documented keys", "[output]") {
    RunSummary summary;
    summary.scene = "pile";
    summary.status = "done";
    summary.smallest_step = 1e-5;
    summary.orders = {90, 722, 0, 0, 0};
    summary.energy.lost_friction = 0.25;
    summary.momentum_residual = 1e-12;
    summary.used = {"friction"};
    summary.bodies = {{"block", {{0.1, 0.2, 0.3}, Quat(0.5, 0.5, -0.5, 0.5)}, {1, 2, 3}, {4, 5, 6}}};
    const json read = json::parse(summary_json(summary));
    CHECK(read.at("scree") == version);
    CHECK(read.at("scene") == "pile");
    for (const char* key : {"status", "message", "end_time", "reached", "threads", "functional_iterations",
                            "contact_evaluations", "largest_overlap", "used", "left_out"}) {
        CAPTURE(key);
        CHECK(read.contains(key));
    }
    for (const char* stage : {"wall", "detection", "contacts", "jacobian", "solve", "output", "other"}) {
        CHECK(read.at("time").contains(stage));
    }
    for (const char* kind : {"accepted", "rejected_error", "rejected_newton", "rejected_contact"}) {
        CHECK(read.at("steps").contains(kind));
    }
    CHECK(read.at("step_size").at("min") == 1e-5);
    CHECK(read.at("step_size").at("max").is_null());
    CHECK(read.at("orders") == json{{"1", 90}, {"2", 722}});
    CHECK(read.at("newton").size() == 3);
    CHECK(read.at("contacts") == json{{"now", 0}, {"most", 0}});
    CHECK(read.at("energy").at("lost_friction") == 0.25);
    CHECK(read.at("energy").size() == std::size(ledger_entries));
    CHECK(read.at("momentum_residual") == 1e-12);
    const json& body = read.at("bodies").at(0);
    CHECK(body.at("name") == "block");
    CHECK(body.at("position") == json{0.1, 0.2, 0.3});
    CHECK(body.at("orientation") == json{0.5, 0.5, -0.5, 0.5});
    CHECK(body.at("velocity") == json{1, 2, 3});
    CHECK(body.at("angular_velocity") == json{4, 5, 6});
}
