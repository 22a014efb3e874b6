// A program that uses Bullet: pillars of boxes, spheres, hulls and compounds on a ground box, a pusher that
// is driven through them, a callback that looks at contacts, rays that look for the tops, bodies that go and
// come in the middle. with_bullet.cpp and with_scree.cpp differ in the line that constructs the world.

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include <btBulletDynamicsCommon.h>
#include <scree/world/dynamics_world.hpp>

namespace {

constexpr btScalar tick = 1.0 / 120;
constexpr int rows = 8;

// What a program draws: it gets every move of its body.
struct Drawn : btDefaultMotionState {
    explicit Drawn(const btTransform& start) : btDefaultMotionState(start) {}
    void setWorldTransform(const btTransform& place) override {
        btDefaultMotionState::setWorldTransform(place);
        ++moves;
    }
    int moves = 0;
};

// The driven one asks its state where it is to be.
struct Driven : btMotionState {
    btScalar time = 0;
    void getWorldTransform(btTransform& place) const override {
        place.setIdentity();
        place.setOrigin({-8 + 2.5 * time, 0, 0.8});
    }
    void setWorldTransform(const btTransform& /*place*/) override {}
};

class Program {
  public:
    explicit Program(btDiscreteDynamicsWorld& world) : world_(world) {
        world_.setGravity({0, 0, -9.81});
        world_.setInternalTickCallback(count_contacts, this);
        fill_shapes();
        add(0, ground_, {0, 0, -1}).setFriction(0.8);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < rows; ++column) {
                add_pillar(1.8 * (row - 3.5), 1.8 * (column - 3.5));
            }
        }
        add_pusher();
    }
    ~Program() {
        for (const auto& body : bodies_) {
            world_.removeRigidBody(body.get());
        }
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void run(btScalar duration) {
        const auto calls = static_cast<int>(std::lround(duration * 60));
        for (int i = 0; i < calls; ++i) {
            driven_.time += 1.0 / 60;
            world_.stepSimulation(1.0 / 60, 4, tick);
        }
    }
    // Some go, others come; both in the middle of everything.
    void exchange() {
        for (std::size_t i = 7; i < bodies_.size() && bodies_.size() > 200; i += 12) {
            if (!bodies_[i]->isStaticOrKinematicObject()) {
                world_.removeRigidBody(bodies_[i].get());
                bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
        for (int i = 0; i < 20; ++i) {
            add(1, ball_, {0.7 * (i % 5) - 1.4, 0.7 * (i / 5) - 1.05, 4});
        }
    }
    void report() const {
        btScalar height = 0;
        btScalar fastest = 0;
        int fallen = 0;
        for (const auto& body : bodies_) {
            height += body->isStaticOrKinematicObject() ? 0 : body->getWorldTransform().getOrigin().z();
            fastest = std::max(fastest, body->getLinearVelocity().length());
            fallen += body->getWorldTransform().getOrigin().z() < -2;
        }
        std::printf(
            "%4zu bodies, mean height %.3f m, fastest %.3g m/s, %d below ground, %d pairs touch (most "
            "%d), highest under the rays %.3f m\n",
            bodies_.size(), height / static_cast<btScalar>(bodies_.size()), fastest, fallen, touching_, most_,
            highest());
    }
    [[nodiscard]] int moves() const {
        int sum = 0;
        for (const auto& state : states_) {
            sum += state->moves;
        }
        return sum;
    }

  private:
    static void count_contacts(btDynamicsWorld* world, btScalar /*tick*/) {
        auto& me = *static_cast<Program*>(world->getWorldUserInfo());
        me.touching_ = 0;
        const btDispatcher& dispatcher = *world->getDispatcher();
        for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
            me.touching_ +=
                const_cast<btDispatcher&>(dispatcher).getManifoldByIndexInternal(i)->getNumContacts() > 0;
        }
        me.most_ = std::max(me.most_, me.touching_);
    }

    void fill_shapes() {
        for (int i = 0; i < 12; ++i) {
            const btScalar angle = 0.5236 * i;
            hull_.addPoint({0.4 * std::cos(angle), 0.4 * std::sin(angle), i % 2 == 0 ? 0.2 : -0.2});
            hull_.addPoint({0.4 * std::cos(angle), 0.4 * std::sin(angle), i % 2 == 0 ? -0.2 : 0.2});
        }
        hull_.setMargin(0.001);
        const auto place = [](btScalar x) { return btTransform(btQuaternion::getIdentity(), {x, 0, 0}); };
        dumbbell_.addChildShape(place(-0.25), &half_);
        dumbbell_.addChildShape(place(0.25), &half_);
    }

    btRigidBody& add(btScalar mass, btCollisionShape& shape, const btVector3& at) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) {
            shape.calculateLocalInertia(mass, inertia);
        }
        states_.push_back(std::make_unique<Drawn>(btTransform(btQuaternion::getIdentity(), at)));
        bodies_.push_back(std::make_unique<btRigidBody>(
            btRigidBody::btRigidBodyConstructionInfo(mass, states_.back().get(), &shape, inertia)));
        world_.addRigidBody(bodies_.back().get());
        return *bodies_.back();
    }
    void add_pillar(btScalar x, btScalar y) {
        add(1, box_, {x, y, 0.25});
        add(1, dumbbell_, {x, y, 0.7});
        add(1, hull_, {x, y, 1.1});
        add(1, box_, {x, y, 1.55});
        add(1, ball_, {x, y, 2.05}).setRollingFriction(0.01);
    }
    void add_pusher() {
        btRigidBody& pusher = add(0, plough_, {-8, 0, 0.8});
        pusher.setMotionState(&driven_);
        pusher.setCollisionFlags(pusher.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        pusher.setActivationState(DISABLE_DEACTIVATION);
        world_.removeRigidBody(&pusher);
        world_.addRigidBody(&pusher);
    }
    [[nodiscard]] btScalar highest() const {
        btScalar top = 0;
        for (int i = 0; i < 16 * 16; ++i) {
            const btVector3 from(i % 16 - 7.5, i / 16 - 7.5, 10);
            const btVector3 to(from.x(), from.y(), -5);
            btCollisionWorld::ClosestRayResultCallback ray(from, to);
            world_.rayTest(from, to, ray);
            top = ray.hasHit() ? std::max(top, ray.m_hitPointWorld.z()) : top;
        }
        return top;
    }

    btDiscreteDynamicsWorld& world_;
    btBoxShape ground_{{12, 12, 1}};
    btBoxShape box_{{0.25, 0.25, 0.25}};
    btBoxShape half_{{0.2, 0.2, 0.2}};
    btBoxShape plough_{{0.4, 1.6, 0.75}};
    btSphereShape ball_{0.25};
    btConvexHullShape hull_;
    btCompoundShape dumbbell_;
    Driven driven_;
    std::vector<std::unique_ptr<Drawn>> states_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    int touching_ = 0;
    int most_ = 0;
};

}  // namespace

int main() {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    scree::DynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);

    Program program(world);
    program.report();
    program.run(0.5);
    program.report();
    program.exchange();
    program.run(0.5);
    program.report();
    std::printf("%d moves were drawn\n", program.moves());
}
