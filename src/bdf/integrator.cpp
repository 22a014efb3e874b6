#include <scree/bdf/integrator.hpp>

#include <algorithm>
#include <stdexcept>

#include <scree/bdf/explicit_stepper.hpp>
#include <scree/bdf/stepper.hpp>

namespace scree {

SteppingStatistics Integrator::take_statistics() {
    const StepProblem::Costs costs = problem_.take_costs();
    statistics_.contact_evaluations = costs.evaluations;
    statistics_.contact_time = costs.contacts;
    statistics_.jacobian_time = costs.jacobian;
    statistics_.solve_time = costs.solve;
    return std::exchange(statistics_, {});
}

void Integrator::evaluate_present(Eigen::VectorXd& u, double moment) {
    StepFormulas formulas;
    formulas.time = memory_.time + moment;
    formulas.step = formulas.beta_h = formulas.friction_beta_h[0] = moment;
    formulas.past[0][0] = 1;
    std::vector<BodyStart> starts(system_.bodies.size());
    u.resize(static_cast<Eigen::Index>(6 * system_.bodies.size()));
    for (std::size_t b = 0; b < starts.size(); ++b) {
        const BodyState& state = system_.states[b];
        starts[b].position = state.position;
        starts[b].orientation = state.orientation.coeffs();
        starts[b].past_orientations[0] = state.orientation;
        u.segment<3>(static_cast<Eigen::Index>(6 * b)) = velocity(system_.bodies[b], state);
        u.segment<3>(static_cast<Eigen::Index>(6 * b + 3)) = spin(system_.bodies[b], state);
    }
    problem_.begin(formulas, starts);
    problem_.evaluate(u, Detail::force);
    memory_.powers = accumulation_rates(system_, problem_);
    memory_.stiffness = Stiffness::of(problem_, system_);
    memory_.force = problem_.forces();
    memory_.torque = problem_.torques();
}

void Integrator::remember_energies() {
    const auto results = problem_.results();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ContactForce& law = results[i].law;
        const double touching = results[i].touching ? 1 : 0;
        ContactHistory& history = system_.contacts[i].history;
        history.normal_energy = touching * law.normal_energy;
        history.tangential_energy = touching * law.tangential_energy;
        history.torsional_energy = touching * law.torsional_energy;
        history.rolling_energy = touching * law.rolling_energy;
        history.cohesive_energy = touching * law.cohesive_energy;
    }
}

void Integrator::accept(double time, std::size_t order, std::vector<BodyState>& states) {
    remember_contacts();
    remember_energies();
    const Accumulated before = *memory_.powers;
    memory_.powers = accumulation_rates(system_, problem_);
    memory_.stiffness = Stiffness::of(problem_, system_);
    const double step = time - memory_.time;
    flows_.energy.add(0.5 * step, before).add(0.5 * step, *memory_.powers);
    system_.states.swap(states);
    memory_.last_step = step;
    memory_.time = time;
    ++statistics_.accepted;
    ++statistics_.orders[order - 1];
    statistics_.smallest_step = std::min(statistics_.smallest_step, step);
    statistics_.largest_step = std::max(statistics_.largest_step, step);
    statistics_.time_stepped += step;
}

void Integrator::remember_contacts() {
    const auto results = problem_.results();
    for (std::size_t i = 0; i < results.size(); ++i) {
        ContactHistory& history = system_.contacts[i].history;
        if (results[i].law.state == ContactState::open) {
            history.clear();
            continue;
        }
        history.push(results[i].law.trial, results[i].law.cells);
        if (!results[i].own.empty()) {
            history.push_own(results[i].own);
        }
        history.centre_line = results[i].centre_line;
        statistics_.lost_directions += results[i].law.lost_direction;
        statistics_.centre_lines += results[i].centre_line;
    }
}

std::unique_ptr<Integrator> make_integrator(System& system, const ContactForces& forces,
                                            const SteppingOptions& options, Workers* workers) {
    if (options.method == Method::bdf) {
        return std::make_unique<Stepper>(system, forces, options, workers);
    }
    if (!(options.fixed_step > 0)) {
        throw std::invalid_argument("an explicit method needs a step");
    }
    return std::make_unique<ExplicitStepper>(system, forces, options, workers);
}

}  // namespace scree
