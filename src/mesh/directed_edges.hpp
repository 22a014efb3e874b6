#pragma once

#include <cstdint>
#include <unordered_map>

namespace scree {

/// Which face owns the directed edge from one vertex to another.
class DirectedEdges {
  public:
    static constexpr int none = -1;

    void reserve(std::size_t edges) { owner_.reserve(edges); }

    /// False if the edge has an owner already.
    bool add(int from, int to, int face) { return owner_.emplace(key(from, to), face).second; }

    [[nodiscard]] int owner(int from, int to) const {
        const auto found = owner_.find(key(from, to));
        return found == owner_.end() ? none : found->second;
    }

  private:
    static std::uint64_t key(int from, int to) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32 |
               static_cast<std::uint32_t>(to);
    }

    std::unordered_map<std::uint64_t, int> owner_;
};

}  // namespace scree
