#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/detect/pair_search.hpp>
#include <scree/overlap/overlap.hpp>
#include <scree/overlap/separation.hpp>
#include <tests/support/random.hpp>

using namespace scree;

namespace {

// A collision world without dynamics, and what the search is to find in it.
struct Scene {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    std::unique_ptr<btBroadphaseInterface> broadphase;
    std::unique_ptr<btCollisionWorld> world;
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<BodyShape>> exact;
    std::vector<std::unique_ptr<btCollisionObject>> objects;
    std::vector<SearchBody> bodies;
    ShapeLibrary library;
    PairSearch search;

    explicit Scene(std::unique_ptr<btBroadphaseInterface> pairs = std::make_unique<btDbvtBroadphase>())
        : broadphase(std::move(pairs)) {
        world = std::make_unique<btCollisionWorld>(&dispatcher, broadphase.get(), &configuration);
    }
    ~Scene() {
        for (const auto& object : objects) {
            world->removeCollisionObject(object.get());
        }
    }

    std::size_t add(std::unique_ptr<btCollisionShape> shape, const Pose& pose, double reach = 0,
                    int group = 1, int mask = -1) {
        objects.push_back(std::make_unique<btCollisionObject>());
        objects.back()->setCollisionShape(shape.get());
        objects.back()->setCollisionFlags(btCollisionObject::CF_DYNAMIC_OBJECT);
        objects.back()->setWorldTransform(to_bullet(pose));
        world->addCollisionObject(objects.back().get(), group, mask);
        exact.push_back(std::make_unique<BodyShape>(library.translate(*shape)));
        shapes.push_back(std::move(shape));
        bodies.push_back({objects.back().get(), exact.back().get(), pose, reach, true});
        return bodies.size() - 1;
    }
    std::size_t add_box(const Vec3& position, double edge = 1) {
        const btVector3 half(edge / 2, edge / 2, edge / 2);
        return add(std::make_unique<btBoxShape>(half), {position, Quat::Identity()});
    }
    const std::vector<PartPair>& find() { return search.find(*world, bodies); }
};

std::unique_ptr<btCollisionShape> stone(test::Random& random, double size) {
    return std::make_unique<PolyhedronShape>(std::make_shared<const Shape>(random.polyhedron(9, size)));
}

void fill(Scene& scene, std::uint64_t seed, double size, int count) {
    test::Random random(seed);
    scene.add(std::make_unique<btStaticPlaneShape>(btVector3(0, 0.6, 0.8), -0.2 * size), Pose());
    scene.bodies.back().dynamic = false;
    for (int i = 0; i < count; ++i) {
        const Pose pose{size * random.vector(-4, 4), random.rotation()};
        const double reach = size * random.uniform(0, 0.2);
        if (i % 7 == 0) {
            scene.add(std::make_unique<btSphereShape>(size * 0.6), pose, reach);
        } else if (i % 5 == 0) {
            auto pair = std::make_unique<btCompoundShape>();
            scene.shapes.push_back(stone(random, size));
            for (const double offset : {-0.5, 0.5}) {
                const Pose local{size * offset * Vec3::UnitX(), random.rotation()};
                pair->addChildShape(to_bullet(local), scene.shapes.back().get());
            }
            scene.add(std::move(pair), pose, reach);
        } else {
            scene.add(stone(random, size), pose, reach);
        }
        scene.bodies.back().dynamic = i % 4 != 0;
    }
}

// What the search promises, asked of all pairs of parts: boxes and balls nearer than the reaches and no axis
// of faces or centres that parts them more, and for a half-space the lowest point.
bool expected(const SearchBody& a, const BodyPart& part_a, const SearchBody& b, const BodyPart& part_b) {
    const double reach = a.reach + b.reach;
    const Pose pose_a = a.pose * part_a.local;
    const Pose pose_b = b.pose * part_b.local;
    if (const auto* ground = std::get_if<HalfSpace>(part_a.shape.get())) {
        if (const auto* ball = std::get_if<Sphere>(part_b.shape.get())) {
            return ground->normal.dot(pose_b.position) - ground->offset - ball->radius <= reach;
        }
        double lowest = std::numeric_limits<double>::infinity();
        for (const Vec3& vertex : std::get<ConvexPolyhedron>(*part_b.shape).vertices) {
            lowest = std::min(lowest, ground->normal.dot(pose_b * vertex) - ground->offset);
        }
        return lowest <= reach;
    }
    const Bounds box_a = bounds(*part_a.shape, pose_a);
    const Bounds box_b = bounds(*part_b.shape, pose_b);
    for (int axis = 0; axis < 3; ++axis) {
        if (box_a.low[axis] - box_b.high[axis] > reach || box_b.low[axis] - box_a.high[axis] > reach) {
            return false;
        }
    }
    return (pose_a.position - pose_b.position).norm() <=
               bounding_radius(*part_a.shape) + bounding_radius(*part_b.shape) + reach &&
           separation(*part_a.shape, pose_a, *part_b.shape, pose_b).gap <= reach;
}

std::vector<PartPair> by_brute_force(const std::vector<SearchBody>& bodies) {
    std::vector<PartPair> pairs;
    for (int a = 0; a < static_cast<int>(bodies.size()); ++a) {
        for (int b = a + 1; b < static_cast<int>(bodies.size()); ++b) {
            const SearchBody& one = bodies[static_cast<std::size_t>(a)];
            const SearchBody& other = bodies[static_cast<std::size_t>(b)];
            for (int i = 0; i < static_cast<int>(one.shape->parts.size()); ++i) {
                for (int j = 0; j < static_cast<int>(other.shape->parts.size()); ++j) {
                    if ((one.dynamic || other.dynamic) &&
                        expected(one, one.shape->parts[static_cast<std::size_t>(i)], other,
                                 other.shape->parts[static_cast<std::size_t>(j)])) {
                        pairs.push_back({a, b, i, j});
                    }
                }
            }
        }
    }
    return pairs;
}

}  // namespace

