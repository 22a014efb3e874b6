#include "scree_engine.hpp"

#include <scree/detect/convert.hpp>

#include "materials.hpp"

namespace scree {

namespace {

Method world_method(SteppingMethod method) {
    switch (method) {
        case SteppingMethod::verlet:
            return Method::velocity_verlet;
        case SteppingMethod::symplectic_euler:
            return Method::symplectic_euler;
        default:
            return Method::bdf;
    }
}

SteppingOptions stepping_options(const SceneDescription& scene) {
    SteppingOptions options;
    options.method = world_method(scene.stepping.method);
    options.max_order = static_cast<std::size_t>(scene.stepping.max_order);
    options.fixed_step = scene.stepping.step.value_or(0);
    options.solver = scene.stepping.solver;
    options.sleep = scene.stepping.sleep;
    options.tolerances = {scene.stepping.rtol, scene.stepping.atol, scene.gravity.norm()};
    return options;
}

}  // namespace

ScreeEngine::ScreeEngine(const SceneDescription& scene) : scene_(scene) {
    world_.set_manifolds(false);
    world_.setGravity(to_bullet(scene.gravity));
    world_.set_stepping(stepping_options(scene));
    world_.set_mixing([this](const btRigidBody& a, const Material&, const btRigidBody& b, const Material&) {
        return pair_material(scene_, materials_[static_cast<std::size_t>(a.getUserIndex())],
                             materials_[static_cast<std::size_t>(b.getUserIndex())]);
    });
    LawOptions options = scene.law;
    options.elasticity = scene.law.normal == NormalLaw::energy ? Elasticity::potential : Elasticity::volume;
    world_.set_contact_law(scene.law.friction, options);
    if (scene.law.normal == NormalLaw::manifold) {
        world_.set_contact_geometry(GeometrySource::manifold);
    }
}

void ScreeEngine::add(SimulationBody& body, const MaterialDescription& material) {
    body.rigid->setUserIndex(static_cast<int>(materials_.size()));
    world_.addRigidBody(body.rigid.get());
    world_.set_material(*body.rigid, material);
    world_.set_path(*body.rigid, body_path(body));
    const auto number = static_cast<std::size_t>(world_.body_number(*body.rigid));
    const Quat start = body.start.pose.orientation * body.solid.body_in_file.orientation;
    materials_.push_back(body.material);
    mirrored_.push_back(world_.system().states[number].orientation.dot(start) < 0);
}

bool ScreeEngine::advance(double begin, double end) {
    world_.stepSimulation(end - begin, 0);
    return !world_.step_report().failed;
}

void ScreeEngine::set_threads(std::size_t threads) {
    world_.set_threads(threads);
    threads_ = threads;
}

FrameMotion ScreeEngine::motion(std::size_t number) const {
    const Body& body = world_.system().bodies[number];
    const BodyState& state = world_.system().states[number];
    const Quat turn = mirrored_[number] ? Quat(-state.orientation.coeffs()) : state.orientation;
    return {{state.position, turn}, velocity(body, state), spin(body, state)};
}

}  // namespace scree
