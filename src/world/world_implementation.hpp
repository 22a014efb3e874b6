#pragma once

#include <functional>
#include <memory>
#include <string>

#include <scree/bdf/groups.hpp>
#include <scree/world/dynamics_world.hpp>
#include <scree/world/step_report.hpp>

#include "accounts.hpp"
#include "bodies.hpp"
#include "contact_list.hpp"
#include "cover.hpp"
#include "law_choice.hpp"
#include "manifold_contacts.hpp"
#include "manifolds.hpp"
#include "materials.hpp"
#include "meeting_plan.hpp"
#include "tick_clock.hpp"

namespace scree {

/// What a DynamicsWorld does in a tick.
class WorldImplementation {
  public:
    explicit WorldImplementation(btDispatcher& dispatcher)
        : manifold_contacts_(dispatcher), manifolds_(&dispatcher, manifold_contacts_) {}

    Manifolds& manifolds() { return manifolds_; }
    Bodies& bodies() { return bodies_; }
    Materials& materials() { return materials_; }
    LawChoice& law() { return law_; }
    [[nodiscard]] const System& system() const { return system_; }
    [[nodiscard]] const StepReport& report() const { return report_; }
    [[nodiscard]] std::span<const ContactResult> results() const;

    void set_threads(std::size_t threads);
    void set_stepping(const SteppingOptions& options);
    void set_contact_geometry(GeometrySource source, btCollisionWorld& world);
    /// Before Bullet's own part.
    void remove(const btCollisionObject& object);
    void constants_changed() { constants_changed_ = true; }
    /// What contacts remember belongs to another law.
    void law_changed();
    [[nodiscard]] Material material(const btRigidBody& body, double gravity) const;
    [[nodiscard]] PairMaterial pair_material(const btRigidBody& a, const btRigidBody& b, double gravity);

    /// stepSimulation is about to run for `time` [s], after which prescribed bodies are at their targets.
    void begin_call(double time) { call_left_ = time; }
    /// One tick of `tick` [s] in a gravity [m/s²]. Returns false when it could not be finished.
    bool run(btCollisionWorld& world, double tick, double gravity);
    /// Brings Bullet's manifolds up to date after a tick of `tick` [s].
    void update_manifolds(btCollisionWorld& world, double tick);
    /// Tells the broadphase where Bullet has the bodies at present.
    void place(btCollisionWorld& world);

    /// What is carried from one tick to the next.
    void save(StateWriter& with) const;
    /// Of a world that has no tick behind it. Throws StateError.
    void restore(StateReader& with, btCollisionWorld& world, double gravity);

    /// All but the contacts and the groups.
    friend void visit_state(auto& with, StateOf<WorldImplementation> auto& world) {
        auto& [system, bodies, materials, law, list, cover, search, manifold_contacts, manifolds, options,
               workers, groups, plan, demand, clock, account, report, call_left, options_changed, changed,
               constants_changed] = world;
        with.each(system.bodies);
        with.each(system.states);
        with(list, plan, clock, account, report);
    }

  private:
    bool guarded(const std::function<void()>& part);
    void read_bodies(double tick);
    void prepare(double gravity);
    void forget_contacts_of(std::span<const int> bodies);
    void step_to(btCollisionWorld& world, double end);
    double to_meeting(btCollisionWorld& world, double now, double end);
    double choose_meeting(btCollisionWorld& world, double now, double end);
    void find_pairs(btCollisionWorld& world);
    void freeze(btCollisionWorld& world, double now);
    void deal(double now);
    void take_accounts();
    [[nodiscard]] Contact make_contact(const PartPair& pair);
    [[nodiscard]] PairConstants constants(int a, int b) const;
    [[nodiscard]] bool possible(std::span<const PartPair> pairs) const;
    void write_bodies(double tick);

    System system_;
    Bodies bodies_{system_};
    Materials materials_;
    LawChoice law_;
    ContactList list_{system_.contacts};
    Cover cover_;
    PairSearch search_;
    ManifoldContacts manifold_contacts_;
    Manifolds manifolds_;
    SteppingOptions options_;
    std::unique_ptr<Workers> workers_ = std::make_unique<Workers>(1);
    Groups groups_{system_};
    MeetingPlan plan_;
    std::vector<double> demand_;
    TickClock clock_;
    EnergyAccount account_;
    StepReport report_;
    double call_left_ = 0;
    bool options_changed_ = true;
    bool changed_ = true;  ///< from outside since the last tick
    bool constants_changed_ = true;
};

}  // namespace scree
