#include "expected_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/detect/convert.hpp>

namespace scree {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int ways = 6;               // to be turned: more than the corners of any face need
constexpr double first_way = 0.3;     // [rad], across no axis that a face is likely to have
constexpr double least_turn = 0.02;   // [rad]
constexpr double largest_turn = 0.3;  // [rad]

// Boxes and cylinders have their margin inside: to Bullet's search for nearest points their corners and rims
// are rounded by it. This gives a point there its place on the true shape.
Vec3 sharpened(const ManifoldGeometry::Side& side, const Vec3& point) {
    const btCollisionShape& shape = *side.part.bullet;
    const double round = 1.001 * shape.getMargin();
    const auto out = [round](double coordinate, double half) {
        return std::abs(coordinate) > half - round ? std::copysign(half, coordinate) : coordinate;
    };
    if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) {
        const Vec3 half = to_eigen(static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin());
        return {out(point.x(), half.x()), out(point.y(), half.y()), out(point.z(), half.z())};
    }
    const auto* cylinder = std::get_if<Frustum>(side.part.shape.get());
    const double from_axis = point.head<2>().norm();
    if (cylinder == nullptr || shape.getShapeType() != CYLINDER_SHAPE_PROXYTYPE || from_axis == 0) {
        return point;
    }
    const double widened = out(from_axis, cylinder->bottom) / from_axis;
    return {widened * point.x(), widened * point.y(), out(point.z(), cylinder->half_height)};
}

class Expectation {
  public:
    Expectation(btDispatcher& dispatcher, const ManifoldGeometry::Side& a, const ManifoldGeometry::Side& b,
                const ManifoldGeometry::Situation& now, const btDispatcherInfo& info)
        : a_(a),
          b_(b),
          now_(now),
          surface_(BulletPair(a, now.body_a, b, now.body_b).surface(now.reach)),
          query_(dispatcher, BulletPair(a, now.body_a, b, now.body_b), surface_, info) {
        const double radius_a = bounding_radius(*a.part.shape);
        const double radius_b = bounding_radius(*b.part.shape);
        turns_a_ = radius_a <= radius_b;
        // What it may turn by until its far side is nearer by the reach.
        turning_ = std::clamp(2 * now.reach / std::min(radius_a, radius_b), least_turn, largest_turn);
    }

    std::vector<SurfacePoint> find() {
        points_ = query_.ask(BulletPair(a_, now_.body_a, b_, now_.body_b), now_.reach);
        if (points_.empty()) {
            return {};
        }
        const Vec3 normal = points_.front().normal;
        if (!is_ball(a_) && !is_ball(b_)) {
            for (const double angle : {turning_, largest_turn}) {
                for (int way = 0; way < ways; ++way) {
                    const Quat aside(Eigen::AngleAxisd(first_way + 2 * pi * way / ways, normal));
                    add_turned(angle, Quat(Eigen::AngleAxisd(angle, aside * normal.unitOrthogonal())));
                }
            }
        }
        for (SurfacePoint& point : points_) {
            const Pose pose_a = now_.body_a * a_.part.local;
            const Pose pose_b = now_.body_b * b_.part.local;
            point.on_a = pose_a * sharpened(a_, pose_a.inverse() * point.on_a);
            point.on_b = pose_b * sharpened(b_, pose_b.inverse() * point.on_b);
            point.normal = same_face(point.normal) ? normal : point.normal;
        }
        std::erase_if(points_, [this](const SurfacePoint& point) { return point.distance() > now_.reach; });
        return std::move(points_);
    }

  private:
    static bool is_ball(const ManifoldGeometry::Side& side) {
        return std::holds_alternative<Sphere>(*side.part.shape);
    }

    [[nodiscard]] bool same_face(const Vec3& normal) const {
        return normal.dot(points_.front().normal) > std::cos(2 * largest_turn);
    }

    // What is found there is put where it is in the bodies as they stand. The one that is turned is lifted
    // off, so that it is never deep in the other, where nearest points mean little.
    void add_turned(double angle, const Quat& turn) {
        Pose body_a = now_.body_a;
        Pose body_b = now_.body_b;
        Pose& turned = turns_a_ ? body_a : body_b;
        const ManifoldGeometry::Side& side = turns_a_ ? a_ : b_;
        const Vec3 centre = turned * side.part.local.position;
        const double sunk = std::max(0.0, -points_.front().distance());
        const double lift = std::sin(angle) * bounding_radius(*side.part.shape) + sunk;
        turned = {
            centre + turn * (turned.position - centre) + (turns_a_ ? lift : -lift) * points_.front().normal,
            turn * turned.orientation};
        for (SurfacePoint& point : query_.ask(BulletPair(a_, body_a, b_, body_b), now_.reach + 2 * lift)) {
            // A margin outside is a ball about each of the points inside, which stays where it is.
            point.on_a = now_.body_a * (body_a.inverse() * (point.on_a + a_.part.skin * point.normal));
            point.on_b = now_.body_b * (body_b.inverse() * (point.on_b - b_.part.skin * point.normal));
            point.normal = same_face(point.normal) ? points_.front().normal : point.normal;
            point.on_a -= a_.part.skin * point.normal;
            point.on_b += b_.part.skin * point.normal;
            points_.push_back(point);
        }
    }

    const ManifoldGeometry::Side& a_;
    const ManifoldGeometry::Side& b_;
    const ManifoldGeometry::Situation& now_;
    std::optional<MeshSurface> surface_;
    NearestQuery query_;
    bool turns_a_ = true;
    double turning_ = 0;
    std::vector<SurfacePoint> points_;
};

}  // namespace

std::vector<SurfacePoint> expected_points(btDispatcher& dispatcher, const ManifoldGeometry::Side& a,
                                          const ManifoldGeometry::Side& b,
                                          const ManifoldGeometry::Situation& now,
                                          const btDispatcherInfo& info) {
    return Expectation(dispatcher, a, b, now, info).find();
}

}  // namespace scree
