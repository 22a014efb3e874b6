#include <scree/scenes/simulation.hpp>

#include <scree/detect/convert.hpp>
#include <scree/scenes/read_scene.hpp>

#include "body_names.hpp"
#include "fill.hpp"
#include "materials.hpp"

namespace scree {

namespace {

std::map<std::string, Solid> make_solids(const SceneDescription& scene) {
    std::map<std::string, Solid> solids;
    for (const auto& [name, shape] : scene.shapes) {
        try {
            solids[name] = make_solid(shape, scene.file.parent_path());
        } catch (const std::exception& error) {
            const char* key = std::holds_alternative<MeshShape>(shape) ? ".mesh: " : ": ";
            throw SceneError("shapes." + name + key + error.what());
        }
    }
    return solids;
}

std::vector<std::string> notes_of(const std::map<std::string, Solid>& solids) {
    std::vector<std::string> notes;
    for (const auto& [name, solid] : solids) {
        if (!solid.note.empty()) {
            notes.push_back("shapes." + name + ": " + solid.note);
        }
    }
    return notes;
}

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
    options.tolerances = {scene.stepping.rtol, scene.stepping.atol, scene.gravity.norm()};
    return options;
}

/// Bodies that are listed one by one, without those of fill.
std::vector<SimulationBody> listed_bodies(const SceneDescription& scene,
                                          const std::map<std::string, Solid>& solids) {
    std::vector<SimulationBody> bodies;
    for (const BodyDescription& description : scene.bodies) {
        SimulationBody& body = bodies.emplace_back();
        body.material = description.material;
        body.solid = solids.at(description.shape);
        body.fixed = std::holds_alternative<FixedMotion>(description.motion);
        body.start = {{description.position, description.orientation},
                      description.velocity,
                      description.angular_velocity};
    }
    return bodies;
}

}  // namespace

Simulation::Simulation(const SceneDescription& scene)
    : scene_(scene), times_(scene.output.every, scene.end_time) {
    check_scene(scene_);
    try {
        make_bodies();
    } catch (const SceneError& error) {
        throw error.in_file(scene_.file.string());
    }
}

Simulation::~Simulation() = default;

void Simulation::make_bodies() {
    const std::map<std::string, Solid> solids = make_solids(scene_);
    notes_ = notes_of(solids);
    const std::vector<std::string> names = body_names(scene_);
    bodies_ = listed_bodies(scene_, solids);
    const std::size_t listed = bodies_.size();
    bodies_.resize(names.size());
    fill_boxes(scene_, solids, bodies_, listed);
    make_world();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        bodies_[i].name = names[i];
        try {
            add_to_world(i);
        } catch (const std::invalid_argument& error) {
            throw SceneError("body " + names[i], error.what(), "a body that this build can move");
        }
    }
}

void Simulation::make_world() {
    configuration_ = std::make_unique<btDefaultCollisionConfiguration>();
    dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
    broadphase_ = std::make_unique<btDbvtBroadphase>();
    world_ =
        std::make_unique<DynamicsWorld>(dispatcher_.get(), broadphase_.get(), nullptr, configuration_.get());
    world_->set_manifolds(false);
    world_->setGravity(to_bullet(scene_.gravity));
    world_->set_stepping(stepping_options(scene_));
    world_->set_mixing([this](const btRigidBody& a, const Material&, const btRigidBody& b, const Material&) {
        return pair_material(scene_, bodies_[a.getUserIndex()].material, bodies_[b.getUserIndex()].material);
    });
    set_law(scene_, *world_);
}

void Simulation::add_to_world(std::size_t index) {
    SimulationBody& body = bodies_[index];
    const MaterialDescription& material = scene_.materials.at(body.material);
    const double mass = body.fixed ? 0 : material.density * body.solid.volume;
    const Vec3 inertia = body.fixed ? Vec3::Zero() : Vec3(material.density * body.solid.inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, body.solid.collision.get(),
                                                  to_bullet(inertia));
    const FrameMotion start = tied(body.start, body.solid.body_in_file);
    info.m_startWorldTransform = to_bullet(start.pose);
    body.rigid = std::make_unique<btRigidBody>(info);
    body.rigid->setLinearVelocity(to_bullet(start.velocity));
    body.rigid->setAngularVelocity(to_bullet(start.angular_velocity));
    body.rigid->setActivationState(DISABLE_DEACTIVATION);
    body.rigid->setUserIndex(static_cast<int>(index));
    world_->addRigidBody(body.rigid.get());
    world_->set_material(*body.rigid, material);
    const int number = world_->body_number(*body.rigid);
    body.mirrored = world_->system().states[number].orientation.dot(start.pose.orientation) < 0;
}

bool Simulation::at_start(const SimulationBody& body) const {
    return body.fixed || world_->step_report().time == 0;
}

FrameMotion Simulation::body_motion(std::size_t index) const {
    const SimulationBody& body = bodies_[index];
    if (at_start(body)) {
        return tied(body.start, body.solid.body_in_file);
    }
    const System& system = world_->system();
    const auto number = static_cast<std::size_t>(world_->body_number(*body.rigid));
    const BodyState& state = system.states[number];
    const Quat turn = body.mirrored ? Quat(-state.orientation.coeffs()) : state.orientation;
    return {
        {state.position, turn}, velocity(system.bodies[number], state), spin(system.bodies[number], state)};
}

FrameMotion Simulation::file_motion(std::size_t index) const {
    const SimulationBody& body = bodies_[index];
    return at_start(body) ? body.start : tied(body_motion(index), body.solid.body_in_file.inverse());
}

double Simulation::time() const {
    return world_->step_report().failed ? world_->step_report().time : times_.at(tick_);
}

bool Simulation::advance() {
    if (tick_ == times_.last()) {
        return true;
    }
    world_->stepSimulation(times_.at(tick_ + 1) - times_.at(tick_), 0);
    if (world_->step_report().failed) {
        return false;
    }
    ++tick_;
    return true;
}

}  // namespace scree
