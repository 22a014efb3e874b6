#pragma once

#include <array>
#include <vector>

#include <scree/contact/history.hpp>
#include <scree/contact/motion.hpp>
#include <scree/dynamics/body.hpp>

namespace scree {

/// A body at the end of a trial step.
struct TrialBody {
    Pose pose;                              ///< of the body frame
    Vec3 velocity = Vec3::Zero();           ///< of the mass centre [m/s]
    Vec3 spin = Vec3::Zero();               ///< ω [rad/s], world axes
    Vec3 surface_velocity = Vec3::Zero();   ///< [m/s], of its surface against the body, as a conveyor has it
    Mat3 turn_rate = Mat3::Zero();          ///< turn of the body [rad] per change of ω
    std::array<Quat, highest_order> turns;  ///< its turn since each past time, the latest first
};

/// What the past contributes to a body's new state: Σ past[j] y_{n−j}.
struct BodyStart {
    Vec3 position = Vec3::Zero();                           ///< [m]
    Eigen::Vector4d orientation = Eigen::Vector4d::Zero();  ///< x, y, z, w; not unit
    Vec3 momentum = Vec3::Zero();                           ///< [kg m/s]; prescribed: velocity [m/s]
    Vec3 angular_momentum = Vec3::Zero();                   ///< [kg m²/s]; prescribed: ω [rad/s]
    std::array<Quat, highest_order> past_orientations;      ///< the latest first
};

/// The linear formulas of one trial step.
struct StepFormulas {
    std::size_t order = 1;                                                ///< of the bodies' formula
    double time = 0;                                                      ///< [s], at the step's end
    double step = 0;                                                      ///< [s]
    double beta_h = 0;                                                    ///< [s], of the bodies' formula
    std::array<std::array<double, highest_order>, highest_order> past{};  ///< [order − 1][j]
    std::array<double, highest_order> friction_beta_h{};                  ///< [order − 1]
    double friction_cap = std::numeric_limits<double>::infinity();        ///< κ of FrictionStep

    /// For a contact that remembers `age` steps.
    [[nodiscard]] StepFormula friction(std::size_t age) const;
};

/// The pose that follows from velocities: x = x_start + βh v, and q ∝ (1 + ½βh ω) ∘ q_start, which is the
/// formula on the four components solved for q and normalised.
void place(const BodyStart& start, const StepFormulas& formulas, TrialBody& body);

/// Of a prescribed body: from its last pose straight on and turning steadily, whatever it did before.
void place_prescribed(const BodyState& last, const BodyStart& start, const StepFormulas& formulas,
                      TrialBody& body);

/// Moves a prescribed body without a path for a time [s]: straight on and turning steadily.
void advance_prescribed(double step, BodyState& state);

/// Of a body that follows a path: where that is at the step's end.
void place_on_path(const PrescribedPath& path, const BodyStart& start, const StepFormulas& formulas,
                   TrialBody& body);

}  // namespace scree
