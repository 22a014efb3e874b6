#include "triangulate.hpp"

#include <algorithm>

namespace scree {

namespace {

using Triangles = std::vector<std::array<int, 3>>;

Triangles fanned(const std::vector<int>& loop) {
    Triangles triangles;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        triangles.push_back({loop[0], loop[i], loop[i + 1]});
    }
    return triangles;
}

/// Cuts ears off a polygon, judged in the plane of its area vector.
class EarCutter {
  public:
    EarCutter(const std::vector<Vec3>& points, std::vector<int> loop)
        : points_(points), loop_(std::move(loop)) {
        for (std::size_t i = 1; i + 1 < loop_.size(); ++i) {
            normal_ += (at(i) - at(0)).cross(at(i + 1) - at(0));
        }
    }

    /// Empty if there is no ear at some stage.
    Triangles run() {
        Triangles triangles;
        while (loop_.size() > 3) {
            std::size_t ear = 0;
            while (ear < loop_.size() && !is_ear(ear)) {
                ++ear;
            }
            if (ear == loop_.size()) {
                return {};
            }
            triangles.push_back({loop_[before(ear)], loop_[ear], loop_[after(ear)]});
            loop_.erase(loop_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        triangles.push_back({loop_[0], loop_[1], loop_[2]});
        return triangles;
    }

    [[nodiscard]] bool is_convex() const {
        for (std::size_t i = 0; i < loop_.size(); ++i) {
            if (turn(at(before(i)), at(i), at(after(i))) <= 0) {
                return false;
            }
        }
        return true;
    }

  private:
    [[nodiscard]] const Vec3& at(std::size_t i) const { return points_[loop_[i]]; }
    [[nodiscard]] std::size_t before(std::size_t i) const { return (i + loop_.size() - 1) % loop_.size(); }
    [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) % loop_.size(); }
    /// Positive where a, b, c turn left.
    [[nodiscard]] double turn(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return normal_.dot((b - a).cross(c - b));
    }

    [[nodiscard]] bool is_ear(std::size_t i) const {
        const Vec3& a = at(before(i));
        const Vec3& b = at(i);
        const Vec3& c = at(after(i));
        if (turn(a, b, c) <= 0) {
            return false;
        }
        return std::none_of(loop_.begin(), loop_.end(), [&](int v) {
            const Vec3& p = points_[v];
            const bool corner = p == a || p == b || p == c;
            return !corner && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    const std::vector<Vec3>& points_;
    std::vector<int> loop_;
    Vec3 normal_ = Vec3::Zero();
};

}  // namespace

Triangles triangulated(const std::vector<Vec3>& points, const std::vector<int>& loop) {
    // Cutting ears takes the cube of the number of corners at worst.
    constexpr std::size_t most_corners = 1000;
    if (loop.size() < 3) {
        return {};
    }
    EarCutter cutter(points, loop);
    if (loop.size() > 3 && loop.size() <= most_corners && !cutter.is_convex()) {
        if (Triangles triangles = cutter.run(); !triangles.empty()) {
            return triangles;
        }
    }
    return fanned(loop);
}

}  // namespace scree
