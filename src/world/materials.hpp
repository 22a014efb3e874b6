#pragma once

#include <functional>
#include <unordered_map>

#include <scree/contact/material.hpp>
#include <scree/world/dynamics_world.hpp>

#include "bodies.hpp"

namespace scree {

/// What bodies and pairs are made of: as given, or derived from what Bullet has.
class Materials {
  public:
    void give(const btCollisionObject& body, const Material& material) { given_[&body] = material; }
    void forget(const btCollisionObject& body) { given_.erase(&body); }
    void set_mixing(DynamicsWorld::Mixing mixing) { mixing_ = std::move(mixing); }

    /// Derives what was not given, for gravity [m/s²].
    void prepare(std::span<const WorldBody> bodies, std::span<const Body> physical, double gravity);

    [[nodiscard]] Material of(const WorldBody& body, const Body& physical, double gravity) const;

    /// Of bodies by number; prepare() must have seen them.
    [[nodiscard]] PairConstants constants(std::span<const WorldBody> bodies, std::span<const Body> physical,
                                          std::size_t a, std::size_t b) const;

  private:
    struct Known {
        Material material;
        bool given = false;
    };
    [[nodiscard]] PairMaterial pair(const WorldBody& a, const Known& known_a, const WorldBody& b,
                                    const Known& known_b) const;

    std::unordered_map<const btCollisionObject*, Material> given_;
    DynamicsWorld::Mixing mixing_;
    std::vector<Known> known_;  ///< by body number
};

}  // namespace scree
