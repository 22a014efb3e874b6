#pragma once

#include <memory>
#include <vector>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/mesh/mass_properties.hpp>
#include <scree/world/dynamics_world.hpp>

/// For TEMPLATE_TEST_CASE: what holds in this world and in Bullet's own.
#define BOTH_WORLDS DynamicsWorld, btDiscreteDynamicsWorld

namespace scree::test {

/// A world, this one's or Bullet's own, with everything that Bullet wants beside it, and bodies that go with
/// it.
template <class World>
class SceneOf {
  public:
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    std::unique_ptr<World> world = std::make_unique<World>(&dispatcher, &broadphase, nullptr, &configuration);

    SceneOf() { world->setGravity(btVector3(0, 0, -9.81)); }
    ~SceneOf() {
        for (const auto& body : bodies_) {
            world->removeRigidBody(body.get());
        }
    }
    SceneOf(const SceneOf&) = delete;
    SceneOf& operator=(const SceneOf&) = delete;

    template <class ShapeType, class... Arguments>
    ShapeType& shape(Arguments&&... arguments) {
        shapes_.push_back(std::make_unique<ShapeType>(std::forward<Arguments>(arguments)...));
        return static_cast<ShapeType&>(*shapes_.back());
    }
    PolyhedronShape& box(const Vec3& edges) {
        return shape<PolyhedronShape>(std::make_shared<const Shape>(make_box(edges)));
    }

    /// A body that is not yet in the world; mass 0: fixed.
    btRigidBody& make(double mass, btCollisionShape& shape, const Vec3& position,
                      const Quat& orientation = Quat::Identity()) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) {
            inertia = inertia_of(mass, shape);
        }
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
        info.m_startWorldTransform = to_bullet(Pose{position, orientation});
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        return *bodies_.back();
    }
    btRigidBody& add(double mass, btCollisionShape& shape, const Vec3& position,
                     const Quat& orientation = Quat::Identity()) {
        btRigidBody& body = make(mass, shape, position, orientation);
        world->addRigidBody(&body);
        return body;
    }
    btRigidBody& add_floor() {
        return add(0, shape<btStaticPlaneShape>(btVector3(0, 0, 1), 0), Vec3::Zero());
    }
    void destroy(btRigidBody& body) {
        world->removeRigidBody(&body);
        std::erase_if(bodies_, [&](const auto& own) { return own.get() == &body; });
    }

  private:
    static btVector3 inertia_of(double mass, const btCollisionShape& shape) {
        if (const auto* polyhedron = dynamic_cast<const PolyhedronShape*>(&shape)) {
            const MassProperties of_one = mass_properties(std::get<ConvexPolyhedron>(*polyhedron->exact()));
            return to_bullet(mass / of_one.volume * of_one.inertia.diagonal());
        }
        btVector3 inertia;
        shape.calculateLocalInertia(mass, inertia);
        return inertia;
    }

    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

using BulletScene = SceneOf<DynamicsWorld>;
using StockScene = SceneOf<btDiscreteDynamicsWorld>;

inline Material rock(double youngs_modulus = 1e9, double friction = 0.5) {
    Material material;
    material.density = 2600;
    material.youngs_modulus = youngs_modulus;
    material.friction = friction;
    return material;
}

inline Vec3 position_of(const btRigidBody& body) {
    return to_eigen(body.getCenterOfMassPosition());
}

}  // namespace scree::test
