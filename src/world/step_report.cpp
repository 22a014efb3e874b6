#include <scree/world/step_report.hpp>

#include <algorithm>

namespace scree {

void add(SteppingStatistics& sum, const SteppingStatistics& part) {
    sum.accepted += part.accepted;
    sum.rejected_error += part.rejected_error;
    sum.rejected_newton += part.rejected_newton;
    sum.rejected_contact += part.rejected_contact;
    sum.smallest_step = std::min(sum.smallest_step, part.smallest_step);
    sum.largest_step = std::max(sum.largest_step, part.largest_step);
    sum.time_stepped += part.time_stepped;
    for (std::size_t order = 0; order < highest_order; ++order) {
        sum.orders[order] += part.orders[order];
    }
    sum.lost_directions += part.lost_directions;
    sum.centre_lines += part.centre_lines;
}

void add(NewtonStatistics& sum, const NewtonStatistics& part) {
    sum.iterations += part.iterations;
    sum.jacobians += part.jacobians;
    sum.factorizations += part.factorizations;
}

void add_flows(EnergyLedger& sum, const EnergyLedger& part) {
    sum.lost_normal_damping += part.lost_normal_damping;
    sum.lost_tangential_damping += part.lost_tangential_damping;
    sum.lost_friction += part.lost_friction;
    sum.work_applied += part.work_applied;
    sum.residual += part.residual;
}

}  // namespace scree
