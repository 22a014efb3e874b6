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

RunSummary summary_of(const Simulation& simulation) {
    const StepReport& report = simulation.report();
    const SteppingStatistics& steps = report.steps;
    const Features features = scene_features(simulation.scene());
    RunSummary summary;
    summary.scene = simulation.scene().name;
    summary.message = report.message;
    summary.end_time = simulation.scene().end_time;
    summary.reached = simulation.time();
    summary.time.detection = report.times.detection;
    summary.time.stepping = report.times.stepping;
    summary.steps = {steps.accepted, steps.rejected_error, steps.rejected_newton, steps.rejected_contact};
    if (steps.accepted > 0) {
        summary.smallest_step = steps.smallest_step;
        summary.mean_step = steps.time_stepped / static_cast<double>(steps.accepted);
        summary.largest_step = steps.largest_step;
    }
    summary.orders.assign(steps.orders.begin(), steps.orders.end());
    summary.newton = {report.newton.iterations, report.newton.jacobians, report.newton.factorizations};
    summary.contact_evaluations = report.contact_evaluations;
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
