#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/order.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;

ContactCase with_stiffness(TangentialStiffness kind) {
    ContactCase c;
    c.options.tangential_stiffness = kind;
    return c;
}

// The same contact on a patch so many times as large; n and V stay.
void scale_patch(ContactCase& c, double factor) {
    c.geometry.area *= factor;
    c.geometry.area_vector *= factor;
}

}  // namespace

TEST_CASE("Eq. (5.18): without length the spring has Yt times one metre, Lc of a body of one metre alone",
          "[contact]") {
    for (const double radius : {5e-4, 0.05, 0.5}) {
        ContactCase c = with_stiffness(TangentialStiffness::no_length);
        c.pair = pair_constants({1e7, 0.5, 0.5, 0.5, 2.0 / 7, true}, {2, radius}, {});
        c.motion.velocity = {1e-9, 0, 0};
        const double stored = 2.0 / 7 * 1e7 * c.beta_h * 1e-9;
        CHECK(c.force().trial.force.x() == Approx(-stored).epsilon(rounding));
        // The damping, Eq. (5.21), has Lc in either case.
        ContactCase with_length = c;
        with_length.options.tangential_stiffness = TangentialStiffness::length;
        const double damping = c.force().force.x() + stored;
        const double other = with_length.force().force.x() - with_length.force().trial.force.x();
        CHECK(damping == Approx(other).epsilon(1e-9));
        CHECK(with_length.force().trial.force.x() == Approx(-stored * 2 * radius).epsilon(rounding));
    }
}

TEST_CASE("A patch's spring has (Yt/Lc) ‖S‖ and its damper γt √(kt M_red)", "[contact]") {
    for (const double factor : {1e-6, 0.3, 1.0, 4.0}) {
        ContactCase c = with_stiffness(TangentialStiffness::patch);
        scale_patch(c, factor);
        c.motion.velocity = {1e-8, 0, 0};
        const double stiffness = 2.0 / 7 * c.pair.elastic * c.geometry.area;
        const double damping = 0.5 * std::sqrt(stiffness * c.pair.reduced_mass);
        const ContactForce out = c.force();
        CHECK(out.trial.stiffness == Approx(stiffness).epsilon(rounding));
        CHECK(out.trial.force.x() == Approx(-stiffness * c.beta_h * 1e-8).epsilon(rounding));
        CHECK(out.force.x() == Approx(-(stiffness * c.beta_h + damping) * 1e-8).epsilon(rounding));
        CHECK(out.tangential_energy ==
              Approx(0.5 * out.trial.force.squaredNorm() / stiffness).epsilon(rounding));
    }
    // On a face both springs have the ratio Yt/Y of the stiffnesses, whatever the size of the body.
    ContactCase face = with_stiffness(TangentialStiffness::patch);
    CHECK(face.patch_stiffness() == Approx(2.0 / 7 * face.pair.elastic * face.geometry.area));
}

TEST_CASE("A stored force shrinks with its patch, and does not grow with it", "[contact]") {
    for (const double factor : {1e-3, 0.5, 0.999, 1.0, 1.5, 100.0}) {
        ContactCase c = with_stiffness(TangentialStiffness::patch);
        c.history.push({{1, 0.5, 0.2}, Vec3::UnitZ(), c.patch_stiffness()});
        const double energy = c.force().tangential_energy;
        scale_patch(c, factor);
        const ContactForce out = c.force();
        CHECK(deviation(out.trial.force, std::min(1.0, factor) * Vec3(1, 0.5, 0.2), 1) < rounding);
        CHECK(out.tangential_energy == Approx(energy * std::min(factor, 1 / factor)).epsilon(rounding));
    }
}

