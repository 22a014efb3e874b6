#include <catch2/catch.hpp>

#include <cstring>
#include <thread>

#include <tests/support/random.hpp>
#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// A few stones that fall on one another; where they are after each tick.
class Stones {
  public:
    explicit Stones(std::uint64_t seed) : random_(seed) {
        scene_.add_floor();
        for (int i = 0; i < 6; ++i) {
            const auto shape = std::make_shared<const Shape>(random_.polyhedron(10, 0.05));
            bodies_.push_back(&scene_.add(0.5, scene_.shape<PolyhedronShape>(shape),
                                          Vec3(0.02 * (i % 2), 0, 0.06 + 0.09 * i), random_.rotation()));
        }
    }
    void step() {
        scene_.world->stepSimulation(0.01, 1, 0.01);
        for (const btRigidBody* body : bodies_) {
            for (int i = 0; i < 3; ++i) {
                record_.push_back(body->getCenterOfMassPosition()[i]);
            }
        }
    }
    [[nodiscard]] const std::vector<double>& record() const { return record_; }
    [[nodiscard]] bool failed() const { return scene_.world->step_report().failed; }

  private:
    BulletScene scene_;
    Random random_;
    std::vector<btRigidBody*> bodies_;
    std::vector<double> record_;
};

constexpr int ticks = 40;

std::vector<double> alone(std::uint64_t seed) {
    Stones stones(seed);
    for (int i = 0; i < ticks; ++i) {
        stones.step();
    }
    CHECK_FALSE(stones.failed());
    return stones.record();
}

// A ball in a world of Bullet's own, fast enough to leave the box that Bullet's tree has for it in every
// tick.
class StockBall {
  public:
    StockBall() { ball_.setLinearVelocity(btVector3(10, 0, 0)); }
    void step() {
        scene_.world->stepSimulation(0.01, 1, 0.01);
        const auto& volume = static_cast<btDbvtProxy*>(ball_.getBroadphaseHandle())->leaf->volume;
        for (int i = 0; i < 3; ++i) {
            record_.insert(record_.end(), {position_of(ball_)[i], volume.Mins()[i], volume.Maxs()[i]});
        }
    }
    [[nodiscard]] const std::vector<double>& record() const { return record_; }

  private:
    StockScene scene_;
    btRigidBody& ball_ = scene_.add(1, scene_.shape<btSphereShape>(0.2), Vec3(0, 0, 5));
    std::vector<double> record_;
};

bool same_bytes(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("two worlds in one process know nothing of each other") {
    Stones one(5);
    Stones other(6);
    for (int i = 0; i < ticks; ++i) {
        one.step();
        other.step();
    }
    CHECK(same_bytes(one.record(), alone(5)));
    CHECK(same_bytes(other.record(), alone(6)));
    CHECK_FALSE(same_bytes(one.record(), other.record()));
}

TEST_CASE("two worlds in two threads know nothing of each other") {
    std::vector<double> one, other;
    const auto run = [](std::uint64_t seed, std::vector<double>& record) {
        Stones stones(seed);
        for (int i = 0; i < ticks; ++i) {
            stones.step();
        }
        record = stones.record();
    };
    std::thread first(run, 5, std::ref(one));
    std::thread second(run, 6, std::ref(other));
    first.join();
    second.join();
    CHECK(same_bytes(one, alone(5)));
    CHECK(same_bytes(other, alone(6)));
}

TEST_CASE("a world of Bullet's own in the same process is as if it were alone, at any moment") {
    // Bullet asks this while a world tells it where its bodies are.
    struct Meanwhile : btOverlapFilterCallback {
        StockBall& stock;
        explicit Meanwhile(StockBall& beside) : stock(beside) {}
        bool needBroadphaseCollision(btBroadphaseProxy* /*a*/, btBroadphaseProxy* /*b*/) const override {
            stock.step();
            return true;
        }
    };
    StockBall stock;
    Meanwhile meanwhile(stock);
    BulletScene scene;
    scene.broadphase.getOverlappingPairCache()->setOverlapFilterCallback(&meanwhile);
    scene.add_floor();
    scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.3));
    for (int i = 0; i < ticks; ++i) {
        scene.world->stepSimulation(0.01, 1, 0.01);
        stock.step();
    }
    REQUIRE(stock.record().size() / 9 > ticks);
    StockBall apart;
    while (apart.record().size() < stock.record().size()) {
        apart.step();
    }
    CHECK(same_bytes(stock.record(), apart.record()));
}
