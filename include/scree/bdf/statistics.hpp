#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <scree/dynamics/trial.hpp>

namespace scree {

/// What solving the equations has taken.
struct NewtonStatistics {
    std::size_t iterations = 0;             ///< of Newton's method
    std::size_t jacobians = 0;              ///< assembled
    std::size_t factorizations = 0;         ///< of the Jacobian
    std::size_t functional_iterations = 0;  ///< of the functional corrector

    /// Sums both.
    NewtonStatistics& add(const NewtonStatistics& other);
};
void visit_state(auto& with, StateOf<NewtonStatistics> auto& newton) {
    auto& [iterations, jacobians, factorizations, functional_iterations] = newton;
    with(iterations, jacobians, factorizations, functional_iterations);
}

/// What an integrator has done.
struct SteppingStatistics {
    std::size_t accepted = 0;          ///< steps
    std::size_t rejected_error = 0;    ///< the error test failed
    std::size_t rejected_newton = 0;   ///< the equations were not solved, by whichever corrector
    std::size_t rejected_contact = 0;  ///< a body left the region that its candidate pairs cover
    double smallest_step = std::numeric_limits<double>::infinity();  ///< [s], of those accepted
    double largest_step = 0;                                         ///< [s]
    double time_stepped = 0;                                         ///< [s]
    std::array<std::size_t, highest_order> orders{};                 ///< accepted steps of order 1, 2, …
    std::size_t lost_directions = 0;      ///< stored forces that had no projection on their new plane
    std::size_t centre_lines = 0;         ///< contacts and steps whose normal was the line of centres
    std::size_t unstable_orders = 0;      ///< times that an order was left because it looked unstable
    NewtonStatistics newton;              ///< what the equations took
    std::size_t contact_evaluations = 0;  ///< of one contact each
    double contact_time = 0;   ///< wall time [s] in contacts without derivatives, summed over threads
    double jacobian_time = 0;  ///< [s] in contacts with derivatives and in the assembly
    double solve_time = 0;     ///< [s] in factorising and solving

    /// Sums both; of the least and greatest steps the least and greatest.
    SteppingStatistics& add(const SteppingStatistics& other);
    /// The costs alone, of steps that were not kept.
    [[nodiscard]] SteppingStatistics without_steps() const;
};
void visit_state(auto& with, StateOf<SteppingStatistics> auto& statistics) {
    auto& [accepted, rejected_error, rejected_newton, rejected_contact, smallest_step, largest_step,
           time_stepped, orders, lost_directions, centre_lines, unstable_orders, newton, contact_evaluations,
           contact_time, jacobian_time, solve_time] = statistics;
    with(accepted, rejected_error, rejected_newton, rejected_contact, smallest_step, largest_step,
         time_stepped, orders, lost_directions, centre_lines, unstable_orders, newton, contact_evaluations,
         contact_time, jacobian_time, solve_time);
}

}  // namespace scree