TEST_CASE("the pair list is that of brute force, in any broadphase and at any size") {
    const double size = GENERATE(1.0, 1e-3);
    const bool sweep = GENERATE(false, true);
    std::unique_ptr<btBroadphaseInterface> pairs = std::make_unique<btDbvtBroadphase>();
    if (sweep) {
        pairs = std::make_unique<bt32BitAxisSweep3>(btVector3(-9, -9, -9), btVector3(9, 9, 9));
    }
    Scene scene(std::move(pairs));
    fill(scene, 7, size, 150);
    const std::vector<PartPair> all = by_brute_force(scene.bodies);
    CHECK(all.size() > 150);
    CHECK((scene.find() == all));

    // The same again after everything has moved: the list does not depend on where things were.
    test::Random random(8);
    for (int turn = 0; turn < 5; ++turn) {
        for (SearchBody& body : scene.bodies) {
            if (body.dynamic) {
                body.pose.position += size * random.vector(-0.4, 0.4);
                body.pose.orientation = random.rotation();
            }
        }
        CHECK((scene.find() == by_brute_force(scene.bodies)));
    }
}

TEST_CASE("every pair that overlaps is found") {
    Scene scene;
    fill(scene, 9, 0.01, 120);
    for (SearchBody& body : scene.bodies) {
        body.reach = 0;
        body.dynamic = true;
    }
    const std::vector<PartPair> found = scene.find();
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    const auto polyhedron_or_plane = [](const BodyPart& part) {
        return !std::holds_alternative<Sphere>(*part.shape);
    };
    std::size_t overlapping = 0;
    for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
            const BodyPart& one = scene.bodies[a].shape->parts[0];
            const BodyPart& other = scene.bodies[b].shape->parts[0];
            if (!polyhedron_or_plane(one) || !polyhedron_or_plane(other)) {
                continue;
            }
            if (overlap(*one.shape, scene.bodies[a].pose * one.local, *other.shape,
                        scene.bodies[b].pose * other.local, Detail::force, false, workspace, geometry)) {
                ++overlapping;
                const PartPair pair{static_cast<int>(a), static_cast<int>(b), 0, 0};
                CHECK(std::binary_search(found.begin(), found.end(), pair));
            }
        }
    }
    CHECK(overlapping > 50);
}

