#pragma once

#include <scree/mesh/vectors.hpp>

namespace scree {

/// What holds a body back besides forces, by world axis. The body obeys ṗ = along ∘ F − slowing p and, about
/// the axes about which it may turn, L̇ = around ∘ T − turning_down L; about the others ω̇ = −turning_down ω,
/// whatever moment that takes.
struct Restraint {
    Vec3 along = Vec3::Ones();   ///< share of the force that moves the body, from 0 (it does not) to 1
    Vec3 around = Vec3::Ones();  ///< share of the torque that turns it; 0: the spin about that axis is held
    double slowing = 0;          ///< [1/s], of the momentum
    double turning_down = 0;     ///< [1/s], of the angular momentum

    /// The same restraint.
    bool operator==(const Restraint&) const = default;

    /// Whether the spin about a world axis, 0 to 2, is held.
    [[nodiscard]] bool held(int axis) const { return around[axis] == 0; }
    /// Whether any is.
    [[nodiscard]] bool holds_spin() const { return held(0) || held(1) || held(2); }
};

/// ṗ [N] of a body with momentum `momentum` under a force.
Vec3 restrained_force(const Restraint& restraint, const Vec3& force, const Vec3& momentum);

/// L̇ [N m] of a body that spins with ω under a torque; `inertia`: the tensor in world axes.
Vec3 restrained_torque(const Restraint& restraint, const Vec3& torque, const Mat3& inertia, const Vec3& spin);

/// The angular momentum that is `momentum` about the free axes, and whose spin about the held ones is that of
/// `spin`.
Vec3 restrained_momentum(const Restraint& restraint, const Vec3& momentum, const Mat3& inertia,
                         const Vec3& spin);

/// What is left of a held spin after a time [s].
Vec3 spin_after(const Restraint& restraint, const Vec3& spin, double time);

}  // namespace scree
