#include <scree/dynamics/step_problem.hpp>

#include <algorithm>
#include <limits>

#include <scree/dynamics/stopwatch.hpp>

namespace scree {

namespace {

constexpr std::size_t share = 8;          // contacts that one worker takes at a time
constexpr std::size_t least_shared = 64;  // contacts, below which sharing costs more than it saves

}  // namespace

double path_time_scale(const System& system) {
    double least = std::numeric_limits<double>::infinity();
    for (const Contact& contact : system.contacts) {
        for (const int number : {contact.a.body, contact.b.body}) {
            const PrescribedPath* path = system.bodies[static_cast<std::size_t>(number)].path;
            least = path == nullptr ? least : std::min(least, path->time_scale());
        }
    }
    return least;
}

void StepProblem::begin(const StepFormulas& formulas, std::vector<BodyStart>& starts) {
    formulas_ = formulas;
    starts_.swap(starts);
    trial_.resize(system_.bodies.size());
    results_.resize(system_.contacts.size());
    residual_.setZero(static_cast<Eigen::Index>(6 * system_.bodies.size()));
    const bool restrained = std::any_of(system_.bodies.begin(), system_.bodies.end(),
                                        [](const Body& body) { return body.restraint != nullptr; });
    holds_.resize(restrained ? system_.bodies.size() : 0);
}

void StepProblem::evaluate(const Eigen::VectorXd& u, Detail detail) {
    const Stopwatch watch(detail == Detail::force ? costs_.contacts : costs_.jacobian);
    detail_ = detail;
    place_bodies(u);
    evaluate_contacts();
    sum_forces();
    restrain();
    fill_residual();
}

// In blocks that do not depend on how many share them.
void StepProblem::evaluate_contacts() {
    const std::span<const Contact> contacts = system_.contacts;
    costs_.evaluations += contacts.size();
    if (workers_ == nullptr || workers_->threads() == 1 || contacts.size() < least_shared) {
        forces_.evaluate(contacts, trial_, formulas_, detail_, results_);
        return;
    }
    workers_->run((contacts.size() + share - 1) / share, [&](std::size_t i) {
        const std::size_t begin = i * share;
        const std::size_t size = std::min(share, contacts.size() - begin);
        forces_.evaluate(contacts.subspan(begin, size), trial_, formulas_, detail_,
                         std::span(results_).subspan(begin, size));
    });
}

void StepProblem::place_bodies(const Eigen::VectorXd& u) {
    for (std::size_t b = 0; b < trial_.size(); ++b) {
        TrialBody& body = trial_[b];
        if (system_.bodies[b].path != nullptr) {
            place_on_path(*system_.bodies[b].path, starts_[b], formulas_, body);
            continue;
        }
        const auto row = static_cast<Eigen::Index>(6 * b);
        body.surface_velocity.setZero();
        body.velocity = u.segment<3>(row);
        body.spin = u.segment<3>(row + 3);
        if (system_.bodies[b].dynamic()) {
            place(starts_[b], formulas_, body);
        } else {
            place_prescribed(system_.states[b], starts_[b], formulas_, body);
        }
    }
}

// In the order of the contacts, so that the sums do not depend on how the contacts were shared out.
void StepProblem::sum_forces() {
    force_.resize(trial_.size());
    torque_.resize(trial_.size());
    for (std::size_t b = 0; b < trial_.size(); ++b) {
        force_[b] = system_.bodies[b].weight + system_.bodies[b].force;
        torque_[b] = system_.bodies[b].torque;
    }
    touched_.assign(trial_.size(), false);
    for (std::size_t i = 0; i < results_.size(); ++i) {
        const ContactResult& result = results_[i];
        if (result.law.state == ContactState::open) {
            continue;
        }
        const auto a = static_cast<std::size_t>(system_.contacts[i].a.body);
        const auto b = static_cast<std::size_t>(system_.contacts[i].b.body);
        touched_[a] = touched_[b] = true;
        force_[a] += result.law.force;
        force_[b] -= result.law.force;
        torque_[a] += result.moment_a;
        torque_[b] += result.moment_b;
    }
}

// Forces and torques become what they make of momenta.
void StepProblem::restrain() {
    for (std::size_t b = 0; b < holds_.size(); ++b) {
        const Body& body = system_.bodies[b];
        holds_[b] = {};
        if (body.restraint == nullptr) {
            continue;
        }
        const TrialBody& trial = trial_[b];
        const Vec3 force = restrained_force(*body.restraint, force_[b], body.mass * trial.velocity);
        const Vec3 torque = restrained_torque(*body.restraint, torque_[b],
                                              world_inertia(body, trial.pose.orientation), trial.spin);
        holds_[b] = {force - force_[b], torque - torque_[b]};
        force_[b] = force;
        torque_[b] = torque;
    }
}

void StepProblem::fill_residual() {
    for (std::size_t b = 0; b < trial_.size(); ++b) {
        const Body& body = system_.bodies[b];
        if (!body.dynamic()) {
            continue;
        }
        const TrialBody& trial = trial_[b];
        const BodyStart& start = starts_[b];
        const auto row = static_cast<Eigen::Index>(6 * b);
        residual_.segment<3>(row) =
            body.mass * trial.velocity - start.momentum - formulas_.beta_h * force_[b];
        residual_.segment<3>(row + 3) = world_inertia(body, trial.pose.orientation) * trial.spin -
                                        start.angular_momentum - formulas_.beta_h * torque_[b];
        if (body.restraint != nullptr) {
            fill_held_rows(b, *body.restraint);
        }
    }
}

// About an axis that is held the spin is known.
void StepProblem::fill_held_rows(std::size_t b, const Restraint& restraint) {
    const Vec3 before = spin(system_.bodies[b], system_.states[b]);
    const Vec3 off = trial_[b].spin - spin_after(restraint, before, formulas_.step);
    for (int axis = 0; axis < 3; ++axis) {
        if (restraint.held(axis)) {
            residual_[static_cast<Eigen::Index>(6 * b + 3) + axis] =
                held_inertia(system_.bodies[b]) * off[axis];
        }
    }
}

bool StepProblem::states_changed() const {
    if (factorized_regimes_.size() != results_.size()) {
        return true;
    }
    for (std::size_t i = 0; i < results_.size(); ++i) {
        if (results_[i].law.regime() != factorized_regimes_[i]) {
            return true;
        }
    }
    return false;
}

bool StepProblem::factorize() {
    factorized_regimes_.resize(results_.size());
    for (std::size_t i = 0; i < results_.size(); ++i) {
        factorized_regimes_[i] = results_[i].law.regime();
    }
    {
        const Stopwatch watch(costs_.jacobian);
        jacobian_.assemble(system_.bodies, trial_, system_.contacts, results_, formulas_.beta_h);
    }
    const Stopwatch watch(costs_.solve);
    return jacobian_.factorize();
}

bool StepProblem::solve(Eigen::VectorXd& x) {
    const Stopwatch watch(costs_.solve);
    return jacobian_.solve(x);
}

void StepProblem::solve_inertia(Eigen::VectorXd& x) const {
    for (std::size_t b = 0; b < trial_.size(); ++b) {
        const auto row = static_cast<Eigen::Index>(6 * b);
        if (!system_.bodies[b].dynamic()) {
            x.segment<6>(row).setZero();
            continue;
        }
        const Mat6 block = inertia_block(system_.bodies[b], trial_[b], formulas_.beta_h);
        x.segment<3>(row) /= block(0, 0);
        x.segment<3>(row + 3) = block.bottomRightCorner<3, 3>().inverse() * x.segment<3>(row + 3);
    }
}

void StepProblem::new_states(std::vector<BodyState>& states) const {
    states = system_.states;
    for (std::size_t b = 0; b < trial_.size(); ++b) {
        const Body& body = system_.bodies[b];
        const TrialBody& trial = trial_[b];
        states[b].position = trial.pose.position;
        states[b].orientation = trial.pose.orientation;
        if (!body.dynamic()) {
            states[b].momentum = trial.velocity;
            states[b].angular_momentum = trial.spin;
            continue;
        }
        if (touched_[b] || body.restraint != nullptr) {
            states[b].momentum = body.mass * trial.velocity;
            states[b].angular_momentum = world_inertia(body, trial.pose.orientation) * trial.spin;
        } else {
            states[b].momentum = starts_[b].momentum + formulas_.beta_h * force_[b];
            states[b].angular_momentum = starts_[b].angular_momentum + formulas_.beta_h * torque_[b];
        }
    }
}

}  // namespace scree
