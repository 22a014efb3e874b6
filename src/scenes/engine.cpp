#include "engine.hpp"

#include "bullet_engine.hpp"
#include "scree_engine.hpp"

namespace scree {

std::unique_ptr<Engine> make_engine(const SceneDescription& scene) {
    if (scene.stepping.method == SteppingMethod::bullet) {
        return std::make_unique<BulletEngine>(scene);
    }
    return std::make_unique<ScreeEngine>(scene);
}

std::shared_ptr<const PrescribedPath> body_path(const SimulationBody& body) {
    const auto* motion = std::get_if<PrescribedMotion>(&body.motion);
    return motion == nullptr
               ? nullptr
               : std::make_shared<PrescribedMotionPath>(*motion, body.start.pose, body.solid.body_in_file);
}

}  // namespace scree
