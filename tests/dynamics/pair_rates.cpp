#include <catch2/catch.hpp>

#include <tests/support/finite_difference.hpp>
#include <tests/support/step_case.hpp>

using namespace scree;
using namespace scree::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double h = 1e-3;

// What a law sees of two bodies at their nine unknowns, as rows.
struct Sight {
    StepFormulas formulas;
    BodyStart start_a, start_b;
    TrialBody a, b;
    Contact contact;
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    PairArms arms;
    RelativeMotion motion;

    bool look(const VectorXd& x, Detail detail) {
        a.velocity = x.head<3>();
        a.spin = x.segment<3>(3);
        b.velocity.setZero();
        b.spin = x.tail<3>();
        place(start_a, formulas, a);
        place(start_b, formulas, b);
        const bool touching = locate(contact, a, b, detail, workspace, geometry, arms);
        motion = relative_motion(a, b, arms);
        return touching;
    }
};

BodyStart at_rest(const Pose& pose) {
    BodyStart start;
    start.position = pose.position;
    start.orientation = pose.orientation.coeffs();
    start.past_orientations.fill(Quat::Identity());
    start.past_orientations[0] = pose.orientation;
    return start;
}

// The turn from one orientation to a near one.
Vec3 turn_between(const Quat& from, const Quat& to) {
    const Quat turn = to * from.conjugate();
    return 2 * (turn.w() < 0 ? -1 : 1) *
           turn.vec();  // second order in the turn: an even part differences drop
}

}  // namespace

TEST_CASE("The rates of all that a law sees agree with differences, compound bodies included", "[dynamics]") {
    Random random(211);
    double worst = 0;
    int seen = 0;
    for (int i = 0; i < 160; ++i) {
        const Shape shapes[] = {random.polyhedron(12, 0.1), random.polyhedron(12, 0.1)};
        Sight sight;
        sight.formulas.step = sight.formulas.beta_h = h;
        sight.formulas.past[0][0] = 1;
        // Parts that sit off their bodies' mass centres and are turned in them.
        sight.contact.a = {0, &shapes[0], {0.1 * random.vector(), random.rotation()}};
        sight.contact.b = {1, &shapes[1], {0.1 * random.vector(), random.rotation()}};
        const Pose part_a{random.vector(), random.rotation()};
        const Pose part_b{part_a.position + 0.13 * random.direction(), random.rotation()};
        sight.start_a = at_rest(part_a * sight.contact.a.local.inverse());
        sight.start_b = at_rest(part_b * sight.contact.b.local.inverse());
        VectorXd x(9);
        x << 0.5 * random.vector(), 10 * random.vector(), 10 * random.vector();

        if (!sight.look(x, Detail::derivative) || sight.geometry.volume < 1e-6) {
            continue;
        }
        MotionRates rates;
        motion_rates(sight.geometry, sight.motion, sight.a, sight.b, sight.arms, h, rates);
        const Quat turned_a = sight.a.pose.orientation;
        const Quat turned_b = sight.b.pose.orientation;
        VectorXd scale(9);
        scale << Vec3::Constant(1), Vec3::Constant(10), Vec3::Constant(10);  // 1 mm, at 10 cm

        const auto error_of = [&](const auto& value, const auto& rate, double least) {
            // A row of its own stands in for rates that vanish, as the normal's on a single face.
            MatrixXd jacobian = MatrixXd::Zero(rate.rows() + 1, 9);
            jacobian.topRows(rate.rows()) = rate;
            jacobian(rate.rows(), 0) = least;
            const auto f = [&](const VectorXd& moved) -> VectorXd {
                sight.look(moved, Detail::force);
                VectorXd rows(rate.rows() + 1);
                rows << value(), least * moved(0);
                return rows;
            };
            worst = std::max(worst, jacobian_error(f, x, jacobian, scale));
        };
        error_of([&] { return VectorXd::Constant(1, sight.geometry.volume); }, rates.volume, 0);
        error_of([&] { return VectorXd::Constant(1, volume_rate(sight.geometry, sight.motion)); },
                 rates.volume_rate, 0);
        error_of([&] { return sight.geometry.normal; }, rates.normal, 1e-2);
        error_of([&] { return sight.motion.velocity; }, rates.velocity, 0);
        error_of([&] { return sight.motion.spin; }, rates.spin, 0);
        error_of([&] { return sight.arms.a; }, rates.arm_a, 0);
        error_of([&] { return sight.arms.b; }, rates.arm_b, 0);
        error_of([&] { return turn_between(turned_a, sight.a.pose.orientation); }, rates.turn_a, 0);
        error_of([&] { return turn_between(turned_b, sight.b.pose.orientation); }, rates.turn_b, 0);
        ++seen;
    }
    CHECK(seen > 20);
    CHECK(worst < 1e-8);
}

TEST_CASE("The relative motion is that of A's material at the centroid against B's", "[dynamics]") {
    TrialBody a;
    TrialBody b;
    a.velocity = {1, 2, 3};
    a.spin = {0, 0, 2};
    b.velocity = {0, 1, 0};
    b.spin = {1, 0, 0};
    const RelativeMotion motion = relative_motion(a, b, {Vec3(1, 0, 0), Vec3(0, 1, 0)});
    CHECK(motion.velocity == Vec3(1, 3, 2));
    CHECK(motion.spin == Vec3(-1, 0, 2));
}
