#include <scree/bdf/group.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scree {

namespace {

constexpr double generosity = 2;     // over what a body that left its cover asked for
constexpr double calm_speed = 1e-3;  // of the tolerance, in units of √(gℓ)
constexpr double calm_force = 1e-3;  // of the weight, that may be out of balance
constexpr std::size_t calm_meetings = 3;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

bool same_pose(const Pose& a, const Pose& b) {
    return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

bool same_collider(const Collider& a, const Collider& b) {
    return a.shape == b.shape && same_pose(a.local, b.local);
}

// What acts on a body from outside, or where a prescribed body is led.
bool same_influence(const Body& a, const BodyState& state_a, const Body& b, const BodyState& state_b) {
    if (!a.dynamic()) {
        return state_a.momentum == state_b.momentum && state_a.angular_momentum == state_b.angular_momentum;
    }
    return a.weight == b.weight && a.force == b.force && a.torque == b.torque && a.restraint == b.restraint;
}

}  // namespace

Group::Group(std::vector<int> bodies, const ContactForces& forces, const SteppingOptions& options,
             Workers* workers)
    : bodies_(std::move(bodies)),
      options_(options),
      integrator_(make_integrator(system_, forces, options, workers)) {
    integrator_->set_covered([this](std::span<const TrialBody> trial) { return covered(trial); });
}

int Group::place_of(int body) const {
    const auto found = std::lower_bound(bodies_.begin(), bodies_.end(), body);
    return found != bodies_.end() && *found == body ? static_cast<int>(found - bodies_.begin()) : -1;
}

bool Group::renumber(std::span<const int> new_numbers) {
    for (int& body : bodies_) {
        body = new_numbers[at(body)];
    }
    return bodies_.empty() || *std::min_element(bodies_.begin(), bodies_.end()) >= 0;
}

void Group::load(System& whole, std::span<const std::size_t> contacts, double time) {
    const bool same = same_contacts(whole, contacts);
    if (arrived_ && same && !restart_) {
        contacts_.assign(contacts.begin(), contacts.end());
        return;
    }
    arrived_ = false;
    const bool influenced = load_bodies(whole);
    load_contacts(whole, contacts);
    if (asleep_ && same && !influenced && !restart_) {
        return;
    }
    const bool woken = asleep_;
    asleep_ = false;
    results_.clear();
    calm_ = woken || restart_ ? 0 : calm_;
    if (restart_ || woken || start_.past.count() == 0) {
        asleep_ = stopped_from_outside(whole, time);
        integrator_->restart(time);
        restart_ = false;
        start_ = integrator_->memory();
        if (asleep_) {
            const std::span<const ContactResult> own = integrator_->problem().results();
            results_.assign(own.begin(), own.end());
        }
        hand_back(whole);
        return;
    }
    if (influenced) {
        start_.powers.reset();
        for (std::size_t i = 0; i < influences_.size(); ++i) {
            assume(i);
        }
    }
    integrator_->resume(start_);
}

// The past of a body that nothing touches as if the forces had been what they are now: contacts answer a jump
// within a time that is short against a step. The held axes of a restraint take none of it.
void Group::assume(std::size_t i) {
    const Body& body = system_.bodies[i];
    const bool touched =
        std::any_of(system_.contacts.begin(), system_.contacts.end(), [&](const Contact& contact) {
            return contact.history.age > 0 && (at(contact.a.body) == i || at(contact.b.body) == i);
        });
    if (body.dynamic() && !touched && (!influences_[i].force.isZero(0) || !influences_[i].torque.isZero(0))) {
        const Vec3 along = body.restraint != nullptr ? body.restraint->along : Vec3::Ones();
        const Vec3 around = body.restraint != nullptr ? body.restraint->around : Vec3::Ones();
        start_.past.assume(i, body, along.cwiseProduct(influences_[i].force),
                           around.cwiseProduct(influences_[i].torque));
    }
}

bool Group::load_bodies(const System& whole) {
    const bool known = system_.bodies.size() == bodies_.size();
    influences_.assign(known ? bodies_.size() : 0, {});
    system_.bodies.resize(bodies_.size());
    system_.states.resize(bodies_.size());
    bool influenced = false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = whole.bodies[at(bodies_[i])];
        const BodyState& state = whole.states[at(bodies_[i])];
        influenced = influenced || !same_influence(system_.bodies[i], system_.states[i], body, state);
        if (known) {
            const Body& before = system_.bodies[i];
            influences_[i] = {body.weight + body.force - before.weight - before.force,
                              body.torque - before.torque};
        }
        system_.bodies[i] = body;
        system_.states[i] = state;
    }
    return influenced;
}

void Group::load_contacts(const System& whole, std::span<const std::size_t> contacts) {
    contacts_.assign(contacts.begin(), contacts.end());
    system_.contacts.resize(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Contact& contact = system_.contacts[i];
        contact = whole.contacts[contacts[i]];
        contact.a.body = place_of(contact.a.body);
        contact.b.body = place_of(contact.b.body);
    }
    if (!leaders_.empty()) {
        shorten_memories();
    }
}

bool Group::same_contacts(const System& whole, std::span<const std::size_t> contacts) const {
    return std::equal(contacts.begin(), contacts.end(), system_.contacts.begin(), system_.contacts.end(),
                      [&](std::size_t number, const Contact& mine) {
                          const Contact& other = whole.contacts[number];
                          return bodies_[at(mine.a.body)] == other.a.body &&
                                 bodies_[at(mine.b.body)] == other.b.body && same_collider(mine.a, other.a) &&
                                 same_collider(mine.b, other.b) && mine.geometry == other.geometry;
                      });
}

