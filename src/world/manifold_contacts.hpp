#pragma once

#include <memory>
#include <span>
#include <unordered_map>

#include <scree/detect/manifold_geometry.hpp>
#include <scree/detect/pair_search.hpp>
#include <scree/dynamics/step_problem.hpp>

namespace scree {

/// The contacts whose geometry is Bullet's own manifold: those with open surfaces, or all of them.
class ManifoldContacts {
  public:
    explicit ManifoldContacts(btDispatcher& dispatcher) : dispatcher_(dispatcher) {}

    /// Whether they are all of them.
    void set_all(bool all) { all_ = all; }
    [[nodiscard]] bool all() const { return all_; }
    [[nodiscard]] bool wanted(const BodyShape& a, const BodyShape& b) const {
        return all_ || a.open || b.open;
    }
    [[nodiscard]] bool wanted(const BodyPart& a, const BodyPart& b) const;

    std::shared_ptr<const PairGeometry> make(const ManifoldGeometry::Side& a,
                                             const ManifoldGeometry::Side& b);

    /// Freezes the points of all of them anew, at the system's states at a `time` [s] and for the bodies that
    /// the search has seen. Those that were frozen at that time already, for as far a reach, stay.
    void freeze(const btDispatcherInfo& info, const System& system, std::span<const SearchBody> bodies,
                double time);

    /// How long [s], at most `span`, points may stay frozen: bodies that turn or slide farther come to touch
    /// at others.
    [[nodiscard]] double most_span(const System& system, double span) const;

    /// What they carry from one freezing to the next, in the order of the system's contacts.
    void save(const System& system, StateWriter& with) const;
    void restore(StateReader& with, const btDispatcherInfo& info, const System& system);

    /// An object is about to go.
    void forget(const btCollisionObject& object);

    /// The manifold of a contact, null when it has none.
    [[nodiscard]] btPersistentManifold* manifold(const Contact& contact) const;

  private:
    struct Made {
        std::shared_ptr<ManifoldGeometry> geometry;
        double time = -1;   ///< [s], of the last freezing
        double reach = -1;  ///< [m], that it was for
    };

    btDispatcher& dispatcher_;
    bool all_ = false;
    std::unordered_map<const PairGeometry*, Made> made_;
};

}  // namespace scree
