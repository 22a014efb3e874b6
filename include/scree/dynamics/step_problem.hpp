#pragma once

#include <utility>
#include <vector>

#include <scree/dynamics/contact_forces.hpp>
#include <scree/dynamics/jacobian.hpp>
#include <scree/dynamics/workers.hpp>

namespace scree {

/// Bodies, their states and the pairs that may touch: what a step starts from.
struct System {
    std::vector<Body> bodies;       ///< what they are
    std::vector<BodyState> states;  ///< where they are, one a body
    std::vector<Contact> contacts;  ///< sorted by body, then by part
};

/// The least time scale [s] of the paths that the system's contacts may meet; infinite without any.
double path_time_scale(const System& system);

/// The nonlinear equations of one implicit step, p(v) − p_start − βh F = 0 and L(ω) − L_start − βh T = 0, in
/// the new velocities u, six numbers (v, ω) a body; positions, orientations and friction follow from them.
class StepProblem {
  public:
    /// `workers` share out the contacts of one evaluation when there are many; null: nobody does.
    StepProblem(const System& system, const ContactForces& forces, Workers* workers = nullptr)
        : system_(system), forces_(forces), workers_(workers) {}

    /// Replaces them from the next evaluation on.
    void set_workers(Workers* workers) { workers_ = workers; }

    /// The formulas of this step and what the past contributes, one start a body.
    void begin(const StepFormulas& formulas, std::vector<BodyStart>& starts);

    /// Limits the tangential stiffness for the evaluations that follow; see FrictionStep.
    void cap_friction(double cap) { formulas_.friction_cap = cap; }

    /// Moves all bodies to where velocities u lead and computes all forces there. Counts one evaluation a
    /// contact.
    void evaluate(const Eigen::VectorXd& u, Detail detail);

    /// Of the last evaluation.
    [[nodiscard]] Detail detail() const { return detail_; }
    /// [kg m/s] and [kg m²/s], six numbers a body, 0 for those that forces do not move.
    [[nodiscard]] const Eigen::VectorXd& residual() const { return residual_; }
    /// Whether a contact opened or closed or changed between stick and slip since the last factorisation.
    [[nodiscard]] bool states_changed() const;

    /// From the last evaluation, which must have been with derivatives. False: singular.
    bool factorize();
    /// x := J⁻¹ x with the last factorisation. False: there is no solution.
    bool solve(Eigen::VectorXd& x);
    /// x := M⁻¹ x with the inertia at the last evaluation, the equations' derivative but for the forces'
    /// part.
    void solve_inertia(Eigen::VectorXd& x) const;

    /// The bodies' states at the last evaluation. A body that nothing touches takes its momenta from the
    /// forces, so that they are kept to rounding; one in contact takes them from its velocities, because the
    /// force carries the solver's residual multiplied by the contact's stiffness.
    void new_states(std::vector<BodyState>& states) const;

    /// Of the present step.
    [[nodiscard]] const StepFormulas& formulas() const { return formulas_; }
    /// Of each contact at the last evaluation.
    [[nodiscard]] std::span<const ContactResult> results() const { return results_; }
    /// The bodies at the last evaluation.
    [[nodiscard]] std::span<const TrialBody> trial() const { return trial_; }
    /// As last assembled.
    [[nodiscard]] const Jacobian& jacobian() const { return jacobian_; }
    /// ṗ [N], forces from outside included.
    [[nodiscard]] const std::vector<Vec3>& forces() const { return force_; }
    /// L̇ [N m].
    [[nodiscard]] const std::vector<Vec3>& torques() const { return torque_; }
    /// What the restraints add to the forces and torques; empty where no body has one.
    struct Hold {
        Vec3 force = Vec3::Zero();   ///< [N]
        Vec3 torque = Vec3::Zero();  ///< [N m]
    };
    /// One a body, or none, at the last evaluation.
    [[nodiscard]] std::span<const Hold> holds() const { return holds_; }
    /// Whether a contact has a force on the body.
    [[nodiscard]] bool touched(std::size_t body) const { return touched_[body]; }

    /// Where the time goes and how often a contact was evaluated, since last taken.
    struct Costs {
        std::size_t evaluations = 0;  ///< of one contact
        double contacts = 0;          ///< wall time [s] of evaluations without derivatives
        double jacobian = 0;          ///< [s] of evaluations with derivatives and of the assembly
        double solve = 0;             ///< [s] of factorisations and their use
    };
    /// Since last taken.
    [[nodiscard]] const Costs& costs() const { return costs_; }
    /// Hands them over and starts them at zero.
    Costs take_costs() { return std::exchange(costs_, {}); }

  private:
    void place_bodies(const Eigen::VectorXd& u);
    void evaluate_contacts();
    void sum_forces();
    void restrain();
    void fill_held_rows(std::size_t body, const Restraint& restraint);
    void fill_residual();

    const System& system_;
    const ContactForces& forces_;
    Workers* workers_;
    StepFormulas formulas_;
    std::vector<BodyStart> starts_;
    std::vector<TrialBody> trial_;
    std::vector<ContactResult> results_;
    std::vector<ContactRegime> factorized_regimes_;
    std::vector<Vec3> force_, torque_;
    std::vector<Hold> holds_;
    std::vector<bool> touched_;  ///< by a contact with a force
    Eigen::VectorXd residual_;
    Jacobian jacobian_;
    Costs costs_;
    Detail detail_ = Detail::force;
};

}  // namespace scree
