#include <scree/dynamics/prescribed_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scree {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

}  // namespace

PrescribedMotionPath::PrescribedMotionPath(const PrescribedMotion& motion, const Pose& start,
                                           const Pose& inner)
    : motion_(motion), start_(start), inner_(inner), spin_(motion.angular_velocity.stableNorm()) {
    if (motion.vibrates()) {
        direction_ = motion.velocity.stableNormalized();
    }
    if (spin_ > 0) {
        axis_ = motion.angular_velocity / spin_;
    }
}

PathPoint PrescribedMotionPath::at(double time) const {
    const Quat turn(Eigen::AngleAxisd(spin_ * time, axis_));
    const Vec3 arm = start_.position - motion_.about;
    const Vec3 moved = displacement(time);
    PathPoint point;
    point.pose = {start_.position + moved, turn * start_.orientation};
    if (spin_ > 0) {
        point.pose.position += turn * arm - arm;
    }
    point.pose = point.pose * inner_;
    point.spin = motion_.angular_velocity;
    point.velocity = drift_velocity(time) + point.spin.cross(point.pose.position - (motion_.about + moved));
    point.surface_velocity = motion_.surface_velocity;
    return point;
}

double PrescribedMotionPath::phase(double time) const {
    return two_pi * motion_.frequency * time;
}

Vec3 PrescribedMotionPath::displacement(double time) const {
    if (motion_.vibrates()) {
        return motion_.amplitude * std::sin(phase(time)) * direction_;
    }
    return time * motion_.velocity;
}

Vec3 PrescribedMotionPath::drift_velocity(double time) const {
    if (motion_.vibrates()) {
        return two_pi * motion_.frequency * motion_.amplitude * std::cos(phase(time)) * direction_;
    }
    return motion_.velocity;
}

// No chord is longer than its arc, nor than twice the amplitude or the distance from the axis.
double PrescribedMotionPath::reach(double begin, double end, double radius) const {
    const double time = end - begin;
    double moved = time * motion_.velocity.norm();
    if (motion_.vibrates()) {
        moved = motion_.amplitude * std::min(phase(time), 2.0);
    }
    if (!(spin_ > 0)) {
        return moved;
    }
    const Vec3 arm = start_.position - motion_.about;
    const double origin = axis_.cross(arm).norm() + inner_.position.norm();
    return moved + (origin + radius) * std::min(spin_ * time, 2.0);
}

double PrescribedMotionPath::time_scale() const {
    const double fastest = std::max(motion_.vibrates() ? phase(1) : 0, spin_);
    return fastest > 0 ? 1 / fastest : std::numeric_limits<double>::infinity();
}

}  // namespace scree
