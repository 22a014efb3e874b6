#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <memory>

#include <scree/bdf/integrator.hpp>
#include <scree/contact/material.hpp>
#include <scree/world/step_report.hpp>

static_assert(sizeof(btScalar) == 8, "scree needs Bullet's double-precision build");

namespace scree {

class WorldImplementation;

/// Where contacts get their geometry.
enum class GeometrySource {
    overlap,   ///< the volume that the exact shapes share
    manifold,  ///< Bullet's own points, each a spring of stiffness Y Lc/N
};

/// A Bullet world whose contacts are forces: Bullet finds the pairs, the overlap of the exact shapes gives
/// the force, and an implicit, error-controlled method of the BDF family steps the bodies. Construct it where
/// a btDiscreteDynamicsWorld stood.
///
/// One tick is one fixed step of stepSimulation; within it the method takes as many steps as it needs,
/// keeping its history over the tick's end. Forces set from outside are constant within a tick; a pose or
/// velocity set from outside starts the method afresh.
///
/// With SteppingOptions::sleep, bodies that have come to rest sleep: their activation state is
/// ISLAND_SLEEPING until something reaches them or somebody changes anything about them. Without it none
/// falls asleep of itself, but one that is in WANTS_DEACTIVATION. Bodies that are put in ISLAND_SLEEPING from
/// outside stop where they are if nobody near them is awake. DISABLE_DEACTIVATION keeps a body and its group
/// awake, and DISABLE_SIMULATION makes it a fixed one.
class DynamicsWorld : public btDiscreteDynamicsWorld {
  public:
    /// As btDiscreteDynamicsWorld; the solver is not used and may be null.
    DynamicsWorld(btDispatcher* dispatcher, btBroadphaseInterface* pairs, btConstraintSolver* solver,
                  btCollisionConfiguration* configuration);
    ~DynamicsWorld() override;
    DynamicsWorld(const DynamicsWorld&) = delete;
    DynamicsWorld& operator=(const DynamicsWorld&) = delete;

    /// How the steps are made; takes effect with the next tick, which starts afresh. The scale of gravity
    /// among the tolerances is the world's own. Throws std::invalid_argument for options that no method has.
    void set_stepping(const SteppingOptions& options);

    /// How many threads share out the work; 1 at first. The results are the same bytes for any number. Throws
    /// std::invalid_argument for 0.
    void set_threads(std::size_t threads);

    /// What a body is made of, until it is removed. A body without one gets what its Bullet friction,
    /// restitution and mass suggest; see automatic_material.hpp.
    void set_material(const btRigidBody& body, const Material& material);
    /// What was set, or derived. A body without mass or material has an infinite Young's modulus, which means
    /// that of whatever it touches.
    [[nodiscard]] Material material(const btRigidBody& body) const;
    /// What holds between two bodies of this world: by the mixing set, by the mixing rules, or, where neither
    /// was given a material, by what Bullet combines.
    [[nodiscard]] PairMaterial pair_material(const btRigidBody& a, const btRigidBody& b) const;
    /// Overrides the mixing rules: called with the two materials, in the order of the bodies.
    using Mixing =
        std::function<PairMaterial(const btRigidBody&, const Material&, const btRigidBody&, const Material&)>;
    /// Takes effect with the next tick; an empty one: the mixing rules.
    void set_mixing(Mixing mixing);

    /// From the next tick on a body moves along a path, whatever forces and Bullet say; its pose and
    /// velocities are handed to Bullet at the end of each tick. The path's time is step_report().time. Null:
    /// as Bullet has it again. Throws std::invalid_argument for a body that is not in this world.
    void set_path(const btRigidBody& body, std::shared_ptr<const PrescribedPath> path);

    /// Replaces the contact law by any type that models scree::ContactLaw.
    template <ContactLaw Law>
    void set_contact_law(Law law) {
        set_forces(std::make_unique<ForcesOf<Law>>(std::move(law)));
    }
    /// The built-in law, with the parts that the materials ask for and other choices than it has by default.
    /// Cundall and Strack's law in two dimensions is right as long as all bodies move in the x–z plane.
    void set_contact_law(FrictionLaw friction, const LawOptions& options = {});
    /// Null: the built-in law, with the parts that the materials ask for.
    void set_forces(std::unique_ptr<ContactForces> forces);

