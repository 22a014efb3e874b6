#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <scree/bdf/corrector.hpp>
#include <scree/bdf/error_norm.hpp>
#include <scree/bdf/history.hpp>
#include <scree/bdf/options.hpp>
#include <scree/bdf/statistics.hpp>
#include <scree/dynamics/energy.hpp>

namespace scree {

/// All that a method carries from one step to the next, besides the system's states and what its contacts
/// remember.
struct SteppingMemory {
    double time = 0;                    ///< [s]
    double last_step = 0;               ///< [s], the last accepted; 0: none yet
    double next_step = 0;               ///< [s], to be tried; 0: none yet
    std::size_t order = 1;              ///< to be tried
    std::size_t held = 0;               ///< accepted steps since order or step changed
    std::size_t suspect = 0;            ///< successive steps that look unstable at their order
    std::size_t barred = 0;             ///< accepted steps for which a higher order is out of question
    Stiffness stiffness;                ///< of the contacts at `time`
    std::size_t patience = 0;           ///< steps until the functional corrector may be tried again
    StateHistory past;                  ///< the present state, then earlier ones
    std::optional<Accumulated> powers;  ///< [W], where energy flows at `time`; empty: to be found anew
    std::vector<Vec3> force,            ///< [N], that a next explicit step or a first error test starts from
        torque;                         ///< [N m], likewise
};
void visit_state(auto& with, StateOf<SteppingMemory> auto& memory) {
    auto& [time, last_step, next_step, order, held, suspect, barred, stiffness, patience, past, powers, force,
           torque] = memory;
    with.up_to(highest_order, order);
    with(time, last_step, next_step, held, suspect, barred, stiffness, patience, past, powers, force, torque);
}

/// Why `Integrator::step` has come back.
enum class StepOutcome {
    accepted,
    failed,      ///< no step can be made that keeps what the method promises
    left_cover,  ///< a body leaves the region for which the contacts are complete
};

/// Carries a system forward in time, one accepted step at a time.
class Integrator {
  public:
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    /// Starts afresh from the system's present states: after any change from outside. Contacts keep their
    /// last friction force.
    virtual void restart(double time) = 0;
    /// Goes on from the system's present states with what was carried that far.
    virtual void resume(const SteppingMemory& memory) = 0;
    /// What is carried to the next step.
    [[nodiscard]] const SteppingMemory& memory() const { return memory_; }
    /// As after the step that left this memory.
    void recall(const SteppingMemory& memory) { memory_ = memory; }

    /// One accepted step that ends at `end` [s] or before; otherwise the system is left at the last accepted
    /// state.
    virtual StepOutcome step(double end) = 0;

    /// The system's contacts are others than before.
    virtual void contacts_renewed() {}

    /// Others share out the contacts of one evaluation; changes no result.
    void set_workers(Workers* workers) { problem_.set_workers(workers); }

    /// Asked with the bodies of a step that is about to be accepted: whether the contacts are complete there.
    using Covered = std::function<bool(std::span<const TrialBody>)>;
    /// An empty one: always.
    void set_covered(Covered covered) { covered_ = std::move(covered); }

    /// [s], at the last accepted step.
    [[nodiscard]] double time() const { return memory_.time; }
    /// Counts since last taken.
    [[nodiscard]] const SteppingStatistics& statistics() const { return statistics_; }
    /// The equations as last evaluated.
    [[nodiscard]] const StepProblem& problem() const { return problem_; }

    /// What has flowed over all accepted steps since this was made or the flows were last taken.
    [[nodiscard]] const Flows& flows() const { return flows_; }
    /// Hands the flows and the counts over and starts both at zero.
    Flows take_flows() { return std::exchange(flows_, {}); }
    /// Hands the counts over and starts them at zero.
    SteppingStatistics take_statistics();

  protected:
    /// `system` and `forces` must outlive it; so must `workers`, which may be null.
    Integrator(System& system, const ContactForces& forces, const SteppingOptions& options, Workers* workers)
        : system_(system), options_(options), problem_(system, forces, workers) {}

    /// Evaluates the problem at the system's present states, with u the velocities there, or where these lead
    /// in a `moment` [s].
    void evaluate_present(Eigen::VectorXd& u, double moment = 0);
    /// Makes `states` and the trial contact records of the problem history, and adds the step to the flows,
    /// by the trapezoidal rule: exact to second order whatever the order of the step.
    void accept(double time, std::size_t order, std::vector<BodyState>& states);
    /// What the contacts hold at the last evaluation.
    void remember_energies();

    System& system_;                 ///< that is stepped
    SteppingOptions options_;        ///< of the method
    StepProblem problem_;            ///< of the step under way
    Covered covered_;                ///< empty: every step is
    SteppingMemory memory_;          ///< at the last accepted step
    SteppingStatistics statistics_;  ///< since last taken
    Flows flows_;                    ///< since last taken

  private:
    void remember_contacts();
};

/// The integrator of the method that the options name. Throws std::invalid_argument for an explicit method
/// without a step. `workers` may share out the contacts of one evaluation; null: nobody does.
std::unique_ptr<Integrator> make_integrator(System& system, const ContactForces& forces,
                                            const SteppingOptions& options, Workers* workers = nullptr);

}  // namespace scree
