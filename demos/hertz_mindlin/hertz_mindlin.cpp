// A contact law of one's own: two elastic spheres by Hertz and Mindlin, in place of the built-in law. They
// collide; how deep they come, how long they touch and how they part is held against the closed forms.

#include <cmath>
#include <cstdio>

#include <scree/world/dynamics_world.hpp>

#include "elastic_spheres_law.hpp"

namespace {

constexpr double radius = 0.01;   // [m]
constexpr double density = 2500;  // [kg/m³]
const double mass = density * 4.0 / 3 * M_PI * std::pow(radius, 3);

// The largest depth of two spheres that collide, δ = (15 m* v²/(16 E* √R*))^(2/5), and how long they touch.
double hertz_depth(const scree::ElasticSpheres& law, double speed) {
    const double elastic = 16 * law.effective_modulus() * std::sqrt(radius / 2);
    return std::pow(15 * (mass / 2) * speed * speed / elastic, 0.4);
}
double hertz_duration(const scree::ElasticSpheres& law, double speed) {
    return 2.9433 * hertz_depth(law, speed) / speed;
}

// What was seen of a collision.
struct Collision {
    double depth = 0;     // [m], the largest
    double duration = 0;  // [s]
    btVector3 before, after;
};

// Steps until the spheres have touched and parted.
void watch(scree::DynamicsWorld& world, Collision& seen) {
    const double tick = 1e-6;
    for (bool touched = false; world.step_report().time < 1 && !world.step_report().failed;) {
        world.stepSimulation(tick, 0);
        const bool touching = world.step_report().contacts > 0;
        seen.duration += touching ? tick : 0;
        seen.depth = touching ? std::max(seen.depth, world.contact_results()[0].depth) : seen.depth;
        if (touched && !touching) {
            break;
        }
        touched = touched || touching;
    }
}

// Two spheres fly at each other with relative velocity (along, 0, -across) [m/s], so that they meet one above
// the other.
Collision collide(const scree::ElasticSpheres& law, double across, double along) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    scree::DynamicsWorld world(&dispatcher, &pairs, nullptr, &configuration);
    world.setGravity({0, 0, 0});
    world.set_contact_law(law);
    scree::SteppingOptions stepping;
    stepping.tolerances.relative = 1e-6;
    world.set_stepping(stepping);

    btSphereShape ball(radius);
    btVector3 inertia;
    ball.calculateLocalInertia(mass, inertia);
    const btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &ball, inertia);
    btRigidBody lower(info);
    btRigidBody upper(info);
    const double gap = 1e-3 * radius;
    // Side by side in the middle of the contact.
    const double behind = along * (gap / across + 0.5 * hertz_duration(law, across));
    upper.setWorldTransform(btTransform(btQuaternion::getIdentity(), {-behind, 0, 2 * radius + gap}));
    lower.setLinearVelocity({-along / 2, 0, across / 2});
    upper.setLinearVelocity({along / 2, 0, -across / 2});
    for (btRigidBody* body : {&lower, &upper}) {
        world.addRigidBody(body);
    }

    Collision seen;
    seen.before = upper.getLinearVelocity() - lower.getLinearVelocity();
    watch(world, seen);
    seen.after = upper.getLinearVelocity() - lower.getLinearVelocity();
    for (btRigidBody* body : {&upper, &lower}) {
        world.removeRigidBody(body);
    }
    return seen;
}

void head_on(const scree::ElasticSpheres& law) {
    std::printf(
        "Head on            depth [m]    Hertz        time [s]     Hertz        speed after/before\n");
    for (const double speed : {0.1, 0.3, 1.0, 3.0}) {
        const Collision seen = collide(law, speed, 0);
        std::printf("%6.2f m/s         %-12.5g %-12.5g %-12.4g %-12.4g %.6f\n", speed, seen.depth,
                    hertz_depth(law, speed), seen.duration, hertz_duration(law, speed),
                    seen.after.z() / -seen.before.z());
    }
}

// A contact that slides all the time takes μ times the normal impulse along with it.
void grazing(const scree::ElasticSpheres& law) {
    std::printf(
        "\nGrazing            taken along by the collision     Coulomb: 2 μ times the speed across\n");
    for (const double speed : {0.3, 1.0}) {
        const Collision seen = collide(law, speed, 2 * speed);
        std::printf("%6.2f m/s across  %-12.6g                     %.6g\n", speed,
                    seen.before.x() - seen.after.x(), 2 * law.friction * speed);
    }
}

}  // namespace

int main() {
    scree::ElasticSpheres law;
    law.youngs_modulus = 5e9;
    head_on(law);
    law.friction = 0.1;
    grazing(law);
}
