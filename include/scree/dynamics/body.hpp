#pragma once

#include <limits>

#include <scree/contact/material.hpp>
#include <scree/dynamics/prescribed_path.hpp>
#include <scree/dynamics/restraint.hpp>
#include <scree/mesh/saved_state.hpp>

namespace scree {

/// Whether a body may be left standing, with the group in which it is.
enum class Rest {
    by_option,     ///< when the group is at rest and the method's options say so
    wanted,        ///< when the group is at rest, whatever the options say
    never,         ///< it keeps its group awake
    from_outside,  ///< at once, if all of its group are to: what moves stops where it is
};

/// What does not change while a body moves. Its frame has the mass centre as origin and principal axes.
struct Body {
    double mass = std::numeric_limits<double>::infinity();  ///< [kg]; infinite: moves as prescribed
    Vec3 inertia = Vec3::Zero();                            ///< principal moments [kg m²]
    double radius = 0;                                      ///< ℓ [m], of the sphere of the body's volume
    Vec3 weight = Vec3::Zero();                             ///< [N]; world axes
    Vec3 force = Vec3::Zero();   ///< [N] from outside besides the weight, held for a tick; world axes
    Vec3 torque = Vec3::Zero();  ///< [N m] from outside, about the mass centre; world axes
    /// Of a body of infinite mass; null: straight on and turning steadily, by the velocities of its state.
    /// Kept alive by the owner of the body.
    const PrescribedPath* path = nullptr;
    /// Null: forces and torques have their full way. Kept alive by the owner of the body.
    const Restraint* restraint = nullptr;
    Rest rest = Rest::by_option;  ///< whether it may be left standing

    /// Whether forces move it.
    [[nodiscard]] bool dynamic() const { return mass < std::numeric_limits<double>::infinity(); }
};
/// What acts on it; the body itself is the same.
void visit_state(auto& with, StateOf<Body> auto& body) {
    auto& [mass, inertia, radius, weight, force, torque, path, restraint, rest] = body;
    with(weight, force, torque);
}

/// What is integrated. A prescribed body has velocities here, in place of momenta.
struct BodyState {
    Vec3 position = Vec3::Zero();          ///< of the mass centre [m]
    Quat orientation = Quat::Identity();   ///< unit
    Vec3 momentum = Vec3::Zero();          ///< p [kg m/s]; prescribed: velocity [m/s]
    Vec3 angular_momentum = Vec3::Zero();  ///< L about the mass centre [kg m²/s]; prescribed: ω [rad/s]
};
void visit_state(auto& with, StateOf<BodyState> auto& state) {
    auto& [position, orientation, momentum, angular_momentum] = state;
    with(position, orientation, momentum, angular_momentum);
}

/// What the constants of its pairs need to know of a body.
BodySize body_size(const Body& body);

/// The inertia tensor [kg m²] in world axes.
Mat3 world_inertia(const Body& body, const Quat& orientation);

Vec3 velocity(const Body& body, const BodyState& state);  ///< [m/s]
Vec3 spin(const Body& body, const BodyState& state);      ///< ω [rad/s], world axes

}  // namespace scree
