#include <scree/dynamics/restraint.hpp>

#include <cmath>

namespace scree {

namespace {

// x with (inertia · x) = free about the free axes and x = held about the others.
Vec3 mixed_solution(const Restraint& restraint, const Mat3& inertia, const Vec3& free, const Vec3& held) {
    Mat3 matrix = inertia;
    Vec3 right = free;
    const double scale = inertia.trace();
    for (int axis = 0; axis < 3; ++axis) {
        if (restraint.held(axis)) {
            matrix.row(axis) = scale * Vec3::Unit(axis).transpose();
            right[axis] = scale * held[axis];
        }
    }
    return matrix.inverse() * right;
}

}  // namespace

Vec3 restrained_force(const Restraint& restraint, const Vec3& force, const Vec3& momentum) {
    return restraint.along.cwiseProduct(force) - restraint.slowing * momentum;
}

// L = Iω gives L̇ = Iω̇ + ω×L.
Vec3 restrained_torque(const Restraint& restraint, const Vec3& torque, const Mat3& inertia,
                       const Vec3& spin) {
    const Vec3 momentum = inertia * spin;
    const Vec3 free = restraint.around.cwiseProduct(torque) - restraint.turning_down * momentum;
    if (!restraint.holds_spin()) {
        return free;
    }
    const Vec3 turning = spin.cross(momentum);
    const Vec3 change = mixed_solution(restraint, inertia, free - turning, -restraint.turning_down * spin);
    return inertia * change + turning;
}

Vec3 restrained_momentum(const Restraint& restraint, const Vec3& momentum, const Mat3& inertia,
                         const Vec3& spin) {
    return inertia * mixed_solution(restraint, inertia, momentum, spin);
}

Vec3 spin_after(const Restraint& restraint, const Vec3& spin, double time) {
    return std::exp(-restraint.turning_down * time) * spin;
}

}  // namespace scree
