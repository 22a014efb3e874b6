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
    forget_contacts_of(changes.moved);
    changed_ = changed_ || changes.any;
    constants_changed_ = constants_changed_ || changes.constants;
}

// A body was put elsewhere: its springs belonged to where it was.
void WorldImplementation::forget_contacts_of(std::span<const int> bodies) {
    if (bodies.empty()) {
        return;
    }
    const auto among = [&](int body) { return std::binary_search(bodies.begin(), bodies.end(), body); };
    for (Contact& contact : system_.contacts) {
        if (among(contact.a.body) || among(contact.b.body)) {
            contact.history = {};
        }
    }
}

void WorldImplementation::law_changed() {
    for (Contact& contact : system_.contacts) {
        contact.history = {};
    }
    options_changed_ = true;
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
        freeze(world, now);
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
    cover_.set_margins(manifold_contacts_.all() || bodies_.any_open());
    const double left = manifold_contacts_.most_span(system_, end - now);
    const double span = plan_.choose(left, options_.fixed_step, system_, [&](double duration) {
        cover_.lay(system_, bodies_.all(), now, duration);
        find_pairs(world);
    });
    freeze(world, now);
    return span == end - now ? end : now + span;
}

void WorldImplementation::find_pairs(btCollisionWorld& world) {
    const Stopwatch watch(report_.times.detection);
    list_.renew(search_.find(world, cover_.bodies()),
                [this](const PartPair& pair) { return make_contact(pair); });
    law_.choose(system_.contacts);
    ++report_.pair_searches;
}

void WorldImplementation::freeze(btCollisionWorld& world, double now) {
    const Stopwatch watch(report_.times.detection);
    manifold_contacts_.freeze(world.getDispatchInfo(), system_, cover_.bodies(), now);
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

Contact WorldImplementation::make_contact(const PartPair& pair) {
    const WorldBody& a = bodies_.all()[static_cast<std::size_t>(pair.body_a)];
    const WorldBody& b = bodies_.all()[static_cast<std::size_t>(pair.body_b)];
    const BodyPart& part_a = a.shape.parts[static_cast<std::size_t>(pair.part_a)];
    const BodyPart& part_b = b.shape.parts[static_cast<std::size_t>(pair.part_b)];
    Contact contact;
    contact.a = {pair.body_a, part_a.shape.get(), part_a.local};
    contact.b = {pair.body_b, part_b.shape.get(), part_b.local};
    contact.pair = constants(pair.body_a, pair.body_b);
    if (manifold_contacts_.wanted(part_a, part_b)) {
        contact.geometry =
            manifold_contacts_.make({a.object, part_a, pair.part_a}, {b.object, part_b, pair.part_b});
    }
    return contact;
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
    bodies_.write(!report_.failed && call_left_ < 0.5 * tick, groups_);
}

void WorldImplementation::update_manifolds(btCollisionWorld& world, double tick) {
    const Stopwatch watch(report_.times.detection);
    manifolds_.update(world, bodies_, system_, results(), tick);
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

// All contacts are made anew.
void WorldImplementation::set_contact_geometry(GeometrySource source, btCollisionWorld& world) {
    if (manifold_contacts_.all() == (source == GeometrySource::manifold)) {
        return;
    }
    manifold_contacts_.set_all(source == GeometrySource::manifold);
    manifolds_.clear(world);
    manifolds_.use_overlaps(!manifold_contacts_.all());
    list_.clear();
    options_changed_ = true;
}

void WorldImplementation::remove(const btCollisionObject& object) {
    manifold_contacts_.forget(object);
    bodies_.remove(object);
    materials_.forget(object);
}

void WorldImplementation::set_stepping(const SteppingOptions& options) {
    System none;
    make_integrator(none, law_, options);  // refuses what no method has
    options_ = options;
    options_changed_ = true;
}

PairMaterial WorldImplementation::pair_material(const btRigidBody& a, const btRigidBody& b, double gravity) {
    const int one = bodies_.number(a);
    const int other = bodies_.number(b);
    if (one < 0 || other < 0) {
        throw std::invalid_argument("a body that is not in this world has no material here");
    }
    materials_.prepare(bodies_.all(), system_.bodies, gravity);
    return materials_.pair(bodies_.all(), system_.bodies, static_cast<std::size_t>(std::min(one, other)),
                           static_cast<std::size_t>(std::max(one, other)));
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
