#pragma once

#include <scree/dynamics/step_problem.hpp>

namespace scree {

/// Energies [J] that are summed over time beside the states.
struct Accumulated {
    double normal_elastic = 0;      ///< into normal elasticity that has no potential
    double normal = 0;              ///< into normal elasticity and damping
    double tangential = 0;          ///< into tangential springs and slip
    double tangential_damping = 0;  ///< lost
    double torsion = 0;             ///< into torsional springs, slip and damping
    double rolling = 0;             ///< into rolling springs, their limit and damping
    double cohesion = 0;            ///< against the pull of cohesion
    double applied = 0;             ///< by applied forces, restraints and prescribed bodies

    /// Adds `factor` times `other`.
    Accumulated& add(double factor, const Accumulated& other);
};
void visit_state(auto& with, StateOf<Accumulated> auto& sums) {
    auto& [normal_elastic, normal, tangential, tangential_damping, torsion, rolling, cohesion, applied] =
        sums;
    with(normal_elastic, normal, tangential, tangential_damping, torsion, rolling, cohesion, applied);
}

/// What has gone through a system over some time.
struct Flows {
    Accumulated energy;                 ///< [J]
    Vec3 momentum_gain = Vec3::Zero();  ///< gained without an impulse from outside [kg m/s]
};

/// The rates of what is accumulated, at the problem's last evaluation [W].
Accumulated accumulation_rates(const System& system, const StepProblem& problem);

/// The sum of all forces on dynamic bodies but those of one dynamic body on another [N], at the last
/// evaluation.
Vec3 outside_force(const System& system, const StepProblem& problem);

/// Where the energy is [J].
struct EnergyLedger {
    double kinetic = 0;                  ///< ½ p·v + ½ L·ω of the dynamic bodies
    double gravity = 0;                  ///< −m g·x, from the world's origin
    double normal_elastic = 0;           ///< in overlaps
    double tangential_elastic = 0;       ///< in the springs of friction
    double torsional_elastic = 0;        ///< in the springs about the normals
    double rolling_elastic = 0;          ///< in the springs against rolling
    double cohesive = 0;                 ///< below 0: what it takes to pull apart what holds together
    double lost_normal_damping = 0;      ///< to the dashpots along the normals
    double lost_tangential_damping = 0;  ///< to the dashpots of friction
    double lost_friction = 0;            ///< to slip
    double lost_torsion = 0;             ///< to slip and damping about the normal
    double lost_rolling = 0;             ///< to rolling resistance
    double lost_cohesion = 0;  ///< to pulls that are not the gradient of a potential, as of edges that rock
    double work_applied = 0;   ///< by forces, restraints, prescribed bodies and changes from outside
    double residual = 0;       ///< what the numbers above leave unexplained: the error of the time stepping

    /// What the bodies and contacts hold.
    [[nodiscard]] double held() const {
        return kinetic + gravity + normal_elastic + tangential_elastic + torsional_elastic + rolling_elastic +
               cohesive;
    }
    /// What has gone for good.
    [[nodiscard]] double lost() const {
        return lost_normal_damping + lost_tangential_damping + lost_friction + lost_torsion + lost_rolling +
               lost_cohesion;
    }
};
void visit_state(auto& with, StateOf<EnergyLedger> auto& ledger) {
    auto& [kinetic, gravity, normal_elastic, tangential_elastic, torsional_elastic, rolling_elastic, cohesive,
           lost_normal_damping, lost_tangential_damping, lost_friction, lost_torsion, lost_rolling,
           lost_cohesion, work_applied, residual] = ledger;
    with(kinetic, gravity, normal_elastic, tangential_elastic, torsional_elastic, rolling_elastic, cohesive,
         lost_normal_damping, lost_tangential_damping, lost_friction, lost_torsion, lost_rolling,
         lost_cohesion, work_applied, residual);
}

/// The ledger at the system's present states and what its contacts hold; `start` is held() at the start.
EnergyLedger energy_ledger(const System& system, const Accumulated& sums, double start);

/// Keeps the ledger of a system whose flows are handed in from time to time.
class EnergyAccount {
  public:
    /// At the start, and after changes from outside: what the bodies and contacts hold more than when last
    /// settled counts as work from outside.
    void open(const System& system);
    /// After steps, and what has flowed in them.
    void settle(const System& system, const Flows& flows);

    /// As last opened or settled.
    [[nodiscard]] const EnergyLedger& ledger() const { return ledger_; }
    /// Momentum [kg m/s] of the dynamic bodies less the impulse that they received since the start.
    [[nodiscard]] const Vec3& momentum_residual() const { return momentum_gain_; }

    friend void visit_state(auto& with, StateOf<EnergyAccount> auto& account) {
        auto& [sums, ledger, momentum_gain, start, started] = account;
        with(sums, ledger, momentum_gain, start, started);
    }

  private:
    Accumulated sums_;
    EnergyLedger ledger_;  ///< when last opened or settled
    Vec3 momentum_gain_ = Vec3::Zero();
    double start_ = 0;  ///< what was held at first [J]
    bool started_ = false;
};

/// Total momentum of the dynamic bodies [kg m/s].
Vec3 total_momentum(const System& system);

}  // namespace scree
