#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <scree/bdf/groups.hpp>
#include <scree/detect/body_shape.hpp>
#include <scree/dynamics/step_problem.hpp>
#include <scree/world/automatic_material.hpp>

namespace scree {

/// How a body moves.
enum class Motion {
    fixed,
    prescribed,  ///< along a path, or as Bullet's kinematic bodies: towards a target
    dynamic,     ///< by forces
};

/// One of Bullet's bodies in this world, with what the system does not keep of it.
struct WorldBody {
    btCollisionObject* object = nullptr;             ///< null: removed since the last tick
    btRigidBody* rigid = nullptr;                    ///< the same, null for a plain collision object
    const btCollisionShape* bullet_shape = nullptr;  ///< that `shape` was made from
    BodyShape shape;
    std::uint64_t shape_stamp = 0;  ///< of that, see shape_stamp.hpp
    bool contacts_end = false;      ///< the shape is another one
    Motion motion = Motion::fixed;
    std::shared_ptr<const PrescribedPath> path;  ///< null: as Bullet has it
    std::shared_ptr<const Restraint> restraint;  ///< null: none
    SurfaceProperties surface;                   ///< as last seen
    int activation = ACTIVE_TAG;                 ///< Bullet's state, as last seen or written

    btTransform transform;  ///< as last read or written
    btVector3 velocity;
    btVector3 spin;
};

/// What reading the bodies has shown to be other than the method left it.
struct Changes {
    std::vector<int> bodies;  ///< that have another pose, velocity, mass or are woken or stopped: their
                              ///< groups start afresh
    std::vector<int> moved;   ///< that have another pose: what their contacts remember is void
    bool any = false;         ///< there are such, or bodies more or less
    bool constants = false;   ///< something that pair constants are made of
};

/// The bodies of a world in the order in which they were added: between Bullet's and the system's.
class Bodies {
  public:
    explicit Bodies(System& system) : system_(system) {}

    /// Throws std::invalid_argument, and adds nothing, for what cannot be done.
    void add(btCollisionObject& object);
    /// From the next read() on it moves along a path; null: as Bullet has it.
    void prescribe(int number, std::shared_ptr<const PrescribedPath> path);
    /// Marks it; it stays in the system until the next drop_removed().
    void remove(const btCollisionObject& object);
    /// −1: not here.
    [[nodiscard]] int number(const btCollisionObject& object) const;

    /// Takes out what was removed and follows changes of shape. Returns the new numbers by the old ones, −1
    /// where a body's contacts end; empty when all is as it was.
    std::vector<int> drop_removed();

    /// Forces, masses, and what was set from outside since the last write. `now` [s]; `tick` [s]; `left` [s]
    /// to the end of stepSimulation's time, when kinematic bodies are to have reached their targets.
    Changes read(double now, double tick, double left);

    /// Hands the states of dynamic bodies and those on paths to Bullet, and which of them are at rest.
    /// `arrived`: kinematic bodies are at their targets.
    void write(bool arrived, const Groups& groups);

    [[nodiscard]] std::span<const WorldBody> all() const { return bodies_; }

    /// Whether one of them is an open surface.
    [[nodiscard]] bool any_open() const;

    /// Those whose shapes have been replaced, since the last call.
    std::vector<btCollisionObject*> take_reshaped() { return std::exchange(reshaped_, {}); }

  private:
    static void check(const btCollisionObject& object);
    static void check_motion(const WorldBody& body);
    BodyShape translate(const btCollisionObject& object);
    void follow_shapes();
    static void write_activation(WorldBody& body, bool asleep);
    void read_activation(std::size_t number, Changes& changes);
    void read_one(std::size_t number, double now, double tick, double left, Changes& changes);
    void read_motion(std::size_t number, double now, double left, Changes& changes);
    void read_velocities(std::size_t number, Changes& changes);

    System& system_;
    ShapeLibrary library_;
    std::vector<WorldBody> bodies_;
    std::unordered_map<const btCollisionObject*, int> numbers_;
    std::vector<btCollisionObject*> reshaped_;
    bool added_or_removed_ = false;
};

}  // namespace scree
