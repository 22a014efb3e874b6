#pragma once

#include <memory>
#include <span>
#include <vector>

#include <scree/scenes/simulation.hpp>

namespace scree {

/// What steps the bodies of a scene: a world of scree's, or one of Bullet's own. Bodies are numbered in the
/// order in which they are added, which is the scene's.
class Engine {
  public:
    Engine() = default;
    virtual ~Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Takes a body with its rigid body made. Throws std::invalid_argument for one that it cannot move.
    virtual void add(SimulationBody& body, const MaterialDescription& material) = 0;

    /// From one time to the next [s]. Returns false when it cannot; the report says why.
    virtual bool advance(double begin, double end) = 0;

    /// How many threads share out the work.
    virtual void set_threads(std::size_t /*threads*/) {}
    [[nodiscard]] virtual std::size_t threads() const { return 1; }

    /// What is carried from one advance to the next.
    virtual void save(StateWriter& with) const = 0;
    /// Of an engine with all bodies and no advance behind it. Throws StateError.
    virtual void restore(StateReader& with) = 0;

    /// What was done so far. What an engine does not know is zero.
    [[nodiscard]] virtual const StepReport& report() const = 0;
    /// Of the mass centre and the principal axes of a body that is not at its start.
    [[nodiscard]] virtual FrameMotion motion(std::size_t number) const = 0;
    /// The contacts and what each of them did in the last step, as far as the engine knows.
    [[nodiscard]] virtual std::span<const Contact> contacts() const = 0;
    [[nodiscard]] virtual std::span<const ContactResult> contact_results() const = 0;
    /// Null when it is none of scree's.
    [[nodiscard]] virtual DynamicsWorld* world() { return nullptr; }
};

/// The engine of the scene's stepping method. The scene must outlive it.
std::unique_ptr<Engine> make_engine(const SceneDescription& scene);

/// The path of a prescribed body's mass centre and principal axes.
std::shared_ptr<const PrescribedPath> body_path(const SimulationBody& body);

}  // namespace scree