TEST_CASE("Bullet's filters choose the pairs") {
    Scene scene;
    scene.add_box(Vec3(0, 0, 0));
    scene.add_box(Vec3(0.5, 0, 0));
    const PartPair both{0, 1, 0, 0};

    SECTION("nothing said") {
        CHECK((scene.find() == std::vector{both}));
    }
    SECTION("bodies that ignore each other") {
        scene.objects[1]->setIgnoreCollisionCheck(scene.objects[0].get(), true);
        CHECK(scene.find().empty());
    }
    SECTION("a body without contact response") {
        scene.objects[1]->setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
        CHECK(scene.find().empty());
    }
    SECTION("no body that forces move") {
        scene.bodies[0].dynamic = scene.bodies[1].dynamic = false;
        CHECK(scene.find().empty());
    }
    SECTION("groups and masks") {
        scene.add(std::make_unique<btSphereShape>(0.5), Pose{Vec3(0.2, 0, 0), Quat::Identity()}, 0, 2, 4);
        CHECK((scene.find() == std::vector{both}));
    }
}

TEST_CASE("Bullet's tree margin, which all worlds share, is never touched") {
    struct Watched : btDbvtBroadphase {
        btScalar margin = gDbvtMargin;
        int told = 0;
        void setAabb(btBroadphaseProxy* proxy, const btVector3& low, const btVector3& high,
                     btDispatcher* dispatcher) override {
            CHECK(gDbvtMargin == margin);
            ++told;
            btDbvtBroadphase::setAabb(proxy, low, high, dispatcher);
        }
    };
    auto pairs = std::make_unique<Watched>();
    const Watched& watched = *pairs;
    Scene scene(std::move(pairs));
    fill(scene, 10, 0.01, 20);
    scene.find();
    for (SearchBody& body : scene.bodies) {
        body.pose.position.x() += 1e-6;
    }
    scene.find();
    CHECK(watched.told >= 10);
    CHECK(gDbvtMargin == watched.margin);
}

TEST_CASE("Bullet's tree has a body's box with a twentieth of its radius around") {
    Scene scene;
    scene.add_box(Vec3(0, 0, 0), 0.1);
    scene.bodies[0].pose.position.x() = 5;
    scene.find();
    const btBroadphaseProxy& proxy = *scene.objects[0]->getBroadphaseHandle();
    CHECK(proxy.m_aabbMin.x() == Approx(4.95));
    const double around = 0.05 * scene.exact[0]->radius;
    CHECK(static_cast<const btDbvtProxy&>(proxy).leaf->volume.Mins().x() == Approx(4.95 - around));
    CHECK(static_cast<const btDbvtProxy&>(proxy).leaf->volume.Maxs().z() == Approx(0.05 + around));
}

TEST_CASE("the bound on a body's motion holds for its points and is not far off") {
    test::Random random(11);
    for (int i = 0; i < 200; ++i) {
        const Pose from{random.vector(), random.rotation()};
        const Pose to{from.position + 0.1 * random.vector(), random.rotation()};
        const double bound = largest_move(from, to, 0.5);
        double farthest = 0;
        for (int j = 0; j < 100; ++j) {
            const Vec3 point = 0.5 * random.direction();
            farthest = std::max(farthest, (to * point - from * point).norm());
        }
        CHECK(farthest <= bound * (1 + 1e-12));
        CHECK(farthest >= 0.7 * bound);
    }
    const double unbounded = std::numeric_limits<double>::infinity();
    CHECK(largest_move({Vec3::Zero(), Quat::Identity()}, {Vec3::UnitX(), Quat::Identity()}, unbounded) == 1);
}
