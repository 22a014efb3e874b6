#pragma once

#include <span>
#include <vector>

#include <scree/dynamics/contact.hpp>

namespace scree {

/// Groups of dynamic bodies that touch one another, directly or through others. Fixed bodies join nobody.
class Islands {
  public:
    /// From the contacts whose result has a force.
    void find(std::span<const Body> bodies, std::span<const Contact> contacts,
              std::span<const ContactResult> results);

    [[nodiscard]] std::size_t count() const { return begin_.size() - 1; }
    /// Numbers of the bodies of an island, ascending.
    [[nodiscard]] std::span<const int> bodies(std::size_t island) const;
    [[nodiscard]] int island_of(int body) const {
        return island_[static_cast<std::size_t>(body)];
    }  ///< −1: fixed
    /// A body's place within its island.
    [[nodiscard]] int place_of(int body) const { return place_[static_cast<std::size_t>(body)]; }

  private:
    int root(int body);

    std::vector<int> parent_, island_, place_, members_;
    std::vector<std::size_t> begin_{0};
};

}  // namespace scree
