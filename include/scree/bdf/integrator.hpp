#pragma once

#include <array>
#include <functional>

#include <scree/bdf/error_norm.hpp>
#include <scree/bdf/newton.hpp>
#include <scree/dynamics/energy.hpp>

namespace scree {

enum class Method { bdf, symplectic_euler, velocity_verlet };

struct SteppingOptions {
    Method method = Method::bdf;
    std::size_t max_order = 2;  ///< of BDF, 1 to 5; only 1 and 2 are A-stable
    double fixed_step = 0;      ///< [s]; 0: chosen by the error test, which only BDF has
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

/// Carries a system forward in time, one accepted step at a time, and keeps the books.
class Integrator {
  public:
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    /// Starts afresh from the system's present states: after any change from outside.
    virtual void restart(double time) = 0;

    /// One accepted step that ends at `end` [s] or before. Returns false when no step can be made that keeps
    /// what the method promises; the system is then left at the last accepted state.
    virtual bool step(double end) = 0;

    /// The system's contacts are others than before.
    virtual void contacts_renewed() {}

    /// Asked with the bodies of a step that is about to be accepted. If it returns false it has renewed the
    /// system's contacts, and the step is made again.
    using Covered = std::function<bool(std::span<const TrialBody>)>;
    void set_covered(Covered covered) { covered_ = std::move(covered); }

    /// Where the energy is at the last accepted step.
    [[nodiscard]] EnergyLedger energy() const;
    /// Momentum gained without an impulse from outside, summed over all steps [kg m/s].
    [[nodiscard]] const Vec3& momentum_residual() const { return momentum_residual_; }

    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double last_step() const { return last_step_; }
    [[nodiscard]] const SteppingStatistics& statistics() const { return statistics_; }
    [[nodiscard]] const StepProblem& problem() const { return problem_; }
    [[nodiscard]] virtual std::size_t order() const = 0;
    [[nodiscard]] virtual NewtonStatistics newton() const { return {}; }

  protected:
    Integrator(System& system, ContactForces& forces, const SteppingOptions& options)
        : system_(system), options_(options), problem_(system, forces) {}

    /// Evaluates the problem at the system's present states, with u the velocities there.
    void evaluate_present(Eigen::VectorXd& u);
    /// Starts or continues the ledger at the present states, which evaluate_present has evaluated. What was
    /// changed from outside since the last step counts as work from outside.
    void open_ledger();
    /// Makes `states` and the trial contact records of the problem history, and adds the step to the ledger,
    /// by the trapezoidal rule: exact to second order whatever the order of the step.
    void accept(double time, std::size_t order, std::vector<BodyState>& states);

    System& system_;
    SteppingOptions options_;
    StepProblem problem_;
    Covered covered_;
    SteppingStatistics statistics_;
    Vec3 momentum_residual_ = Vec3::Zero();  ///< [kg m/s]
    double time_ = 0;
    double last_step_ = 0;  ///< [s], the last accepted

  private:
    Accumulated sums_;   ///< as of the last accepted step
    Accumulated rates_;  ///< there
    bool started_ = false;
    double held_at_start_ = 0;  ///< energy [J]
    double normal_last_ = 0;    ///< stored normal energy at the last accepted step [J]
    double held_last_ = 0;      ///< at the last accepted step
};

/// The integrator of the method that the options name. Throws std::invalid_argument for an explicit method
/// without a step.
std::unique_ptr<Integrator> make_integrator(System& system, ContactForces& forces,
                                            const SteppingOptions& options);

}  // namespace scree
