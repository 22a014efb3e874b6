#include "world_implementation.hpp"

#include <algorithm>
#include <stdexcept>

#include <scree/detect/convert.hpp>

#include <scree/dynamics/stopwatch.hpp>

namespace scree {

bool WorldImplementation::run(btCollisionWorld& world, double tick, double gravity) {
    const double end = clock_.next(tick);
    const bool read = guarded([&] {
        read_bodies(tick);
        prepare(gravity);
    });
    if (!read) {
        return false;
    }
    for (btCollisionObject* reshaped : bodies_.take_reshaped()) {
        forget_algorithms(world, *reshaped);
    }
    const bool stepped = guarded([&] { step_to(world, end); });
    write_bodies(tick);
    take_accounts();
    report_contacts(system_, results(), report_);
    return stepped;
}

// Nothing is thrown out of a tick: what goes wrong in it is reported.
bool WorldImplementation::guarded(const std::function<void()>& part) {
    try {
        part();
    } catch (const std::exception& error) {
        report_.failed = true;
        report_.message = error.what();
    }
    return !report_.failed;
}

void WorldImplementation::read_bodies(double tick) {
    if (const std::vector<int> numbers = bodies_.drop_removed(); !numbers.empty()) {
        list_.renumber(numbers);
        groups_.renumber(numbers);
        changed_ = constants_changed_ = true;
    }
    call_left_ = std::max(call_left_, tick);
    const Changes changes = bodies_.read(clock_.now(), tick, call_left_);
    for (const int body : changes.bodies) {
        groups_.restart(body);
    }
    changed_ = changed_ || changes.any;
    constants_changed_ = constants_changed_ || changes.constants;
}

void WorldImplementation::prepare(double gravity) {
    if (gravity != options_.tolerances.gravity || options_changed_) {
        options_.tolerances.gravity = gravity;
        groups_.set(law_, options_, workers_.get());
        options_changed_ = false;
        changed_ = constants_changed_ = true;
    }
    if (constants_changed_) {
        materials_.prepare(bodies_.all(), system_.bodies, gravity);
        for (Contact& contact : system_.contacts) {
            contact.pair = constants(contact.a.body, contact.b.body);
        }
        constants_changed_ = false;
    }
}

void WorldImplementation::step_to(btCollisionWorld& world, double end) {
    const double detection = report_.times.detection;
    const Stopwatch watch(report_.times.stepping);
    groups_.forget();
    for (double now = clock_.now(); now < end;) {
        now = to_meeting(world, now, end);
    }
    report_.times.stepping -= report_.times.detection - detection;
}

// Detect, deal the bodies out to groups, step each, and let them meet. Returns the time of the meeting.
double WorldImplementation::to_meeting(btCollisionWorld& world, double now, double end) {
    const double meeting = choose_meeting(world, now, end);
    deal(now);
    StepOutcome outcome = groups_.advance(meeting, cover_.regions(), demand_);
    while (outcome == StepOutcome::left_cover) {
        cover_.widen(demand_);
        find_pairs(world);
        deal(now);
        outcome = groups_.advance(meeting, cover_.regions(), demand_);
    }
    if (outcome == StepOutcome::failed) {
        throw std::runtime_error(why_no_step(*groups_.failed()));
    }
    groups_.commit(meeting);
    account_.settle(system_, groups_.take_flows());
    report_.time = meeting;
    return meeting;
}

double WorldImplementation::choose_meeting(btCollisionWorld& world, double now, double end) {
    const double span = plan_.choose(end - now, options_.fixed_step, system_, [&](double duration) {
        cover_.lay(system_, bodies_.all(), now, duration);
        find_pairs(world);
    });
    return span == end - now ? end : now + span;
}

void WorldImplementation::find_pairs(btCollisionWorld& world) {
    const Stopwatch watch(report_.times.detection);
    list_.renew(search_.find(world, cover_.bodies()),
                [this](const PartPair& pair) { return make_contact(pair); });
    law_.choose(system_.contacts);
    ++report_.pair_searches;
}

void WorldImplementation::deal(double now) {
    groups_.deal(now);
    if (changed_) {
        account_.open(system_);
        changed_ = false;
    }
}

void WorldImplementation::take_accounts() {
    const Groups::Counts counts = groups_.take_counts();
    report_.steps.add(counts.leading);
    report_.all_steps.add(counts.all);
    report_.energy = account_.ledger();
    report_.momentum_residual = account_.momentum_residual();
}

Contact WorldImplementation::make_contact(const PartPair& pair) const {
    const auto collider = [this](int body, int part) -> Collider {
        const WorldBody& owner = bodies_.all()[static_cast<std::size_t>(body)];
        const BodyPart& own = owner.shape.parts[static_cast<std::size_t>(part)];
        return {body, own.shape.get(), own.local};
    };
    return {collider(pair.body_a, pair.part_a),
            collider(pair.body_b, pair.part_b),
            constants(pair.body_a, pair.body_b),
            {}};
}

PairConstants WorldImplementation::constants(int a, int b) const {
    return materials_.constants(bodies_.all(), system_.bodies, static_cast<std::size_t>(a),
                                static_cast<std::size_t>(b));
}

void WorldImplementation::write_bodies(double tick) {
    call_left_ -= tick;
    if (!report_.failed) {
        clock_.advance();
        ++report_.ticks;
        report_.time = clock_.now();
    }
    bodies_.write(!report_.failed && call_left_ < 0.5 * tick);
}

void WorldImplementation::update_manifolds(btCollisionWorld& world, double tick) {
    const Stopwatch watch(report_.times.detection);
    manifolds_.update(world, bodies_.all(), system_, results(), tick);
    report_.manifold_pairs = manifolds_.pairs();
}

std::span<const ContactResult> WorldImplementation::results() const {
    return groups_.results().size() == system_.contacts.size() ? groups_.results()
                                                               : std::span<const ContactResult>();
}

void WorldImplementation::place(btCollisionWorld& world) {
    std::vector<SearchBody> present;
    for (const WorldBody& body : bodies_.all()) {
        if (body.object != nullptr) {
            present.push_back(
                {body.object, &body.shape, to_eigen(body.object->getWorldTransform()), 0, false});
        }
    }
    search_.place(world, present);
}

void WorldImplementation::set_threads(std::size_t threads) {
    workers_ = std::make_unique<Workers>(threads);
    groups_.set_workers(workers_.get());
}

void WorldImplementation::set_stepping(const SteppingOptions& options) {
    System none;
    make_integrator(none, law_, options);  // refuses what no method has
    options_ = options;
    options_changed_ = true;
}

Material WorldImplementation::material(const btRigidBody& body, double gravity) const {
    const int number = bodies_.number(body);
    if (number < 0) {
        throw std::invalid_argument("a body that is not in this world has no material here");
    }
    return materials_.of(bodies_.all()[static_cast<std::size_t>(number)],
                         system_.bodies[static_cast<std::size_t>(number)], gravity);
}

}  // namespace scree
