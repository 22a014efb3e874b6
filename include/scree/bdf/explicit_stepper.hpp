#pragma once

#include <scree/bdf/integrator.hpp>

namespace scree {

/// Symplectic Euler and velocity Verlet with a fixed step, as other discrete element codes have them; beside
/// the implicit method for comparison. Verlet takes forces at the new positions and the velocities of half a
/// step.
class ExplicitStepper final : public Integrator {
  public:
    /// As Integrator; options of an explicit method, with a fixed step.
    ExplicitStepper(System& system, const ContactForces& forces, const SteppingOptions& options,
                    Workers* workers = nullptr)
        : Integrator(system, forces, options, workers) {}

    void restart(double time) override;
    void resume(const SteppingMemory& memory) override;
    StepOutcome step(double end) override;

  private:
    /// Adds the forces of the last evaluation, over `duration` [s], to momenta.
    void kick(double duration, std::vector<BodyState>& states) const;
    /// Gives bodies back the spins that are held, of which a `duration` [s] of the step has passed.
    void hold_spins(double duration, std::vector<BodyState>& states) const;
    /// Moves all bodies to `time` [s] with the velocities of `states` and computes the forces there.
    void drift(double time, const std::vector<BodyState>& states);
    [[nodiscard]] bool finite(const std::vector<BodyState>& states) const;

    std::vector<BodyState> states_;  ///< of the step under way
    std::vector<BodyStart> starts_;
    Eigen::VectorXd u_;
};

}  // namespace scree
