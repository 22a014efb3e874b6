#pragma once

#include <memory>
#include <vector>

#include <scree/contact/law.hpp>
#include <scree/dynamics/body.hpp>
#include <scree/overlap/pair_geometry.hpp>

namespace scree {

/// A convex part of a body.
struct Collider {
    int body = 0;                  ///< its number in the system
    const Shape* shape = nullptr;  ///< kept alive by the owner of the collider
    Pose local;                    ///< of the shape, in the body's frame
};

/// A pair of colliders that may touch, and what it remembers. By convention a.body < b.body.
struct Contact {
    Collider a;                                              ///< the collider on which forces are given
    Collider b;                                              ///< the other, with the opposite force
    PairConstants pair;                                      ///< constants, fixed for the pair's life
    ContactHistory history;                                  ///< of accepted steps
    std::shared_ptr<const PairGeometry> geometry = nullptr;  ///< null: the overlap of the two shapes
};

/// What a contact does at the present trial, and the derivatives of it when they were asked for.
struct ContactResult {
    bool touching = false;         ///< the shapes overlap
    ContactForce law;              ///< what the law answered
    Vec3 moment_a = Vec3::Zero();  ///< on A about its mass centre [N m]
    Vec3 moment_b = Vec3::Zero();  ///< on B about its mass centre [N m]
    Mat39 moment_a_rate,           ///< by the nine unknowns of MotionRates
        moment_b_rate;             ///< likewise
    Vec3 point = Vec3::Zero();     ///< the centroid [m], world frame
    Vec3 normal = Vec3::UnitZ();   ///< n, unit, the direction of the force on A; world axes
    double volume = 0;             ///< V [m³]
    double area = 0;               ///< ‖S‖ [m²]
    double depth = 0;              ///< δ [m]
    double slip_speed = 0;         ///< ‖v_t‖ [m/s]
    bool centre_line = false;      ///< the normal is the line of centres
    std::vector<double> own;       ///< the trial record of a law with a history of its own
};
/// All but the derivatives.
void visit_state(auto& with, StateOf<ContactResult> auto& result) {
    auto& [touching, law, moment_a, moment_b, moment_a_rate, moment_b_rate, point, normal, volume, area,
           depth, slip_speed, centre_line, own] = result;
    with(touching, law, moment_a, moment_b, point, normal, volume, area, depth, slip_speed, centre_line, own);
}

}  // namespace scree
