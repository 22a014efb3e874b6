#include <scree/scenes/simulation.hpp>

#include <stdexcept>

#include <scree/detect/convert.hpp>
#include <scree/scenes/read_scene.hpp>

#include "body_names.hpp"
#include "engine.hpp"
#include "fill.hpp"
#include "plane_motion.hpp"

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

/// Bodies that are listed one by one, without those of fill.
std::vector<SimulationBody> listed_bodies(const SceneDescription& scene,
                                          const std::map<std::string, Solid>& solids) {
    std::vector<SimulationBody> bodies;
    for (const BodyDescription& description : scene.bodies) {
        SimulationBody& body = bodies.emplace_back();
        body.material = description.material;
        body.shape = description.shape;
        body.solid = solids.at(description.shape);
        body.motion = description.motion;
        body.start = {{description.position, description.orientation},
                      description.velocity,
                      description.angular_velocity};
        if (const auto* motion = std::get_if<PrescribedMotion>(&description.motion)) {
            body.file_path = std::make_unique<PrescribedMotionPath>(*motion, body.start.pose);
        }
    }
    return bodies;
}

std::unique_ptr<btRigidBody> rigid_body(const SimulationBody& body, double density) {
    const double mass = body.dynamic() ? density * body.solid.volume : 0;
    const Vec3 inertia = body.dynamic() ? Vec3(density * body.solid.inertia) : Vec3::Zero();
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, body.solid.collision.get(),
                                                  to_bullet(inertia));
    const FrameMotion start = tied(body.start, body.solid.body_in_file);
    info.m_startWorldTransform = to_bullet(start.pose);
    auto rigid = std::make_unique<btRigidBody>(info);
    rigid->setLinearVelocity(to_bullet(start.velocity));
    rigid->setAngularVelocity(to_bullet(start.angular_velocity));
    rigid->setActivationState(DISABLE_DEACTIVATION);
    return rigid;
}

DynamicsWorld& world_of(Engine& engine) {
    if (engine.world() == nullptr) {
        throw std::logic_error("a scene that Bullet's own solver steps is in no world of scree's");
    }
    return *engine.world();
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
    solids_ = make_solids(scene_);
    check_plane_meshes(scene_, solids_);
    notes_ = notes_of(solids_);
    const std::vector<std::string> names = body_names(scene_);
    bodies_ = listed_bodies(scene_, solids_);
    const std::size_t listed = bodies_.size();
    bodies_.resize(names.size());
    fill_boxes(scene_, solids_, bodies_, listed);
    engine_ = make_engine(scene_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        bodies_[i].name = names[i];
        const MaterialDescription& material = scene_.materials.at(bodies_[i].material);
        bodies_[i].rigid = rigid_body(bodies_[i], material.density);
        try {
            engine_->add(bodies_[i], material);
        } catch (const std::invalid_argument& error) {
            throw SceneError("body " + names[i], error.what(), "a body that this build can move");
        }
    }
}

bool Simulation::at_start(const SimulationBody& body) const {
    return std::holds_alternative<FixedMotion>(body.motion) || engine_->report().time == 0;
}

FrameMotion Simulation::body_motion(std::size_t index) const {
    const SimulationBody& body = bodies_[index];
    if (body.file_path || at_start(body)) {
        return tied(file_motion(index), body.solid.body_in_file);
    }
    return engine_->motion(index);
}

FrameMotion Simulation::file_motion(std::size_t index) const {
    const SimulationBody& body = bodies_[index];
    if (body.file_path) {
        const PathPoint point = body.file_path->at(time());
        return {point.pose, point.velocity, point.spin};
    }
    return at_start(body) ? body.start : tied(body_motion(index), body.solid.body_in_file.inverse());
}

const StepReport& Simulation::report() const {
    return engine_->report();
}

std::span<const Contact> Simulation::contacts() const {
    return engine_->contacts();
}

std::span<const ContactResult> Simulation::contact_results() const {
    return engine_->contact_results();
}

DynamicsWorld& Simulation::world() {
    return world_of(*engine_);
}

const DynamicsWorld& Simulation::world() const {
    return world_of(*engine_);
}

double Simulation::time() const {
    return report().failed ? report().time : times_.at(tick_);
}

void Simulation::set_threads(std::size_t threads) {
    engine_->set_threads(threads);
}

std::size_t Simulation::threads() const {
    return engine_->threads();
}

SavedState Simulation::save() const {
    SavedState state;
    StateWriter with(state);
    with(tick_);
    engine_->save(with);
    return state;
}

void Simulation::restore(const SavedState& state) {
    StateReader with(state);
    with(tick_);
    StateReader::require(tick_ >= 0 && tick_ <= times_.last());
    engine_->restore(with);
    with.finish();
}

bool Simulation::advance() {
    if (tick_ == times_.last()) {
        return true;
    }
    if (!engine_->advance(times_.at(tick_), times_.at(tick_ + 1))) {
        return false;
    }
    ++tick_;
    return true;
}

}  // namespace scree
