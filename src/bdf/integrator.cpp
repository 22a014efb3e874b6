#include <scree/bdf/integrator.hpp>

#include <stdexcept>

#include <scree/bdf/explicit_stepper.hpp>
#include <scree/bdf/stepper.hpp>

namespace scree {

EnergyLedger Integrator::energy() const {
    return energy_ledger(system_, problem_.results(), sums_, held_at_start_);
}

void Integrator::evaluate_present(Eigen::VectorXd& u) {
    StepFormulas formulas;
    formulas.time = time_;
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
}

void Integrator::open_ledger() {
    const EnergyLedger ledger = energy_ledger(system_, problem_.results(), sums_, 0);
    const double held = ledger.held();
    if (started_) {
        sums_.applied += held - held_last_;
        sums_.normal += ledger.normal_elastic - normal_last_;
    } else {
        held_at_start_ = held;
        sums_.normal = ledger.normal_elastic;
    }
    started_ = true;
    rates_ = accumulation_rates(system_, problem_);
}

void Integrator::accept(double time, std::size_t order, std::vector<BodyState>& states) {
    const auto results = problem_.results();
    for (std::size_t i = 0; i < results.size(); ++i) {
        ContactHistory& history = system_.contacts[i].history;
        if (results[i].law.state == ContactState::open) {
            history.clear();
            continue;
        }
        history.push(results[i].law.trial);
        history.centre_line = results[i].centre_line;
        statistics_.lost_directions += results[i].law.lost_direction;
        statistics_.centre_lines += results[i].centre_line;
    }
    const Accumulated before = rates_;
    rates_ = accumulation_rates(system_, problem_);
    sums_.add(0.5 * (time - time_), before).add(0.5 * (time - time_), rates_);
    system_.states.swap(states);
    const EnergyLedger ledger = energy_ledger(system_, results, sums_, 0);
    held_last_ = ledger.held();
    normal_last_ = ledger.normal_elastic;
    last_step_ = time - time_;
    time_ = time;
    ++statistics_.accepted;
    ++statistics_.orders[order - 1];
    statistics_.smallest_step = std::min(statistics_.smallest_step, last_step_);
    statistics_.largest_step = std::max(statistics_.largest_step, last_step_);
    statistics_.time_stepped += last_step_;
}

std::unique_ptr<Integrator> make_integrator(System& system, ContactForces& forces,
                                            const SteppingOptions& options) {
    if (options.method == Method::bdf) {
        return std::make_unique<Stepper>(system, forces, options);
    }
    if (!(options.fixed_step > 0)) {
        throw std::invalid_argument("an explicit method needs a step");
    }
    return std::make_unique<ExplicitStepper>(system, forces, options);
}

}  // namespace scree
