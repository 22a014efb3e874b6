#include "bullet_engine.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <scree/detect/convert.hpp>
#include <scree/mesh/mass_properties.hpp>

#include "materials.hpp"

namespace scree {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

BulletEngine::BulletEngine(const SceneDescription& scene) : scene_(scene) {
    world_.setGravity(to_bullet(scene.gravity));
    world_.getSolverInfo().m_numIterations = scene.stepping.iterations;
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
    world_.getDispatchInfo().m_enableSatConvex = scene.stepping.separating_axis;
    if (scene.stepping.friction_directions == 2) {
        world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    }
}

BulletEngine::~BulletEngine() {
    for (const Member& member : members_) {
        world_.removeRigidBody(member.rigid);
    }
}

void BulletEngine::add(SimulationBody& body, const MaterialDescription& /*material*/) {
    btRigidBody& rigid = *body.rigid;
    rigid.setUserIndex(static_cast<int>(members_.size()));
    rigid.setActivationState(DISABLE_DEACTIVATION);  // what creeps is to be seen
    rigid.setCollisionShape(body.solid.native.get());
    if (auto* faces = dynamic_cast<btPolyhedralConvexShape*>(body.solid.native.get());
        faces != nullptr && scene_.stepping.separating_axis && faces->getConvexPolyhedron() == nullptr) {
        faces->initializePolyhedralFeatures();
    }
    Member& member = members_.emplace_back();
    member.rigid = &rigid;
    member.material = &scene_.materials.find(body.material)->first;
    member.radius = body.dynamic() ? sphere_radius(body.solid.volume) : 0;
    member.path = body_path(body);
    member.orientation = body.start.pose.orientation * body.solid.body_in_file.orientation;
    if (member.path) {
        rigid.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
        member.surface_velocity = member.path->at(0).surface_velocity;
    }
    if (member.surface_velocity != Vec3::Zero()) {
        world_.getSolverInfo().m_solverMode |= SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
    }
    world_.addRigidBody(&rigid);
}

bool BulletEngine::advance(double begin, double end) {
    const auto start = std::chrono::steady_clock::now();
    const double parts = std::ceil((end - begin) / scene_.stepping.step.value() * (1 - 1e-9));
    for (double part = 1; part < parts && !report_.failed; ++part) {
        step_to(begin + part * (end - begin) / parts);
    }
    if (!report_.failed) {
        step_to(end);
    }
    report_.times.stepping += seconds_since(start);
    ++report_.ticks;
    read_orientations();
    read_contacts();
    read_energy();
    return !report_.failed;
}

void BulletEngine::step_to(double time) {
    const double step = time - report_.time;
    for (Member& member : members_) {
        if (member.path) {
            const PathPoint point = member.path->at(time);
            member.rigid->setWorldTransform(to_bullet(point.pose));
            member.surface_velocity = point.surface_velocity;
        }
    }
    world_.stepSimulation(step, 0);
    if (!finite()) {
        report_.failed = true;
        report_.message = "a body's pose or velocity is not finite";
        return;
    }
    SteppingStatistics& steps = report_.steps;
    ++steps.accepted;
    ++steps.orders[0];
    steps.smallest_step = std::min(steps.smallest_step, step);
    steps.largest_step = std::max(steps.largest_step, step);
    steps.time_stepped += step;
    report_.all_steps.contact_evaluations += static_cast<std::size_t>(dispatcher_.getNumManifolds());
    report_.time = time;
}

bool BulletEngine::finite() const {
    return std::all_of(members_.begin(), members_.end(), [](const Member& member) {
        const btRigidBody& rigid = *member.rigid;
        return to_eigen(rigid.getWorldTransform().getOrigin()).allFinite() &&
               to_eigen(rigid.getLinearVelocity()).allFinite() &&
               to_eigen(rigid.getAngularVelocity()).allFinite();
    });
}

void BulletEngine::adjust(btPersistentManifold& manifold) {
    const Member& a = member(*manifold.getBody0());
    const Member& b = member(*manifold.getBody1());
    const PairNumbers numbers = pair_numbers(a, b);
    const Vec3 surface = a.surface_velocity - b.surface_velocity;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& point = manifold.getContactPoint(i);
        point.m_combinedFriction = numbers.friction;
        point.m_combinedRestitution = numbers.restitution;
        if (surface != Vec3::Zero()) {
            const auto velocity = [](const btRigidBody& rigid, const btVector3& at) {
                return rigid.getVelocityInLocalPoint(at - rigid.getCenterOfMassPosition());
            };
            drive(to_bullet(surface),
                  velocity(*a.rigid, point.m_positionWorldOnA) - velocity(*b.rigid, point.m_positionWorldOnB),
                  point);
        }
    }
}

BulletEngine::PairNumbers BulletEngine::pair_numbers(const Member& a, const Member& b) {
    const auto [place, is_new] = pairs_.try_emplace({a.material, b.material});
    if (is_new) {
        const PairMaterial pair = pair_material(scene_, *a.material, *b.material);
        const bool rough = scene_.law.friction != FrictionLaw::none;
        place->second = {rough ? pair.friction : 0, pair_restitution(pair)};
    }
    return place->second;
}

void BulletEngine::read_orientations() {
    for (Member& member : members_) {
        const Quat now = to_eigen(member.rigid->getWorldTransform()).orientation;
        member.orientation = now.dot(member.orientation) < 0 ? Quat(-now.coeffs()) : now;
    }
}

FrameMotion BulletEngine::motion(std::size_t number) const {
    const Member& member = members_[number];
    return {{to_eigen(member.rigid->getCenterOfMassPosition()), member.orientation},
            to_eigen(member.rigid->getLinearVelocity()),
            to_eigen(member.rigid->getAngularVelocity())};
}

}  // namespace scree
