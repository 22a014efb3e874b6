#include <catch2/catch.hpp>

#include <scree/dynamics/trial.hpp>

#include <tests/support/finite_difference.hpp>
#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;
using Eigen::VectorXd;

namespace {

StepFormulas first_order(double h) {
    StepFormulas formulas;
    formulas.step = formulas.beta_h = h;
    formulas.past[0][0] = 1;
    formulas.friction_beta_h[0] = h;
    return formulas;
}

BodyStart random_start(Random& random) {
    BodyStart start;
    start.position = random.vector();
    start.orientation = random.rotation().coeffs();
    start.past_orientations.fill(Quat::Identity());
    start.past_orientations[0] = Quat(start.orientation);
    return start;
}

}  // namespace

TEST_CASE("A trial pose solves its formula: x = x_start + βh v, q − βh ½ ω∘q ∝ q_start", "[dynamics]") {
    Random random(221);
    for (int i = 0; i < 50; ++i) {
        const StepFormulas formulas = first_order(random.uniform(0.01, 0.5));
        const BodyStart start = random_start(random);
        TrialBody body;
        body.velocity = random.vector();
        body.spin = random.vector();
        place(start, formulas, body);
        CHECK((body.pose.position - start.position - formulas.beta_h * body.velocity).norm() < 1e-15);
        CHECK(body.pose.orientation.norm() == Approx(1).epsilon(1e-15));
        // (1 − ½βh ω) ∘ q is along q_start, for (1 − a)(1 + a) is a number when a has no real part.
        const Vec3 half = -0.5 * formulas.beta_h * body.spin;
        const Quat back = Quat(1, half.x(), half.y(), half.z()) * body.pose.orientation;
        CHECK((back.coeffs().normalized() - start.orientation).norm() < 1e-15);
    }
}

TEST_CASE("turn_rate is the turn of the body per change of ω", "[dynamics]") {
    Random random(222);
    const StepFormulas formulas = first_order(0.3);
    for (int i = 0; i < 20; ++i) {
        const BodyStart start = random_start(random);
        TrialBody body;
        body.spin = 3 * random.vector();
        place(start, formulas, body);
        const Quat here = body.pose.orientation;
        const auto f = [&](const VectorXd& spin) -> VectorXd {
            TrialBody other;
            other.spin = spin;
            place(start, formulas, other);
            return 2 * (other.pose.orientation * here.conjugate()).vec();
        };
        CHECK(jacobian_error(f, body.spin, body.turn_rate) < 1e-9);
    }
}

TEST_CASE("The turns since the past are the shorter way round, the latest first", "[dynamics]") {
    StepFormulas formulas = first_order(0.1);
    formulas.order = 2;
    BodyStart start;
    const Quat last = turned(0.3, Vec3::UnitZ());
    const Quat early = turned(0.1, Vec3::UnitZ());
    start.orientation = -last.coeffs();  // the other side of the sphere
    start.past_orientations[0] = last;
    start.past_orientations[1] = early;
    TrialBody body;
    place(start, formulas, body);
    CHECK(body.turns[0].isApprox(Quat::Identity(), 1e-15));
    CHECK(body.turns[1].isApprox(turned(0.2, Vec3::UnitZ()), 1e-15));
    CHECK(body.turns[0].w() > 0);
}

TEST_CASE("A prescribed body goes straight on and turns steadily by its own step", "[dynamics]") {
    StepFormulas formulas = first_order(0.2);
    formulas.order = 2;
    formulas.beta_h = 0.2 * 2 / 3;
    BodyState last;
    last.position = {1, 2, 3};
    last.orientation = turned(0.4, {1, 1, 0});
    BodyStart start;
    start.past_orientations.fill(last.orientation);
    TrialBody body;
    body.velocity = {1, 0, -1};
    body.spin = {0, 0, 3};
    place_prescribed(last, start, formulas, body);
    CHECK((body.pose.position - Vec3(1.2, 2, 2.8)).norm() < 1e-15);
    CHECK(body.pose.orientation.isApprox(turned(0.6, Vec3::UnitZ()) * last.orientation, 1e-14));
    CHECK(body.turns[0].isApprox(turned(0.6, Vec3::UnitZ()), 1e-14));
    body.spin.setZero();
    place_prescribed(last, start, formulas, body);
    CHECK(body.pose.orientation.isApprox(last.orientation, 1e-15));
}

TEST_CASE("A young contact takes the formula of its own age", "[dynamics]") {
    StepFormulas formulas;
    formulas.order = 2;
    formulas.past[0] = {1};
    formulas.past[1] = {4.0 / 3, -1.0 / 3};
    formulas.friction_beta_h = {0.1, 0.2 / 3};
    for (const std::size_t age : {0, 1}) {
        CHECK(formulas.friction(age).past.size() == 1);
        CHECK(formulas.friction(age).beta_h == 0.1);
    }
    for (const std::size_t age : {2, 5}) {
        CHECK(formulas.friction(age).past.size() == 2);
        CHECK(formulas.friction(age).past[1] == -1.0 / 3);
        CHECK(formulas.friction(age).beta_h == 0.2 / 3);
    }
}
