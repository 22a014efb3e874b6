#pragma once

#include <btBulletCollisionCommon.h>

#include <span>
#include <tuple>
#include <vector>

#include <scree/detect/body_shape.hpp>
#include <scree/mesh/saved_state.hpp>

namespace scree {

/// A body as the pair search sees it.
struct SearchBody {
    btCollisionObject* object = nullptr;  ///< in Bullet's world
    const BodyShape* shape = nullptr;     ///< kept alive by the caller
    Pose pose;                            ///< of the body's frame
    double reach = 0;      ///< [m], how far any of its points may come before the pairs are found anew
    bool dynamic = false;  ///< forces move it
    double skin = 0;       ///< [m], how far outside the shape it can be touched
};

/// Two parts that may come to touch, by the bodies' places in the search and the parts' in the bodies.
struct PartPair {
    int body_a = 0;  ///< place of the first body
    int body_b = 0;  ///< > body_a
    int part_a = 0;  ///< place of the part in A
    int part_b = 0;  ///< place of the part in B

    /// The same parts.
    bool operator==(const PartPair&) const = default;
    /// By bodies, then by parts.
    bool operator<(const PartPair& other) const {
        return std::tie(body_a, body_b, part_a, part_b) <
               std::tie(other.body_a, other.body_b, other.part_a, other.part_b);
    }
};
void visit_state(auto& with, StateOf<PartPair> auto& pair) {
    auto& [body_a, body_b, part_a, part_b] = pair;
    with(body_a, body_b, part_a, part_b);
}

/// Finds the pairs of parts that are nearer to each other than their bodies' reaches together. Bullet's
/// broadphase finds the candidates and its filters choose among them; what is left of them after tests with
/// the exact bounds depends on poses and reaches alone, not on what Bullet's trees remember.
class PairSearch {
  public:
    /// Sorted; valid until the next call.
    const std::vector<PartPair>& find(btCollisionWorld& world, std::span<const SearchBody> bodies);

    /// Only the first half of that: tells the broadphase where the bodies are.
    void place(btCollisionWorld& world, std::span<const SearchBody> bodies);

  private:
    struct PlacedPart {
        const Shape* shape = nullptr;
        Pose pose;
        Bounds box;         ///< tight
        double radius = 0;  ///< of the ball about pose.position that holds the part [m]
    };

    static bool near(const PlacedPart& a, const PlacedPart& b, double reach);
    static double height_above(const HalfSpace& ground, const PlacedPart& at, const PlacedPart& part);

    Bounds place_parts(const SearchBody& body);
    void number_objects(const btCollisionWorld& world, std::span<const SearchBody> bodies);
    [[nodiscard]] int number_of(const btBroadphaseProxy& proxy) const;
    void add_pairs(int a, int b, btDispatcher& dispatcher, std::span<const SearchBody> bodies);

    std::vector<PlacedPart> parts_;
    std::vector<std::size_t> first_part_;  ///< of each body, in parts_
    std::vector<int> numbers_;  ///< by Bullet's place of the object in its world; −1: not searched
    std::vector<PartPair> pairs_;
};

}  // namespace scree
