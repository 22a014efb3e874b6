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

    /// The contacts of bodies of these two materials, in either order, go by a law of that number.
    void set_law(const Material& a, const Material& b, int law);

    [[nodiscard]] Material of(const WorldBody& body, const Body& physical, double gravity) const;

    /// Of bodies by number; prepare() must have seen them.
    [[nodiscard]] PairConstants constants(std::span<const WorldBody> bodies, std::span<const Body> physical,
                                          std::size_t a, std::size_t b) const;
    [[nodiscard]] PairMaterial pair(std::span<const WorldBody> bodies, std::span<const Body> physical,
                                    std::size_t a, std::size_t b) const;

  private:
    struct Known {
        Material material;
        bool given = false;
    };
    struct PairLaw {
        Material a, b;
        int law = 0;
    };
    [[nodiscard]] int law_of(const Material& a, const Material& b) const;

    std::unordered_map<const btCollisionObject*, Material> given_;
    DynamicsWorld::Mixing mixing_;
    std::vector<PairLaw> laws_;  ///< the latest last
    std::vector<Known> known_;   ///< by body number
};

}  // namespace scree
