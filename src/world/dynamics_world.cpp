#include <scree/world/dynamics_world.hpp>

#include <stdexcept>

#include "world_implementation.hpp"

namespace scree {

DynamicsWorld::DynamicsWorld(btDispatcher* dispatcher, btBroadphaseInterface* pairs,
                             btConstraintSolver* solver, btCollisionConfiguration* configuration)
    : btDiscreteDynamicsWorld(dispatcher, pairs, solver, configuration),
      implementation_(std::make_unique<WorldImplementation>(*dispatcher)) {}

DynamicsWorld::~DynamicsWorld() = default;

void DynamicsWorld::set_stepping(const SteppingOptions& options) {
    implementation_->set_stepping(options);
}

void DynamicsWorld::set_threads(std::size_t threads) {
    if (threads == 0) {
        throw std::invalid_argument("a world needs at least one thread");
    }
    implementation_->set_threads(threads);
}

void DynamicsWorld::set_material(const btRigidBody& body, const Material& material) {
    implementation_->materials().give(body, material);
    implementation_->constants_changed();
}

Material DynamicsWorld::material(const btRigidBody& body) const {
    return implementation_->material(body, getGravity().length());
}

PairMaterial DynamicsWorld::pair_material(const btRigidBody& a, const btRigidBody& b) const {
    return implementation_->pair_material(a, b, getGravity().length());
}

void DynamicsWorld::set_mixing(Mixing mixing) {
    implementation_->materials().set_mixing(std::move(mixing));
    implementation_->constants_changed();
}

void DynamicsWorld::set_path(const btRigidBody& body, std::shared_ptr<const PrescribedPath> path) {
    const int number = body_number(body);
    if (number < 0) {
        throw std::invalid_argument("a body that is not in this world has no path here");
    }
    implementation_->bodies().prescribe(number, std::move(path));
}

void DynamicsWorld::set_forces(std::unique_ptr<ContactForces> forces) {
    implementation_->law().set(std::move(forces));
    implementation_->law_changed();
}

void DynamicsWorld::set_forces(const Material& a, const Material& b, std::unique_ptr<ContactForces> forces) {
    implementation_->materials().set_law(a, b, implementation_->law().add(std::move(forces)));
    implementation_->law_changed();
}

void DynamicsWorld::set_contact_law(FrictionLaw friction, const LawOptions& options) {
    implementation_->law().set(friction, options);
    implementation_->law_changed();
}

void DynamicsWorld::set_contact_geometry(GeometrySource source) {
    implementation_->set_contact_geometry(source, *this);
}

void DynamicsWorld::set_manifolds(bool written) {
    implementation_->manifolds().set_on(written, *this);
}

const StepReport& DynamicsWorld::step_report() const {
    return implementation_->report();
}

const System& DynamicsWorld::system() const {
    return implementation_->system();
}

std::span<const ContactResult> DynamicsWorld::contact_results() const {
    return implementation_->results();
}

int DynamicsWorld::body_number(const btCollisionObject& body) const {
    return implementation_->bodies().number(body);
}

void DynamicsWorld::save(StateWriter& with) const {
    implementation_->save(with);
}

void DynamicsWorld::restore(StateReader& with) {
    implementation_->restore(with, *this, getGravity().length());
}

int DynamicsWorld::stepSimulation(btScalar time, int max_ticks, btScalar tick) {
    const std::size_t before = step_report().ticks;
    const int asked = btDiscreteDynamicsWorld::stepSimulation(time, max_ticks, tick);
    return step_report().failed ? static_cast<int>(step_report().ticks - before) : asked;
}

void DynamicsWorld::saveKinematicState(btScalar time) {
    btDiscreteDynamicsWorld::saveKinematicState(time);
    implementation_->begin_call(time);
}

void DynamicsWorld::internalSingleStepSimulation(btScalar tick) {
    if (step_report().failed) {
        return;
    }
    if (m_internalPreTickCallback != nullptr) {
        m_internalPreTickCallback(this, tick);
    }
    getDispatchInfo().m_timeStep = tick;
    getSolverInfo().m_timeStep = tick;
    update_sensors();
    if (!implementation_->run(*this, tick, getGravity().length())) {
        return;
    }
    implementation_->update_manifolds(*this, tick);
    updateActions(tick);
    if (m_internalTickCallback != nullptr) {
        m_internalTickCallback(this, tick);
    }
}

void DynamicsWorld::addConstraint(btTypedConstraint* /*constraint*/, bool /*disable_collisions*/) {
    throw std::invalid_argument("joints are not done: scree::DynamicsWorld takes no constraints");
}

void DynamicsWorld::solveConstraints(btContactSolverInfo& /*info*/) {
    throw std::logic_error("there is no solver of constraints: contacts are forces, see stepSimulation");
}

// Before Bullet's own part, so that a body that is refused is not added at all.
void DynamicsWorld::addRigidBody(btRigidBody* body) {
    implementation_->bodies().add(*body);
    btDiscreteDynamicsWorld::addRigidBody(body);
}

void DynamicsWorld::addRigidBody(btRigidBody* body, int group, int mask) {
    implementation_->bodies().add(*body);
    btDiscreteDynamicsWorld::addRigidBody(body, group, mask);
}

void DynamicsWorld::removeRigidBody(btRigidBody* body) {
    forget(*body);
    btDiscreteDynamicsWorld::removeRigidBody(body);
}

// Bullet hands rigid bodies through here as well.
void DynamicsWorld::addCollisionObject(btCollisionObject* object, int group, int mask) {
    const bool sensor = btRigidBody::upcast(object) == nullptr && !object->hasContactResponse();
    if (!sensor && body_number(*object) < 0) {
        implementation_->bodies().add(*object);
    }
    btDiscreteDynamicsWorld::addCollisionObject(object, group, mask);
}

void DynamicsWorld::removeCollisionObject(btCollisionObject* object) {
    forget(*object);
    btDiscreteDynamicsWorld::removeCollisionObject(object);
}

void DynamicsWorld::forget(const btCollisionObject& object) {
    implementation_->remove(object);
}

void DynamicsWorld::applyGravity() {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        m_nonStaticRigidBodies[i]->applyGravity();
    }
}

void DynamicsWorld::updateAabbs() {
    update_sensors();
    implementation_->place(*this);
}

// Objects that are no bodies here keep Bullet's own bounds.
void DynamicsWorld::update_sensors() {
    for (int i = 0; i < m_collisionObjects.size(); ++i) {
        if (body_number(*m_collisionObjects[i]) < 0) {
            updateSingleAabb(m_collisionObjects[i]);
        }
    }
}

}  // namespace scree
