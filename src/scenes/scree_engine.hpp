#pragma once

#include <string>

#include "engine.hpp"

namespace scree {

/// A scene in a scree::DynamicsWorld.
class ScreeEngine final : public Engine {
  public:
    explicit ScreeEngine(const SceneDescription& scene);

    void add(SimulationBody& body, const MaterialDescription& material) override;
    bool advance(double begin, double end) override;
    void set_threads(std::size_t threads) override;
    [[nodiscard]] std::size_t threads() const override { return threads_; }
    void save(StateWriter& with) const override { world_.save(with); }
    void restore(StateReader& with) override { world_.restore(with); }
    [[nodiscard]] const StepReport& report() const override { return world_.step_report(); }
    [[nodiscard]] FrameMotion motion(std::size_t number) const override;
    [[nodiscard]] std::span<const Contact> contacts() const override { return world_.system().contacts; }
    [[nodiscard]] std::span<const ContactResult> contact_results() const override {
        return world_.contact_results();
    }
    [[nodiscard]] DynamicsWorld* world() override { return &world_; }

  private:
    const SceneDescription& scene_;
    std::size_t threads_ = 1;
    std::vector<std::string> materials_;  ///< of the bodies
    std::vector<bool> mirrored_;          ///< the world holds the negative, equal quaternion
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    DynamicsWorld world_{&dispatcher_, &broadphase_, nullptr, &configuration_};
};

}  // namespace scree
