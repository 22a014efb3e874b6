#pragma once

#include <array>
#include <functional>

#include <scree/bdf/history.hpp>
#include <scree/bdf/newton.hpp>

namespace scree {

struct SteppingOptions {
    std::size_t max_order = 2;  ///< 1 to 5; only 1 and 2 are A-stable
    double fixed_step = 0;      ///< [s]; 0: chosen by the error test
    Tolerances tolerances;
};

struct SteppingStatistics {
    std::size_t accepted = 0;
    std::size_t rejected_error = 0;
    std::size_t rejected_newton = 0;
    std::size_t rejected_contact = 0;  ///< a body left the region that its candidate pairs cover
    double smallest_step = std::numeric_limits<double>::infinity();  ///< [s], of those accepted
    double largest_step = 0;                                         ///< [s]
    double time_stepped = 0;                                         ///< [s]
    std::array<std::size_t, highest_order> orders{};                 ///< accepted steps of order 1, 2, …
    std::size_t lost_directions = 0;  ///< stored forces that had no projection on their new plane
    std::size_t centre_lines = 0;     ///< contacts and steps whose normal was the line of centres
};

/// Integrates a system by BDF with variable step and order. One call of `step` is one accepted step: predict,
/// solve, test the error, then commit or retry.
class Stepper {
  public:
    Stepper(System& system, ContactForces& forces, const SteppingOptions& options);

    /// Starts afresh at order 1 from the system's present states: after any change from outside.
    void restart(double time);

    /// One accepted step that ends at `end` [s] or before. Returns false when even the smallest step does not
    /// converge or cannot hold the tolerance; the system is then left at the last accepted state.
    bool step(double end);

    /// Asked with the bodies of a step that is about to be accepted. If it returns false it has renewed the
    /// system's contacts, and the step is made again.
    using Covered = std::function<bool(std::span<const TrialBody>)>;
    void set_covered(Covered covered) { covered_ = std::move(covered); }
    /// The system's contacts are others than before.
    void contacts_renewed() { newton_.forget(); }

    /// Where the energy is at the last accepted step.
    [[nodiscard]] EnergyLedger energy() const {
        return energy_ledger(system_, problem_.results(), history_.sums(), held_at_start_);
    }
    /// Momentum less the impulse received since the first start [kg m/s].
    [[nodiscard]] Vec3 momentum_residual() const {
        return total_momentum(system_) - history_.sums().impulse - momentum_at_start_;
    }

    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] std::size_t order() const { return order_; }
    [[nodiscard]] double last_step() const { return last_step_; }
    [[nodiscard]] const SteppingStatistics& statistics() const { return statistics_; }
    [[nodiscard]] const NewtonStatistics& newton() const { return newton_.statistics(); }
    [[nodiscard]] const StepProblem& problem() const { return problem_; }

  private:
    enum class Attempt { accepted, newton_failed, error_too_large, not_covered };

    double choose_step(double end) const;
    Attempt attempt(double time);
    void open_ledger();
    void predict(double time);
    double local_error(double time, std::size_t order) const;
    double first_error(double step) const;
    BodyError body_error(std::size_t body, std::span<const double> weights) const;
    double largest_error(const std::function<BodyError(std::size_t)>& error_of) const;
    void commit(double time);
    void plan_next(double time, double error);
    bool shrink(Attempt why, double step, double tick);

    System& system_;
    SteppingOptions options_;
    StepProblem problem_;
    Newton newton_;
    StateHistory history_;
    Covered covered_;
    SteppingStatistics statistics_;

    double time_ = 0;
    double step_ = 0;       ///< [s], to be tried next
    double last_step_ = 0;  ///< [s], the last accepted
    double error_ = 0;      ///< of the attempt, in units of the tolerance
    std::size_t order_ = 1;
    std::size_t held_ = 0;  ///< accepted steps since order or step changed
    std::size_t failures_ = 0;
    BdfFormula formula_;  ///< of the attempt
    Accumulated sums_;    ///< as of the last accepted step
    bool started_ = false;
    double held_at_start_ = 0;  ///< energy [J]
    double held_last_ = 0;      ///< at the last accepted step
    Vec3 momentum_at_start_ = Vec3::Zero();
    Vec3 momentum_last_ = Vec3::Zero();
    std::vector<Vec3> first_force_, first_torque_;  ///< at the restart
    std::vector<BodyStart> starts_;
    std::vector<BodyState> trial_states_;
    Eigen::VectorXd u_;
};

}  // namespace scree
