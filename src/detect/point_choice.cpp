#include "point_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/overlap/round_spot.hpp>

namespace scree {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_spacing = 0.02;  // of the root of the area, as Bullet keeps its own points apart
constexpr double one_plane = 0.99;      // cosine between normals, from which points may be the same
constexpr double known_wider = 1.5;     // how much more a known point counts
constexpr double as_deep = 0.1;         // of the spacing, within which points count as the deepest
constexpr double slack_kept = 0.9;      // from one update to the next

/// How well a shape keeps a plane under points that move over it: round ones roll away from theirs, a
/// polyhedron's end at its edges, ground goes on.
int flatness(const Shape& shape) {
    if (std::holds_alternative<HalfSpace>(shape) || std::holds_alternative<OpenSurface>(shape)) {
        return 2;
    }
    return std::holds_alternative<ConvexPolyhedron>(shape) ? 1 : 0;
}

// A small body's corners stay its own while it slides over a large one's face, and not the other way round.
FrozenPoints::Planes planes_between(const Shape& a, const Shape& b) {
    const bool alike = flatness(a) == flatness(b);
    const bool a_has_them = alike ? bounding_radius(a) > bounding_radius(b) : flatness(a) > flatness(b);
    return a_has_them ? FrozenPoints::Planes::of_a : FrozenPoints::Planes::of_b;
}

}  // namespace

PointChoice::PointChoice(const ManifoldGeometry::Side& a, const ManifoldGeometry::Side& b,
                         const ManifoldGeometry::Situation& now, const FrozenPoints& before)
    : shape_a_(*a.part.shape),
      shape_b_(*b.part.shape),
      pose_a_(now.body_a * a.part.local),
      pose_b_(now.body_b * b.part.local),
      planes_(planes_between(shape_a_, shape_b_)),
      skin_a_(planes_ == FrozenPoints::Planes::of_b ? a.part.skin : 0),
      skin_b_(planes_ == FrozenPoints::Planes::of_a ? b.part.skin : 0),
      spacing_(least_spacing * std::sqrt(now.area)),
      growth_(now.growth),
      before_(before) {}

void PointChoice::offer(const std::vector<SurfacePoint>& points) {
    for (const SurfacePoint& point : points) {
        offers_.push_back(made_of(point));
    }
}

PointChoice::Offer PointChoice::made_of(const SurfacePoint& point) const {
    const bool of_a = planes_ == FrozenPoints::Planes::of_a;
    const Vec3 normal_a = pose_a_.orientation.conjugate() * point.normal;
    const Vec3 normal_b = pose_b_.orientation.conjugate() * point.normal;
    RoundSpot a = round_spot(shape_a_, pose_a_.inverse() * point.on_a, -normal_a);
    RoundSpot b = round_spot(shape_b_, pose_b_.inverse() * point.on_b, normal_b);
    if (a.radius == 0) {  // a corner rolls on its margin
        a = {a.centre + skin_a_ * normal_a, skin_a_};
    }
    if (b.radius == 0) {
        b = {b.centre - skin_b_ * normal_b, skin_b_};
    }
    return {{a.centre, b.centre, of_a ? Vec3(-normal_a) : normal_b, a.radius, b.radius, 0},
            of_a ? pose_b_ * b.centre : pose_a_ * a.centre,
            point.normal,
            -point.distance(),
            before_.load_near(a.centre, b.centre, pose_a_, pose_b_, spacing_)};
}

std::vector<FrozenPoint> PointChoice::choose() {
    std::vector<FrozenPoint> chosen;
    const Vec3 middle = middle_of_deepest();
    while (chosen.size() < MANIFOLD_CACHE_SIZE) {
        const Offer* best = nullptr;
        double most = -infinity;
        for (const Offer& offer : offers_) {
            if (const double own = merit(offer, middle); own > most) {
                most = own;
                best = &offer;
            }
        }
        if (best == nullptr) {
            break;
        }
        taken_.push_back(*best);
        chosen.push_back(best->point);
        chosen.back().slack = slack(*best);
    }
    return chosen;
}

// A point that is found deep where nothing was expected has not been pressed in, and must not spring back as
// if it had: what was no load before becomes one little by little.
double PointChoice::slack(const Offer& offer) const {
    const double unloaded = std::max(0.0, offer.depth - offer.load.value_or(0));
    return std::max(slack_kept * unloaded, unloaded - growth_);
}

double PointChoice::merit(const Offer& offer, const Vec3& middle) const {
    const double width = taken_.empty() ? across(offer, middle) : width_beside_taken(offer);
    if (taken_.empty() ? !is_deepest(offer) : width <= spacing_) {
        return -infinity;
    }
    return (offer.load ? known_wider * width : width) + std::min(0.0, offer.depth);
}

double PointChoice::across(const Offer& offer, const Vec3& from) {
    const Vec3 apart = offer.where - from;
    return (apart - apart.dot(offer.normal) * offer.normal).norm();
}

// Infinite where none of them has that normal.
double PointChoice::width_beside_taken(const Offer& offer) const {
    double least = infinity;
    for (const Offer& taken : taken_) {
        if (offer.normal.dot(taken.normal) > one_plane) {
            least = std::min(least, across(offer, taken.where));
        }
    }
    return least;
}

bool PointChoice::is_deepest(const Offer& offer) const {
    return std::all_of(offers_.begin(), offers_.end(),
                       [&](const Offer& other) { return offer.depth >= other.depth - as_deep * spacing_; });
}

Vec3 PointChoice::middle_of_deepest() const {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const Offer& offer : offers_) {
        if (is_deepest(offer)) {
            sum += offer.where;
            ++count;
        }
    }
    return count > 0 ? Vec3(sum / count) : sum;
}

}  // namespace scree
