#include <catch2/catch.hpp>

#include <tests/dynamics/residual_error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double h = 1e-3;
constexpr double depth = 2e-3;

// Some axes held, some let through in part, some free, and damping.
Restraint random_restraint(Random& random) {
    Restraint restraint;
    for (int axis = 0; axis < 3; ++axis) {
        const auto share = [&] {
            const double draw = random.uniform(0, 3);
            return draw < 1 ? 0 : (draw < 2 ? 1 : random.uniform(0.1, 0.9));
        };
        restraint.along[axis] = share();
        restraint.around[axis] = share();
    }
    restraint.slowing = random.uniform(0, 1) / h;
    restraint.turning_down = random.uniform(0, 1) / h;
    return restraint;
}

}  // namespace

TEST_CASE("The residual's Jacobian agrees with differences for bodies that are held back", "[dynamics]") {
    Random random(311);
    const std::size_t order = GENERATE(1, 2);
    const auto shapes = GENERATE(std::pair<Shape, Shape>(Sphere{0.1}, Sphere{0.07}),
                                 std::pair<Shape, Shape>(make_box({0.2, 0.2, 0.2}), Sphere{0.07}));
    for (int i = 0; i < 40; ++i) {
        StepCase step;
        const Restraint one = random_restraint(random);
        const Restraint other = random_restraint(random);
        const double speed = 0.2 * depth / h;
        step.add_body(shapes.first, {Vec3(0.01, 0.02, 0), Quat::Identity()}, speed * random.vector(),
                      10 * speed * random.vector());
        step.add_body(shapes.second, {Vec3(0, 0, 0.17 - depth), random.rotation()}, speed * random.vector(),
                      10 * speed * random.vector());
        step.system.bodies[0].restraint = &one;
        step.system.bodies[1].restraint = &other;
        step.add_contact(0, 1);
        ForcesOf<WholeDerivativeLaw<>> forces({{}, 0.03});
        CHECK(residual_error(step, forces, h, order, depth, 0.1).error < 1e-8);
    }
}

TEST_CASE("A torque acts about the free axes alone, and what holds the others does no work", "[dynamics]") {
    Random random(312);
    for (int i = 0; i < 20; ++i) {
        Restraint restraint;
        restraint.around = Vec3(0, 1, 1);
        const Mat3 turn = random.rotation().toRotationMatrix();
        const Mat3 inertia = turn * Vec3(1, 2, 3).asDiagonal() * turn.transpose();
        Vec3 spin = random.vector();
        spin.x() = 0;
        const Vec3 torque = random.vector();
        const Vec3 change = restrained_torque(restraint, torque, inertia, spin);
        CHECK(change.y() == Approx(torque.y()));
        CHECK(change.z() == Approx(torque.z()));
        // ω̇ about the held axis vanishes: L̇ = Iω̇ + ω×L.
        const Vec3 faster = inertia.inverse() * (change - spin.cross(inertia * spin));
        CHECK(std::abs(faster.x()) < 1e-12);
        CHECK((change - torque).dot(spin) == Approx(0).margin(1e-12));
    }
}