void Group::begin_with(MergedMemory merged) {
    start_ = std::move(merged.memory);
    restart_ = start_.past.count() == 0;
    if (merged.leader != nullptr) {
        leaders_ = merged.leader->bodies();
    }
}

// What other contacts than the leader's remember belongs to other times than the group's past.
void Group::shorten_memories() {
    const auto led = [&](const Collider& collider) {
        return std::binary_search(leaders_.begin(), leaders_.end(), bodies_[at(collider.body)]);
    };
    for (Contact& contact : system_.contacts) {
        if (!led(contact.a) || !led(contact.b)) {
            contact.history.shorten();
        }
    }
}

StepOutcome Group::advance(double end, std::span<const BodyCover> covers, std::span<double> demand) {
    if (asleep_) {
        arrived_ = true;
    }
    if (arrived_) {
        return StepOutcome::accepted;
    }
    covers_ = covers;
    demand_ = demand;
    while (integrator_->time() < end) {
        if (const StepOutcome outcome = integrator_->step(end); outcome != StepOutcome::accepted) {
            failed_ = outcome == StepOutcome::failed;
            return outcome;
        }
    }
    arrived_ = true;
    return StepOutcome::accepted;
}

// Groups share none of their dynamic bodies, and the others ask for nothing, so each demand has one writer.
bool Group::covered(std::span<const TrialBody> trial) {
    bool all = true;
    for (std::size_t i = 0; i < bodies_.size() && !covers_.empty(); ++i) {
        if (!system_.bodies[i].dynamic()) {
            continue;
        }
        const BodyCover& cover = covers_[at(bodies_[i])];
        const double moved = largest_move(cover.about, trial[i].pose, cover.radius);
        if (!(moved <= cover.reach)) {
            if (!std::isfinite(moved)) {
                throw std::runtime_error("a body's pose is not finite");
            }
            demand_[at(bodies_[i])] = generosity * moved;
            all = false;
        }
    }
    return all;
}

void Group::hand_back(System& whole) const {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        whole.contacts[contacts_[i]].history = system_.contacts[i].history;
    }
}

void Group::commit(System& whole, std::vector<ContactResult>& results) {
    arrived_ = false;
    const std::span<const ContactResult> own = asleep_ ? results_ : integrator_->problem().results();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        results[contacts_[i]] = own[i];
    }
    if (asleep_) {
        return;
    }
    hand_back(whole);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (system_.bodies[i].dynamic()) {
            whole.states[at(bodies_[i])] = system_.states[i];
        }
    }
    start_ = integrator_->memory();
    leaders_.clear();
    calm_ = may_rest() && at_rest() ? calm_ + 1 : 0;
    asleep_ = calm_ >= calm_meetings;
    if (asleep_) {
        results_.assign(own.begin(), own.end());
    }
}

void Group::go_on(const System& whole, std::span<const std::size_t> contacts) {
    load_bodies(whole);
    load_contacts(whole, contacts);
    const std::size_t count = start_.past.count();
    bool fits = start_.order > 0 && results_.size() == (asleep_ ? contacts.size() : 0);
    for (std::size_t j = 0; j < count; ++j) {
        fits = fits && start_.past.states(j).size() == bodies_.size();
    }
    for (const std::vector<Vec3>* list : {&start_.force, &start_.torque}) {
        fits = fits && (count == 0 || list->size() == bodies_.size());
    }
    StateReader::require(fits);
    integrator_->recall(start_);
    restart_ = false;
}

// A prescribed body that moves, or will again, or whose surface does, works on what lies against it.
bool Group::drives(const Body& body, const BodyState& state, double time) {
    if (state.momentum != Vec3::Zero() || state.angular_momentum != Vec3::Zero()) {
        return true;
    }
    return body.path != nullptr &&
           (std::isfinite(body.path->time_scale()) || body.path->at(time).surface_velocity != Vec3::Zero());
}

bool Group::may_rest() const {
    return std::all_of(system_.bodies.begin(), system_.bodies.end(), [&](const Body& body) {
        return !body.dynamic() || body.rest == Rest::wanted || body.rest == Rest::from_outside ||
               (body.rest == Rest::by_option && options_.sleep);
    });
}

// All or none: whoever stops loses its momentum.
bool Group::stopped_from_outside(System& whole, double time) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = system_.bodies[i];
        if (body.dynamic() ? body.rest != Rest::from_outside : drives(body, system_.states[i], time)) {
            return false;
        }
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (system_.bodies[i].dynamic()) {
            system_.states[i].momentum = system_.states[i].angular_momentum = Vec3::Zero();
            whole.states[at(bodies_[i])] = system_.states[i];
        }
    }
    return true;
}

// Next to no motion, and forces in balance.
bool Group::at_rest() const {
    const Tolerances& tolerances = options_.tolerances;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = system_.bodies[i];
        const BodyState& state = system_.states[i];
        if (!body.dynamic()) {
            if (drives(body, state, integrator_->time())) {
                return false;
            }
            continue;
        }
        const double speed = velocity(body, state).norm() + spin(body, state).norm() * body.radius;
        const double falling = std::sqrt(tolerances.gravity * body.radius);
        const double force = integrator_->problem().forces()[i].norm() +
                             integrator_->problem().torques()[i].norm() / body.radius;
        if (!(speed <= calm_speed * tolerances.sum() * falling) ||
            !(force <= calm_force * body.mass * tolerances.gravity)) {
            return false;
        }
    }
    return true;
}

}  // namespace scree
