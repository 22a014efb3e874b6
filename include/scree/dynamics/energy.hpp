#pragma once

#include <scree/dynamics/step_problem.hpp>

namespace scree {

/// Energies [J] that are summed over time beside the states.
struct Accumulated {
    double normal_elastic = 0;      ///< into normal elasticity that has no potential
    double normal = 0;              ///< into normal elasticity and damping
    double tangential = 0;          ///< into tangential springs and slip
    double tangential_damping = 0;  ///< lost
    double applied = 0;             ///< by applied forces and prescribed bodies

    Accumulated& add(double factor, const Accumulated& other);
};

/// The rates of what is accumulated, at the problem's last evaluation [W].
Accumulated accumulation_rates(const System& system, const StepProblem& problem);

/// The sum of all forces on dynamic bodies but those of one dynamic body on another [N], at the last
/// evaluation.
Vec3 outside_force(const System& system, const StepProblem& problem);

/// Where the energy is [J].
struct EnergyLedger {
    double kinetic = 0;
    double gravity = 0;
    double normal_elastic = 0;
    double tangential_elastic = 0;
    double lost_normal_damping = 0;
    double lost_tangential_damping = 0;
    double lost_friction = 0;
    double work_applied = 0;
    double residual = 0;  ///< what the numbers above leave unexplained: the error of the time stepping

    /// What the bodies and contacts hold.
    [[nodiscard]] double held() const { return kinetic + gravity + normal_elastic + tangential_elastic; }
};

/// The ledger at the system's present states and the problem's last evaluation; `start` is held() at the
/// start.
EnergyLedger energy_ledger(const System& system, std::span<const ContactResult> results,
                           const Accumulated& sums, double start);

/// Total momentum of the dynamic bodies [kg m/s].
Vec3 total_momentum(const System& system);

}  // namespace scree
