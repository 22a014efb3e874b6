#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <scree/scenes/frame_motion.hpp>
#include <scree/scenes/output_times.hpp>
#include <scree/scenes/scene_description.hpp>
#include <scree/scenes/scene_error.hpp>
#include <scree/scenes/solid.hpp>
#include <scree/world/dynamics_world.hpp>

namespace scree {

class Engine;

/// A body of a running scene.
struct SimulationBody {
    std::string name;                                 ///< unique in the scene
    std::string material;                             ///< its name
    std::string shape;                                ///< its name
    double size = 1;                                  ///< factor on that
    Solid solid;                                      ///< of the body, its size included
    FrameMotion start;                                ///< of the file's frame, at time 0, as the scene has it
    MotionDescription motion;                         ///< as the scene has it
    std::unique_ptr<const PrescribedPath> file_path;  ///< of the file's frame; null: not prescribed
    std::unique_ptr<btRigidBody> rigid;               ///< in Bullet's world

    /// Whether forces move it.
    [[nodiscard]] bool dynamic() const { return std::holds_alternative<DynamicMotion>(motion); }
};

/// A scene in a world, run from one output time to the next.
class Simulation {
  public:
    /// Loads the meshes, fills the boxes and makes the bodies. Throws SceneError.
    explicit Simulation(const SceneDescription& scene);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// As it was given.
    [[nodiscard]] const SceneDescription& scene() const { return scene_; }
    /// When it writes, and where its ticks end.
    [[nodiscard]] const OutputTimes& times() const { return times_; }
    /// The world that it is in; throws std::logic_error when Bullet's own solver steps the scene.
    [[nodiscard]] DynamicsWorld& world();
    /// The same.
    [[nodiscard]] const DynamicsWorld& world() const;

    /// What was done so far. Of what Bullet's own solver does not know the entries are zero.
    [[nodiscard]] const StepReport& report() const;
    /// The pairs that may touch and what each did in the last step; bodies are numbered in scene order. Of
    /// Bullet's own solver one entry a pair that touches, without volume and area.
    [[nodiscard]] std::span<const Contact> contacts() const;
    /// One a contact, in the same order.
    [[nodiscard]] std::span<const ContactResult> contact_results() const;

    /// In scene order, those of `fill` after those of `bodies`.
    [[nodiscard]] const std::vector<SimulationBody>& bodies() const { return bodies_; }
    /// The scene's shapes, by name.
    [[nodiscard]] const std::map<std::string, Solid>& solids() const { return solids_; }
    /// What the user should know of how the scene was understood, a line each.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

    /// The present motion of a body's file frame, which is what scenes and outputs speak of.
    [[nodiscard]] FrameMotion file_motion(std::size_t index) const;
    /// The present motion of its mass centre and principal axes.
    [[nodiscard]] FrameMotion body_motion(std::size_t index) const;

    /// Present time [s]: an output time, or later than the last one if the world has failed.
    [[nodiscard]] double time() const;
    /// The number of the last output time reached.
    [[nodiscard]] std::int64_t tick() const { return tick_; }
    /// How many threads share out the work; 1 at first, and always of Bullet's own solver. The results are
    /// the same bytes for any number.
    void set_threads(std::size_t threads);
    /// As set.
    [[nodiscard]] std::size_t threads() const;

    /// All that the rest of the run depends on.
    [[nodiscard]] SavedState save() const;
    /// Goes on where another simulation of the same scene was saved; this one must have made no advance. What
    /// it does from then on is what the other one did, to the last bit. Throws StateError, and is of no use
    /// then, for a state of another scene.
    void restore(const SavedState& state);

    /// On to the next output time; at the last one nothing is left to do. Returns false when the world
    /// cannot; its step report says why.
    bool advance();

  private:
    void make_bodies();
    [[nodiscard]] bool at_start(const SimulationBody& body) const;

    SceneDescription scene_;
    OutputTimes times_;
    std::int64_t tick_ = 0;
    std::map<std::string, Solid> solids_;
    std::vector<std::string> notes_;
    std::vector<SimulationBody> bodies_;
    std::unique_ptr<Engine> engine_;
};

}  // namespace scree
