#pragma once

#include <scree/bdf/corrector.hpp>
#include <scree/bdf/integrator.hpp>

namespace scree {

/// BDF with variable step and order. One call of `step` is one accepted step: predict, solve, test the error,
/// then commit or retry.
class Stepper final : public Integrator {
  public:
    /// As Integrator; options of the method BDF.
    Stepper(System& system, const ContactForces& forces, const SteppingOptions& options,
            Workers* workers = nullptr)
        : Integrator(system, forces, options, workers), corrector_(options) {}

    void restart(double time) override;
    void resume(const SteppingMemory& memory) override;
    StepOutcome step(double end) override;
    void contacts_renewed() override { corrector_.forget(); }

  private:
    static constexpr std::size_t most_failures = 3;  // of a step, before it is one of order 1
    enum class Attempt { accepted, not_solved, error_too_large, not_covered };

    void start_afresh(double time, double moment);
    [[nodiscard]] double first_step() const;
    [[nodiscard]] double choose_step(double end) const;
    Attempt attempt(double time);
    void predict(double time);
    void commit(double time);
    void plan_next(double time, double error);
    bool shrink(Attempt why, double step, double tick);
    bool locate_onset(double time);
    [[nodiscard]] double onset_time(double time) const;
    [[nodiscard]] double moment() const;
    void watch_stability(double time);

    /// The largest over the bodies of the local error that a formula of this order made, over what it may be.
    [[nodiscard]] double allowed_error(std::size_t order) const;
    [[nodiscard]] double local_error(double time, std::size_t order) const;
    [[nodiscard]] double largest_difference(double time, std::size_t order) const;
    [[nodiscard]] double first_error(double step) const;
    [[nodiscard]] BodyError body_error(std::size_t body, std::span<const double> weights) const;
    [[nodiscard]] double friction_error(const Contact& contact, const ContactResult& result,
                                        std::span<const double> weights) const;
    [[nodiscard]] Quat turn_since(std::size_t body, std::size_t j) const;

    Corrector corrector_;
    BdfFormula formula_;                  ///< of the attempt
    Vec3 start_momentum_ = Vec3::Zero();  ///< of all bodies, what the past contributes [kg m/s]
    double error_ = 0;                    ///< of the attempt, over what is allowed
    std::size_t failures_ = 0;            ///< of the step under way
    std::size_t landings_ = 0;            ///< attempts of it to end where a contact begins
    double landing_ = 0;                  ///< [s], where the present attempt is to do so; 0: anywhere
    std::vector<BodyStart> starts_;
    std::vector<BodyState> trial_states_;
    Eigen::VectorXd u_;
};

}  // namespace scree
