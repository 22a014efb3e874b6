#include "summary_of.hpp"

#include <scree/scenes/features.hpp>

namespace scree {

std::vector<BodyRecord> body_records(const Simulation& simulation) {
    std::vector<BodyRecord> records;
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        const FrameMotion motion = simulation.file_motion(i);
        records.push_back(
            {simulation.bodies()[i].name, motion.pose, motion.velocity, motion.angular_velocity});
    }
    return records;
}

namespace {

// What the threads have spent on the stages, as shares of the wall time in which they did.
void set_stage_times(const StepReport& report, RunSummary::Times& time) {
    const SteppingStatistics& all = report.all_steps;
    const double sum = all.contact_time + all.jacobian_time + all.solve_time;
    const double share = sum > report.times.stepping ? report.times.stepping / sum : 1;
    time.detection = report.times.detection;
    time.contacts = share * all.contact_time;
    time.jacobian = share * all.jacobian_time;
    time.solve = share * all.solve_time;
}

}  // namespace

RunSummary summary_of(const Simulation& simulation) {
    const StepReport& report = simulation.report();
    const SteppingStatistics& steps = report.steps;
    const Features features = scene_features(simulation.scene());
    RunSummary summary;
    summary.scene = simulation.scene().name;
    summary.message = report.message;
    summary.end_time = simulation.scene().end_time;
    summary.reached = simulation.time();
    summary.threads = simulation.threads();
    set_stage_times(report, summary.time);
    summary.steps = {steps.accepted, steps.rejected_error, steps.rejected_newton, steps.rejected_contact};
    if (steps.accepted > 0) {
        summary.smallest_step = steps.smallest_step;
        summary.mean_step = steps.time_stepped / static_cast<double>(steps.accepted);
        summary.largest_step = steps.largest_step;
    }
    summary.orders.assign(steps.orders.begin(), steps.orders.end());
    summary.newton = {steps.newton.iterations, steps.newton.jacobians, steps.newton.factorizations};
    summary.functional_iterations = steps.newton.functional_iterations;
    summary.contact_evaluations = report.all_steps.contact_evaluations;
    summary.contacts_now = report.contacts;
    summary.contacts_most = report.most_contacts;
    summary.largest_overlap = report.largest_overlap;
    summary.energy = report.energy;
    summary.momentum_residual = report.momentum_residual.norm();
    summary.used = features.used;
    summary.left_out = features.left_out;
    summary.bodies = body_records(simulation);
    return summary;
}

}  // namespace scree
