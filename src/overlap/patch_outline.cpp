#include <scree/overlap/patch_outline.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double parallel = 1e-9;  // sine between a face and the view, below which the face is seen edge-on

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Of a height h(x) = height + slope·x over the triangle of the centre and an edge p → q.
struct UnderHeight {
    double volume = 0;  // ∫ h dA
    double moment = 0;  // ∫ ‖x‖ h dA

    // In polar coordinates ∫ ‖x‖ h dA = ∫ (height/3 + slope·x/4) R³ dφ along the edge, where R³ dφ = d R dt
    // at the distance d of its line.
    UnderHeight(double height, const Vec2& slope, const Vec2& p, const Vec2& q) {
        const double twice = cross(p, q);
        volume = twice / 2 * (height + slope.dot(p + q) / 3);
        const Vec2 along = q - p;
        const double length = along.norm();
        if (length == 0 || std::abs(twice) <= 1e-12 * length * length) {
            return;
        }
        const double distance = twice / length;
        const Vec2 foot = p - along * (p.dot(along) / (length * length));
        const double steady = height / 3 + slope.dot(foot) / 4;
        const double rising = slope.dot(along) / (4 * length);
        moment = distance * (primitive(steady, rising, q.dot(along) / length, distance) -
                             primitive(steady, rising, p.dot(along) / length, distance));
    }

  private:
    // Of (steady + rising t) √(d² + t²).
    static double primitive(double steady, double rising, double t, double d) {
        const double r = std::hypot(t, d);
        return steady / 2 * (t * r + d * d * std::asinh(t / std::abs(d))) + rising / 3 * r * r * r;
    }
};

}  // namespace

void PatchOutline::see(const ClippedSolid& solid, const Vec3& centre, const Vec3& axis, const Vec3& normal) {
    centre_ = centre;
    normal_ = normal;
    view_ << axis.transpose(), normal.cross(axis).transpose();
    corners_.clear();
    for (const int vertex : solid.vertices()) {
        corners_.emplace_back(view_ * (solid.point(vertex) - centre));
    }
    find_hull();
    top_.clear();
    bottom_.clear();
    volume_ = moment_ = 0;
    for (const ClippedSolid::Face& face : solid.faces()) {
        add_face(solid, face);
    }
}

// By Andrew's monotone chain.
void PatchOutline::find_hull() {
    std::sort(corners_.begin(), corners_.end(), [](const Vec2& a, const Vec2& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    hull_.clear();
    const auto add = [&](const Vec2& point, std::size_t first) {
        while (hull_.size() > first + 1 &&
               cross(hull_.back() - hull_[hull_.size() - 2], point - hull_.back()) <= 0) {
            hull_.pop_back();
        }
        hull_.push_back(point);
    };
    for (const Vec2& corner : corners_) {
        add(corner, 0);
    }
    const std::size_t lower = hull_.empty() ? 0 : hull_.size() - 1;
    for (std::size_t i = corners_.size(); i-- > 0;) {
        add(corners_[i], lower);
    }
    if (!hull_.empty()) {
        hull_.pop_back();  // the first again
    }
}

void PatchOutline::add_face(const ClippedSolid& solid, const ClippedSolid::Face& face) {
    const auto corner = [&](int e) -> Vec3 {
        return solid.point(solid.half_edges()[static_cast<std::size_t>(e)].vertex) - centre_;
    };
    const Vec3 first = corner(face.begin);
    Vec3 area = Vec3::Zero();
    for (int e = face.begin + 1; e + 1 < face.end; ++e) {
        area += (corner(e) - first).cross(corner(e + 1) - first);
    }
    const double along = area.dot(normal_);
    if (std::abs(along) <= parallel * area.norm()) {
        return;
    }
    const Sheet sheet{area.dot(first) / along, -view_ * area / along};
    (along > 0 ? top_ : bottom_).push_back(sheet);
    for (int e = face.begin; e < face.end; ++e) {
        const UnderHeight part(sheet.height, sheet.slope, view_ * corner(e),
                               view_ * corner(e + 1 < face.end ? e + 1 : face.begin));
        volume_ += part.volume;
        moment_ += part.moment;
    }
}

bool PatchOutline::surrounds_origin() const {
    for (std::size_t i = 0; i < hull_.size(); ++i) {
        if (!(cross(hull_[i], hull_[(i + 1) % hull_.size()]) > 0)) {
            return false;
        }
    }
    return hull_.size() >= 3 && volume_ > 0 && moment_ > 0;
}

double PatchOutline::reach(const Vec2& direction) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull_.size(); ++i) {
        const Vec2& p = hull_[i];
        const Vec2& q = hull_[(i + 1) % hull_.size()];
        const double towards = cross(direction, q - p);
        if (towards > 0) {
            least = std::min(least, cross(p, q) / towards);
        }
    }
    return least;
}

double PatchOutline::depth(const Vec2& at) const {
    double high = std::numeric_limits<double>::infinity();
    double low = -high;
    for (const Sheet& sheet : top_) {
        high = std::min(high, sheet.height + sheet.slope.dot(at));
    }
    for (const Sheet& sheet : bottom_) {
        low = std::max(low, sheet.height + sheet.slope.dot(at));
    }
    return high > low ? high - low : 0;
}

}  // namespace scree