TEST_CASE("Through a patch that grew and shrank before, an old record keeps its smallest share",
          "[contact]") {
    ContactCase c = with_stiffness(TangentialStiffness::patch);
    const double now = c.patch_stiffness();
    const double stiffness[] = {0.5 * now, 2 * now, 0.8 * now};  // oldest first
    const double force[] = {1, 10, 100};
    for (int i = 0; i < 3; ++i) {
        c.history.push({force[i] * Vec3::UnitX(), Vec3::UnitZ(), stiffness[i]});
    }
    c.pair.friction = 1e9;
    c.order = 3;
    c.past = {1, 0.1, 0.01};
    // 1 → grew to 2, fell to 0.8 of its share: 0.4; 10 → fell from 2 to 0.8: 0.4; 100 → grew: all of it.
    CHECK(c.force().trial.force.x() == Approx(100 + 0.1 * 0.4 * 10 + 0.01 * 0.4).epsilon(rounding));
}

TEST_CASE("No energy is made by a patch that grows and shrinks while its spring is pulled to and fro",
          "[contact]") {
    Random random(181);
    ContactCase c = with_stiffness(TangentialStiffness::patch);
    c.pair.tangential_damping = 0;
    c.pair.friction = 1e9;  // nothing slips
    const double speed = 1e-5;
    double stored = 0;
    double taken = 0;
    for (int i = 0; i < 3000; ++i) {
        scale_patch(c, std::exp(random.uniform(-1, 1)) * (c.geometry.area > 0.01 ? 0.8 : 1.25));
        c.motion.velocity = speed * random.vector();
        c.motion.spin = speed / c.geometry.lever * random.vector();
        const ContactForce out = c.force();
        const double work = c.beta_h * (out.power.tangential + out.power.torsion);
        const double energy = out.tangential_energy + out.torsional_energy;
        CHECK(energy - stored <= work + 1e-12 * (std::abs(work) + stored));
        stored = energy;
        taken += work;
        c.history.push(out.trial);
    }
    CHECK(taken > stored);
    CHECK(stored > 0);
}

TEST_CASE("The patch's spring is advanced to the order of the formula, growing and shrinking", "[contact]") {
    // k = k₀ (1 + sin t) up to its peak and down again; v steady. Growing: f = −v ∫ k dt; shrinking: f/k
    // grows by −v dt.
    const double rate = 1000;  // of t, per second
    const double start = 0.2;
    const double whole = 2.5;
    const double speed = 1e-6;
    const auto error_after = [&](int steps, std::size_t order) {
        ContactCase c = with_stiffness(TangentialStiffness::patch);
        c.pair.tangential_damping = 0;
        c.pair.friction = 1e9;
        const double area = c.geometry.area;
        const double h = (whole - start) / steps;  // of t
        c.motion.velocity = {speed, 0, 0};
        const double full = c.patch_stiffness();
        const auto grown = [&](double t) {
            return -speed / rate * full * (t - start + std::cos(start) - std::cos(t));
        };
        const double peak = std::numbers::pi / 2;
        const auto exact = [&](double t) {
            const double stiffness = full * (1 + std::sin(t));
            return t < peak ? grown(t) : stiffness * (grown(peak) / (2 * full) - speed / rate * (t - peak));
        };
        for (const double t : {start - h, start}) {
            c.history.push({{grown(t), 0, 0}, Vec3::UnitZ(), full * (1 + std::sin(t))});
        }
        c.order = order;
        c.past = order == 1 ? std::array<double, 5>{1} : std::array<double, 5>{4.0 / 3, -1.0 / 3};
        c.beta_h = (order == 1 ? h : 2 * h / 3) / rate;
        for (int i = 1; i <= steps; ++i) {
            scale_patch(c, area * (1 + std::sin(start + i * h)) / c.geometry.area);
            c.history.push(c.force().trial);
        }
        return std::abs(c.history.past[0].force.x() / exact(whole) - 1);
    };
    for (const std::size_t order : {1, 2}) {
        std::vector<double> errors;
        for (int steps = 50; steps <= 800; steps *= 2) {
            errors.push_back(error_after(steps, order));
        }
        CHECK(observed_order(errors) == Approx(order).margin(0.15));
    }
}