    /// The law of the contacts between bodies of two materials alone, whether those were set or derived. They
    /// are told by their values; what is set last counts.
    template <ContactLaw Law>
    void set_contact_law(const Material& a, const Material& b, Law law) {
        set_forces(a, b, std::make_unique<ForcesOf<Law>>(std::move(law)));
    }
    /// Null: the law of all other pairs.
    void set_forces(const Material& a, const Material& b, std::unique_ptr<ContactForces> forces);

    /// Where the contacts' geometry comes from: the overlap, if nothing is said. Bullet's manifolds are found
    /// once a tick and frozen in the bodies until the next; meshes of triangles and height fields, which have
    /// no overlap, have them in any case. All contacts are made anew.
    void set_contact_geometry(GeometrySource source);

    /// Whether Bullet's manifolds are brought up to date at the end of every tick, as they are from the
    /// start: for contact callbacks, for programs that go through the dispatcher's manifolds, and for debug
    /// drawing. Their points are corners of the patches of the overlap, at most four, and have the impulse
    /// over a tick of the forces at its end. Without it contacts cost nothing on Bullet's side.
    void set_manifolds(bool written);

    /// What the ticks so far have done, and why the last one stopped if it did. After a failure ticks do
    /// nothing.
    [[nodiscard]] const StepReport& step_report() const;

    /// The bodies, states and contacts as of the end of the last tick; body numbers are those of
    /// body_number(). A body added since then is there already, one removed since then still is.
    [[nodiscard]] const System& system() const;
    /// What each of system().contacts did at the last accepted step.
    [[nodiscard]] std::span<const ContactResult> contact_results() const;
    /// The place of a body in system(), −1 for one that is not in this world. Bodies are in the order in
    /// which they were added.
    [[nodiscard]] int body_number(const btCollisionObject& body) const;

    /// All that the motion from here on depends on, as of the end of the last tick; what was changed from
    /// outside since then is not in it.
    void save(StateWriter& with) const;
    /// Goes on where another world was saved that has the same bodies, made in the same way and added in the
    /// same order, the same materials and the same choices; this one must have no tick behind it. What it
    /// does from then on is what the other one did, to the last bit. Bullet's manifolds, which are for
    /// onlookers, come with the next tick. Throws StateError, and is of no use then, where the bodies are
    /// others.
    void restore(StateReader& with);

    /// As Bullet's, but after a failure it returns the number of ticks that were done.
    int stepSimulation(btScalar time, int max_ticks = 1, btScalar tick = btScalar(1) / 60) override;
    /// Joints are not done: throws std::invalid_argument.
    void addConstraint(btTypedConstraint* constraint, bool disable_collisions = false) override;
    /// There is no solver of constraints: throws std::logic_error.
    void solveConstraints(btContactSolverInfo& info) override;
    /// Refuses shapes that have no overlap, and Bullet's additional damping: throws std::invalid_argument,
    /// and the body is not added.
    void addRigidBody(btRigidBody* body) override;
    /// The same, with a filter group and mask.
    void addRigidBody(btRigidBody* body, int group, int mask) override;
    /// What was set for the body, and what its contacts remember, is forgotten.
    void removeRigidBody(btRigidBody* body) override;
    /// A plain collision object is a fixed body, and one without contact response no body at all. Soft bodies
    /// and multibodies are refused.
    void addCollisionObject(btCollisionObject* object, int group = btBroadphaseProxy::StaticFilter,
                            int mask = btBroadphaseProxy::AllFilter ^
                                       btBroadphaseProxy::StaticFilter) override;
    /// As removeRigidBody, whatever the object.
    void removeCollisionObject(btCollisionObject* object) override;
    /// With bounds that hold the exact shapes.
    void updateAabbs() override;
    /// For sleeping bodies too, so that they have it when they wake up in the middle of stepSimulation.
    void applyGravity() override;

  protected:
    /// One tick [s]: detect, step the groups, write back.
    void internalSingleStepSimulation(btScalar tick) override;
    /// As Bullet's, for a tick [s]; from it come the velocities of kinematic bodies.
    void saveKinematicState(btScalar time) override;

  private:
    void forget(const btCollisionObject& object);
    void update_sensors();

    std::unique_ptr<WorldImplementation> implementation_;
};

}  // namespace scree
