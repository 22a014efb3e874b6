#pragma once

#include <limits>
#include <span>

#include <scree/overlap/contact_geometry.hpp>

namespace scree {

using Row6 = Eigen::Matrix<double, 1, 6>;   ///< of a number by a motion (u, θ)
using Row9 = Eigen::Matrix<double, 1, 9>;   ///< of a number by the nine unknowns of MotionRates
using Mat39 = Eigen::Matrix<double, 3, 9>;  ///< of a vector by the nine unknowns
using Mat69 = Eigen::Matrix<double, 6, 9>;  ///< of a motion (u, θ) by the nine unknowns

/// How the bodies move at the contact, A against B.
struct RelativeMotion {
    Vec3 velocity = Vec3::Zero();  ///< [m/s], of A's material at the centroid less that of B's
    Vec3 spin = Vec3::Zero();      ///< [rad/s], ω_A − ω_B
};

/// Where a contact sits between its two bodies.
struct PairArms {
    Vec3 a = Vec3::Zero();            ///< centroid less A's mass centre [m]
    Vec3 b = Vec3::Zero();            ///< centroid less B's mass centre [m]
    Quat frame_a = Quat::Identity();  ///< A's principal axes
    Quat frame_b = Quat::Identity();  ///< B's principal axes
};

/// Derivatives of what a law sees by the nine unknowns of a pair: the change of v_A − v_B at the mass
/// centres, of ω_A and of ω_B, poses following as the time step has it.
struct MotionRates {
    Mat69 xi;          ///< the motion of A against B that ContactGeometry's derivatives are by
    Row9 volume;       ///< of V
    Row9 volume_rate;  ///< of V̇
    Mat39 normal;      ///< of n
    Mat39 velocity;    ///< of RelativeMotion::velocity
    Mat39 spin;        ///< of RelativeMotion::spin
    Mat39 turn_a;      ///< the turn of A that goes with it [rad]
    Mat39 turn_b;      ///< the turn of B [rad]
    Mat39 arm_a;       ///< of the centroid less A's mass centre
    Mat39 arm_b;       ///< of the centroid less B's mass centre
};

/// The linear formula that closes a step: y = Σ past[j] y_{n−j} + beta_h ẏ.
struct StepFormula {
    std::span<const double> past;  ///< as many as the order
    double beta_h = 0;             ///< [s]
};

/// How a contact's friction is advanced over the present trial step.
struct FrictionStep {
    StepFormula formula;           ///< of the order that the contact's age allows
    std::span<const Quat> turn_a;  ///< A's turn since each past time, the latest first
    std::span<const Quat> turn_b;  ///< B's, likewise
    /// κ: tangential stiffness at most κ M_red/(βh)², damping at most κ M_red/(βh). Infinite: the law as it
    /// is.
    double cap = std::numeric_limits<double>::infinity();
};

}  // namespace scree
