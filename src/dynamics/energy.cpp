#include <scree/dynamics/energy.hpp>

namespace scree {

namespace {

// Work that a prescribed body does on what it touches, by the force and moment that it gets in return; its
// surface has a velocity of its own in the contact plane.
void add_prescribed(const TrialBody& body, const Vec3& force, const Vec3& moment, const Vec3& normal,
                    Accumulated& rates) {
    const Vec3 surface = body.surface_velocity - body.surface_velocity.dot(normal) * normal;
    rates.applied -= force.dot(body.velocity + surface) + moment.dot(body.spin);
}

}  // namespace

Accumulated& Accumulated::add(double factor, const Accumulated& other) {
    normal_elastic += factor * other.normal_elastic;
    normal += factor * other.normal;
    tangential += factor * other.tangential;
    tangential_damping += factor * other.tangential_damping;
    torsion += factor * other.torsion;
    rolling += factor * other.rolling;
    cohesion += factor * other.cohesion;
    applied += factor * other.applied;
    return *this;
}

Accumulated accumulation_rates(const System& system, const StepProblem& problem) {
    Accumulated rates;
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
        const Body& body = system.bodies[b];
        if (!body.dynamic()) {
            continue;
        }
        const TrialBody& trial = problem.trial()[b];
        rates.applied += body.force.dot(trial.velocity) + body.torque.dot(trial.spin);
        if (body.restraint != nullptr) {
            const StepProblem::Hold& hold = problem.holds()[b];
            rates.applied += hold.force.dot(trial.velocity) + hold.torque.dot(trial.spin);
        }
    }
    const auto results = problem.results();
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!results[i].touching) {
            continue;
        }
        const ContactForce& law = results[i].law;
        rates.normal_elastic += law.power.normal_elastic;
        rates.normal += law.power.normal;
        rates.tangential += law.power.tangential;
        rates.tangential_damping += law.power.tangential_damping;
        rates.torsion += law.power.torsion;
        rates.rolling += law.power.rolling;
        rates.cohesion += law.power.cohesion;
        if (law.state == ContactState::open) {
            continue;
        }
        const auto a = static_cast<std::size_t>(system.contacts[i].a.body);
        const auto b = static_cast<std::size_t>(system.contacts[i].b.body);
        if (!system.bodies[a].dynamic()) {
            add_prescribed(problem.trial()[a], law.force, results[i].moment_a, results[i].normal, rates);
        }
        if (!system.bodies[b].dynamic()) {
            add_prescribed(problem.trial()[b], -law.force, results[i].moment_b, results[i].normal, rates);
        }
    }
    return rates;
}

Vec3 outside_force(const System& system, const StepProblem& problem) {
    Vec3 sum = Vec3::Zero();
    for (const Body& body : system.bodies) {
        if (body.dynamic()) {
            sum += body.weight + body.force;
        }
    }
    for (const StepProblem::Hold& hold : problem.holds()) {
        sum += hold.force;
    }
    const auto results = problem.results();
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].law.state == ContactState::open) {
            continue;
        }
        const bool a_moves = system.bodies[static_cast<std::size_t>(system.contacts[i].a.body)].dynamic();
        const bool b_moves = system.bodies[static_cast<std::size_t>(system.contacts[i].b.body)].dynamic();
        if (a_moves != b_moves) {
            sum += (a_moves ? 1 : -1) * results[i].law.force;
        }
    }
    return sum;
}

EnergyLedger energy_ledger(const System& system, const Accumulated& sums, double start) {
    EnergyLedger ledger;
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
        const Body& body = system.bodies[b];
        if (!body.dynamic()) {
            continue;
        }
        const BodyState& state = system.states[b];
        ledger.kinetic +=
            0.5 * (state.momentum.dot(velocity(body, state)) + state.angular_momentum.dot(spin(body, state)));
        ledger.gravity -= body.weight.dot(state.position);
    }
    for (const Contact& contact : system.contacts) {
        ledger.normal_elastic += contact.history.normal_energy;
        ledger.tangential_elastic += contact.history.tangential_energy;
        ledger.torsional_elastic += contact.history.torsional_energy;
        ledger.rolling_elastic += contact.history.rolling_energy;
        ledger.cohesive += contact.history.cohesive_energy;
    }
    ledger.normal_elastic += sums.normal_elastic;
    // What went in and is stored no more.
    ledger.lost_normal_damping = sums.normal - ledger.normal_elastic;
    ledger.lost_tangential_damping = sums.tangential_damping;
    ledger.lost_friction = sums.tangential - ledger.tangential_elastic;
    ledger.lost_torsion = sums.torsion - ledger.torsional_elastic;
    ledger.lost_rolling = sums.rolling - ledger.rolling_elastic;
    ledger.lost_cohesion = sums.cohesion - ledger.cohesive;
    ledger.work_applied = sums.applied;
    ledger.residual = ledger.held() + ledger.lost() - ledger.work_applied - start;
    return ledger;
}

void EnergyAccount::open(const System& system) {
    const EnergyLedger now = energy_ledger(system, sums_, start_);
    if (started_) {
        sums_.applied += now.held() - ledger_.held();
    } else {
        start_ = now.held();
        started_ = true;
    }
    // What contacts came to hold from outside is no loss when they lose it, and none that they have not.
    sums_.normal += now.normal_elastic - ledger_.normal_elastic;
    sums_.tangential += now.tangential_elastic - ledger_.tangential_elastic;
    sums_.torsion += now.torsional_elastic - ledger_.torsional_elastic;
    sums_.rolling += now.rolling_elastic - ledger_.rolling_elastic;
    sums_.cohesion += now.cohesive - ledger_.cohesive;
    ledger_ = energy_ledger(system, sums_, start_);
}

void EnergyAccount::settle(const System& system, const Flows& flows) {
    sums_.add(1, flows.energy);
    momentum_gain_ += flows.momentum_gain;
    ledger_ = energy_ledger(system, sums_, start_);
}

Vec3 total_momentum(const System& system) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
        if (system.bodies[b].dynamic()) {
            sum += system.states[b].momentum;
        }
    }
    return sum;
}

}  // namespace scree
