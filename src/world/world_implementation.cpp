#include "world_implementation.hpp"

#include <algorithm>
#include <stdexcept>

#include <scree/detect/convert.hpp>

#include "stopwatch.hpp"

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
    const bool stepped = guarded([&] {
        find_pairs(world, end);
        step_to(world, end);
    });
    write_bodies(tick);
    accounts_.fill(*integrator_, report_);
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
        restart_ = constants_changed_ = true;
    }
    call_left_ = std::max(call_left_, tick);
    const Changes changes = bodies_.read(tick, call_left_);
    restart_ = restart_ || changes.states;
    constants_changed_ = constants_changed_ || changes.constants;
}

void WorldImplementation::prepare(double gravity) {
    if (gravity != options_.tolerances.gravity) {
        SteppingOptions options = options_;
        options.tolerances.gravity = gravity;
        replace_integrator(options);
        constants_changed_ = true;
    }
    if (constants_changed_) {
        materials_.prepare(bodies_.all(), system_.bodies, gravity);
        for (Contact& contact : system_.contacts) {
            contact.pair = constants(contact.a.body, contact.b.body);
        }
        constants_changed_ = false;
    }
}

void WorldImplementation::find_pairs(btCollisionWorld& world, double end) {
    const Stopwatch watch(report_.times.detection);
    const double now = restart_ ? clock_.now() : integrator_->time();
    cover_.lay(system_, bodies_.all(), end - now, integrator_->last_step());
    const bool renewed = list_.renew(search_.find(world, cover_.bodies()),
                                     [this](const PartPair& pair) { return make_contact(pair); });
    if (renewed) {
        integrator_->contacts_renewed();
    }
    law_.choose(system_.contacts);
    ++report_.pair_searches;
}

void WorldImplementation::step_to(btCollisionWorld& world, double end) {
    const double detection = report_.times.detection;
    const Stopwatch watch(report_.times.stepping);
    integrator_->set_covered([&](std::span<const TrialBody> trial) {
        const bool covered = cover_.holds(trial);
        if (!covered) {
            find_pairs(world, end);
        }
        return covered;
    });
    if (restart_) {
        integrator_->restart(clock_.now());
        restart_ = false;
    }
    while (!system_.bodies.empty() && integrator_->time() < end) {
        if (!cover_.lasts(system_, end - integrator_->time(), integrator_->last_step())) {
            find_pairs(world, end);
        }
        const SteppingStatistics before = integrator_->statistics();
        if (!integrator_->step(end)) {
            throw std::runtime_error(why_no_step(*integrator_, before));
        }
    }
    report_.times.stepping -= report_.times.detection - detection;
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
    }
    bodies_.write(!report_.failed && call_left_ < 0.5 * tick);
    const bool started = !restart_ && !system_.bodies.empty();
    report_.time = started ? integrator_->time() : clock_.now();
}

void WorldImplementation::update_manifolds(btCollisionWorld& world, double tick) {
    const Stopwatch watch(report_.times.detection);
    manifolds_.update(world, bodies_.all(), system_, results(), tick);
    report_.manifold_pairs = manifolds_.pairs();
}

std::span<const ContactResult> WorldImplementation::results() const {
    if (integrator_->problem().results().size() != system_.contacts.size()) {
        return {};
    }
    return integrator_->problem().results();
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

void WorldImplementation::set_stepping(const SteppingOptions& options) {
    SteppingOptions with_gravity = options;
    with_gravity.tolerances.gravity = options_.tolerances.gravity;
    replace_integrator(with_gravity);
}

// An integrator lives as long as its options; what the old one has counted is kept.
void WorldImplementation::replace_integrator(const SteppingOptions& options) {
    integrator_ = make_integrator(system_, law_, options);
    accounts_.close(report_);
    options_ = options;
    restart_ = true;
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
