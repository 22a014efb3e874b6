#pragma once

#include <functional>
#include <memory>
#include <string>

#include <scree/bdf/integrator.hpp>
#include <scree/world/step_report.hpp>

#include "accounts.hpp"
#include "bodies.hpp"
#include "contact_list.hpp"
#include "cover.hpp"
#include "law_choice.hpp"
#include "manifolds.hpp"
#include "materials.hpp"
#include "tick_clock.hpp"

namespace scree {

/// What a DynamicsWorld does in a tick.
class WorldImplementation {
  public:
    explicit WorldImplementation(btDispatcher* dispatcher) : manifolds_(dispatcher) {}

    Manifolds& manifolds() { return manifolds_; }
    Bodies& bodies() { return bodies_; }
    Materials& materials() { return materials_; }
    LawChoice& law() { return law_; }
    [[nodiscard]] const System& system() const { return system_; }
    [[nodiscard]] const StepReport& report() const { return report_; }
    [[nodiscard]] std::span<const ContactResult> results() const;

    void set_stepping(const SteppingOptions& options);
    void constants_changed() { constants_changed_ = true; }
    [[nodiscard]] Material material(const btRigidBody& body, double gravity) const;

    /// stepSimulation is about to run for `time` [s], after which prescribed bodies are at their targets.
    void begin_call(double time) { call_left_ = time; }
    /// One tick of `tick` [s] in a gravity [m/s²]. Returns false when it could not be finished.
    bool run(btCollisionWorld& world, double tick, double gravity);
    /// Brings Bullet's manifolds up to date after a tick of `tick` [s].
    void update_manifolds(btCollisionWorld& world, double tick);
    /// Tells the broadphase where Bullet has the bodies at present.
    void place(btCollisionWorld& world);

  private:
    bool guarded(const std::function<void()>& part);
    void read_bodies(double tick);
    void prepare(double gravity);
    void replace_integrator(const SteppingOptions& options);
    void find_pairs(btCollisionWorld& world, double end);
    void step_to(btCollisionWorld& world, double end);
    [[nodiscard]] Contact make_contact(const PartPair& pair) const;
    [[nodiscard]] PairConstants constants(int a, int b) const;
    void write_bodies(double tick);

    System system_;
    Bodies bodies_{system_};
    Materials materials_;
    LawChoice law_;
    ContactList list_{system_.contacts};
    Cover cover_;
    PairSearch search_;
    Manifolds manifolds_;
    SteppingOptions options_;
    std::unique_ptr<Integrator> integrator_ = make_integrator(system_, law_, options_);
    TickClock clock_;
    StepReport report_;
    Accounts accounts_;
    double call_left_ = 0;
    bool restart_ = true;
    bool constants_changed_ = true;
};

}  // namespace scree
