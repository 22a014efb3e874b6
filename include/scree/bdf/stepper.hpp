#pragma once

#include <functional>

#include <scree/bdf/history.hpp>
#include <scree/bdf/integrator.hpp>

namespace scree {

/// BDF with variable step and order. One call of `step` is one accepted step: predict, solve, test the error,
/// then commit or retry.
class Stepper final : public Integrator {
  public:
    Stepper(System& system, ContactForces& forces, const SteppingOptions& options)
        : Integrator(system, forces, options) {}

    /// At order 1; contacts keep their last friction force.
    void restart(double time) override;
    bool step(double end) override;
    void contacts_renewed() override { newton_.forget(); }

    [[nodiscard]] std::size_t order() const override { return order_; }
    [[nodiscard]] NewtonStatistics newton() const override { return newton_.statistics(); }

  private:
    enum class Attempt { accepted, newton_failed, error_too_large, not_covered };

    [[nodiscard]] double first_step() const;
    [[nodiscard]] double choose_step(double end) const;
    Attempt attempt(double time);
    void predict(double time);
    [[nodiscard]] double local_error(double time, std::size_t order) const;
    [[nodiscard]] double first_error(double step) const;
    [[nodiscard]] BodyError body_error(std::size_t body, std::span<const double> weights) const;
    [[nodiscard]] double largest_error(const std::function<BodyError(std::size_t)>& error_of) const;
    void commit(double time);
    void plan_next(double time, double error);
    bool shrink(Attempt why, double step, double tick);

    Newton newton_;
    StateHistory history_;
    BdfFormula formula_;                  ///< of the attempt
    Vec3 start_momentum_ = Vec3::Zero();  ///< of all bodies, what the past contributes [kg m/s]
    double step_ = 0;                     ///< [s], to be tried next
    double error_ = 0;                    ///< of the attempt, in units of the tolerance
    std::size_t order_ = 1;
    std::size_t held_ = 0;                          ///< accepted steps since order or step changed
    std::size_t failures_ = 0;                      ///< of the step under way
    std::size_t renewals_ = 0;                      ///< of the candidate pairs in it
    std::vector<Vec3> first_force_, first_torque_;  ///< at the restart
    std::vector<BodyStart> starts_;
    std::vector<BodyState> trial_states_;
    Eigen::VectorXd u_;
};

}  // namespace scree
