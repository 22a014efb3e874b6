#include <scree/bdf/statistics.hpp>

#include <algorithm>

namespace scree {

NewtonStatistics& NewtonStatistics::add(const NewtonStatistics& other) {
    iterations += other.iterations;
    jacobians += other.jacobians;
    factorizations += other.factorizations;
    functional_iterations += other.functional_iterations;
    return *this;
}

SteppingStatistics& SteppingStatistics::add(const SteppingStatistics& other) {
    accepted += other.accepted;
    rejected_error += other.rejected_error;
    rejected_newton += other.rejected_newton;
    rejected_contact += other.rejected_contact;
    smallest_step = std::min(smallest_step, other.smallest_step);
    largest_step = std::max(largest_step, other.largest_step);
    time_stepped += other.time_stepped;
    for (std::size_t order = 0; order < orders.size(); ++order) {
        orders[order] += other.orders[order];
    }
    lost_directions += other.lost_directions;
    centre_lines += other.centre_lines;
    unstable_orders += other.unstable_orders;
    newton.add(other.newton);
    contact_evaluations += other.contact_evaluations;
    contact_time += other.contact_time;
    jacobian_time += other.jacobian_time;
    solve_time += other.solve_time;
    return *this;
}

SteppingStatistics SteppingStatistics::without_steps() const {
    SteppingStatistics costs = *this;
    costs.accepted = 0;
    costs.smallest_step = std::numeric_limits<double>::infinity();
    costs.largest_step = costs.time_stepped = 0;
    costs.orders = {};
    return costs;
}

}  // namespace scree
