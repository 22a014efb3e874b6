#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The speed after a central impact over the speed before, by the law itself: x is the depth, integrated by
// the classical Runge–Kutta method until the force has gone. The volume grows with the depth to a power: 1
// for a face, whose area the case has, 2 for an edge or a ball, 3 for a corner.
double restitution(ContactCase c, double mass, double speed, int steps_a_period, int power = 1) {
    const double area = c.geometry.area;
    const double reach = 1e-3;  // depth [m] at which the patch has that area
    const auto acceleration = [&](double depth, double rate) {
        const double share = std::pow(std::max(depth, 0.0) / reach, power - 1);
        c.geometry.volume = area * share * std::max(depth, 0.0) / power;
        c.geometry.area = area * share;
        c.geometry.area_vector = -c.geometry.area * Vec3::UnitZ();
        c.motion.velocity = {0, 0, -rate};
        return -c.force().normal_force / mass;
    };
    const double period = 2 * std::numbers::pi * std::sqrt(mass / (c.pair.elastic * area));
    const double h = period / steps_a_period;
    double x = 0;
    double v = speed;
    while (true) {
        const double a1 = acceleration(x, v);
        if (a1 == 0 && v <= 0) {
            return -v / speed;
        }
        const double a2 = acceleration(x + h / 2 * v, v + h / 2 * a1);
        const double a3 = acceleration(x + h / 2 * v + h * h / 4 * a1, v + h / 2 * a2);
        const double a4 = acceleration(x + h * v + h * h / 2 * a2, v + h * a3);
        x += h * v + h * h / 6 * (a1 + a2 + a3);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
}

ContactCase face_with_damping_ratio(double ratio) {
    ContactCase c;
    const BodySize body{2, 0.06};
    const double length = characteristic_length(body, {});
    c.pair = pair_constants({1e7, 0, 2 * length * ratio / std::sqrt(c.geometry.area), 0.5, 2.0 / 7, true},
                            body, {});
    return c;
}

}  // namespace

TEST_CASE("Eq. (5.7): a face's restitution is the damped oscillator's with the tension cut off",
          "[contact]") {
    const std::pair<double, double> known[] = {
        {0.05, 0.858758}, {0.2, 0.571740}, {0.5, 0.298436}, {0.8, 0.179783}};
    for (const auto& [ratio, expected] : known) {
        // The closed form behind the digits: release where k x + c v = 0.
        const double root = std::sqrt(1 - ratio * ratio);
        const double phase = std::atan2(2 * ratio * root, 2 * ratio * ratio - 1);
        CHECK(std::exp(-ratio / root * phase) == Approx(expected).margin(5e-7));
        // The kink at release leaves an error of second order in the step.
        const double e = restitution(face_with_damping_ratio(ratio), 2, 0.3, 4000);
        CHECK(e == Approx(expected).margin(1e-6));
    }
}

TEST_CASE("Eq. (5.7): without damping the speed comes back, whatever it was", "[contact]") {
    for (const double speed : {1e-3, 0.3, 10.0}) {
        CHECK(restitution(face_with_damping_ratio(0), 2, speed, 4000) == Approx(1).margin(1e-6));
    }
}

TEST_CASE("With damping by the patch the restitution is the same at any size of the face", "[contact]") {
    for (const double area : {1e-6, 1e-2, 0.3}) {
        ContactCase c;
        c.options.normal_damping = NormalDamping::patch;
        c.pair = pair_constants({1e7, 0, 2 * 0.2, 0.5, 2.0 / 7, true}, {2, 0.06}, {});
        c.geometry.area = area;
        CHECK(restitution(c, 2, 0.3, 4000) == Approx(0.571740).margin(1e-6));
    }
}

TEST_CASE("With damping by the patch edges, balls and corners have the restitution of ζ √(2p/(p+1)), V ~ δ^p",
          "[contact]") {
    // With u = δ^((p+1)/2) and dτ = δ^((p−1)/2) dt the impact is a linear oscillator's, whatever the speed.
    for (const int power : {1, 2, 3}) {
        for (const double speed : {0.01, 1.0}) {
            CAPTURE(power, speed);
            ContactCase c;
            c.options.normal_damping = NormalDamping::patch;
            c.pair = pair_constants({1e7, 0, 2 * 0.3, 0.5, 2.0 / 7, true}, {2, 0.06}, {});
            const double ratio = 0.3 * std::sqrt(2.0 * power / (power + 1));
            const double root = std::sqrt(1 - ratio * ratio);
            const double phase = std::atan2(2 * ratio * root, 2 * ratio * ratio - 1);
            const double expected = std::exp(-ratio / root * phase);
            CHECK(restitution(c, 2, speed, 40000, power) == Approx(expected).margin(1e-4));
        }
    }
    // By Eq. (5.7) as it is, a corner's damping vanishes with its patch.
    ContactCase corner;
    corner.pair = pair_constants({1e7, 0, 2 * 0.3, 0.5, 2.0 / 7, true}, {2, 0.06}, {});
    CHECK(restitution(corner, 2, 1e-4, 4000, 3) > 0.98);
}
