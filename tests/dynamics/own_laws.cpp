#include <catch2/catch.hpp>

#include <demos/cohesion/sintering_law.hpp>
#include <demos/hertz_mindlin/elastic_spheres_law.hpp>
#include <tests/dynamics/residual_error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double h = 1e-3;
constexpr double depth = 2e-3;

// The built-in law, whose whole derivative is known, as if it were not.
struct KeepsItBack {
    WholeDerivativeLaw<> law;
    void operator()(const ContactInput& in, ContactForce& out) const {
        CHECK(in.rates == nullptr);
        law(in, out);
    }
};

// Counts the steps in contact, and how many of them it was told of.
struct Counting {
    struct History {
        int steps = 0;
        double last_volume = 0;
    };
    BuiltInLaw<LawParts{}> law;
    void operator()(const ContactInput& in, std::span<const History> past, ContactForce& out,
                    History& trial) const {
        law(in, out);
        trial.steps = past.empty() ? 1 : past[0].steps + 1;
        trial.last_volume = in.geometry.volume;
    }
};

StepCase two_spheres(Random& random) {
    const double speed = 0.2 * depth / h;
    StepCase step;
    step.add_body(Sphere{0.1}, {Vec3(0.01, 0.02, 0), Quat::Identity()}, speed * random.vector(),
                  10 * speed * random.vector());
    step.add_body(Sphere{0.07}, {Vec3(0, 0, 0.17 - depth), random.rotation()}, speed * random.vector(),
                  10 * speed * random.vector());
    Contact& contact = step.add_contact(0, 1);
    contact.history.push({10 * random.vector(), random.direction(), 1e5});
    return step;
}

}  // namespace

TEST_CASE("A law without derivative is differenced as exactly as differences are", "[dynamics]") {
    Random random(321);
    const double friction = GENERATE(0.3, 1e6);
    for (int i = 0; i < 20; ++i) {
        StepCase step = two_spheres(random);
        step.system.contacts[0].pair.friction = friction;
        ForcesOf<WholeDerivativeLaw<>> known({{}, 0.03});
        ForcesOf<KeepsItBack> unknown({{{}, 0.03}});
        StepProblem one(step.system, known);
        StepProblem other(step.system, unknown);
        step.begin(one, h, 2);
        step.begin(other, h, 2);
        one.factorize();
        other.factorize();
        const Eigen::MatrixXd exact = one.jacobian().dense();
        // One-sided differences over the mean of depth and rounding: √(10⁻¹⁶ Lc/δ), some 10⁻⁷ here.
        CHECK((other.jacobian().dense() - exact).norm() < 1e-5 * exact.norm());
        CHECK(one.residual() == other.residual());
    }
}

TEST_CASE("The laws of the demos have the derivatives that they give or are given", "[dynamics]") {
    Random random(322);
    for (int i = 0; i < 20; ++i) {
        StepCase step = two_spheres(random);
        ForcesOf<ElasticSpheres> hertz({});
        CHECK(residual_error(step, hertz, h, 1, depth, 0.1).error < 1e-5);
        SinteringLaw law;
        law.strength = 1e5;
        step.system.contacts[0].history.push_own(std::vector<double>{1e-3});
        step.system.contacts[0].pair.torsion = false;
        ForcesOf<SinteringLaw> sintering(law);
        CHECK(residual_error(step, sintering, h, 1, depth, 0.1).error < 1e-8);
    }
}

TEST_CASE("A law's own records come back as they were, the latest first", "[dynamics]") {
    ContactHistory history;
    CHECK(OwnRecords<Counting::History>(history).past().empty());
    for (int i = 1; i <= 7; ++i) {
        std::vector<double> record;
        const OwnRecords<Counting::History> known(history);
        known.write({i, 0.5 * i}, record);
        history.push({});
        history.push_own(record);
    }
    const OwnRecords<Counting::History> records(history);
    REQUIRE(records.past().size() == highest_order);
    for (std::size_t j = 0; j < highest_order; ++j) {
        CHECK(records.past()[j].steps == 7 - static_cast<int>(j));
        CHECK(records.past()[j].last_volume == 0.5 * (7 - static_cast<double>(j)));
    }
    history.clear();
    CHECK(OwnRecords<Counting::History>(history).past().empty());
}

TEST_CASE("Evaluating a law with a history leaves the history alone", "[dynamics]") {
    Random random(323);
    const StepCase step = two_spheres(random);
    ForcesOf<Counting> forces({});
    StepProblem problem(step.system, forces);
    for (int i = 0; i < 3; ++i) {
        step.begin(problem, h, 1, i == 1 ? Detail::derivative : Detail::force);
        CHECK(step.system.contacts[0].history.own.empty());
        REQUIRE(problem.results()[0].own.size() == 2);
        OwnRecords<Counting::History> read([&] {
            ContactHistory history;
            history.push({});
            history.push_own(problem.results()[0].own);
            return history;
        }());
        CHECK(read.past()[0].steps == 1);
    }
}

TEST_CASE("What a law that keeps no account takes is lost, not missing", "[dynamics]") {
    RelativeMotion motion{Vec3(1, 2, -3), Vec3(0.5, 0, 4)};
    ContactGeometry geometry;
    ContactForce law;
    law.force = Vec3(-0.2, 0.1, 5);
    law.moment = Vec3(0, 0, -0.1);
    account_as_lost(geometry, motion, law);
    CHECK(law.power.normal == Approx(15));
    CHECK(law.power.normal + law.power.tangential ==
          Approx(-law.force.dot(motion.velocity) - law.moment.dot(motion.spin)));
}
