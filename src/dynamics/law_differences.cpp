#include <scree/dynamics/law_differences.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr double least = 64;  // roundings of the bodies' size

void turn(TrialBody& body, const Vec3& by_spin) {
    body.spin += by_spin;
    const Vec3 angle = body.turn_rate * by_spin;
    const Quat turned(Eigen::AngleAxisd(angle.norm(), angle.normalized()));
    body.pose.orientation = turned * body.pose.orientation;
    for (Quat& since : body.turns) {
        since = turned * since;
    }
}

}  // namespace

DifferenceSteps::DifferenceSteps(const PairConstants& pair, double depth, double beta_h) {
    const double size = pair.length;
    const double moved = std::max(std::sqrt(rounding * size * depth), least * rounding * size);
    velocity_ = moved / beta_h;
    spin_ = velocity_ / (0.5 * size);
}

NudgedPair::NudgedPair(const TrialBody& at_a, const TrialBody& at_b, int unknown, double step, double beta_h)
    : a(at_a), b(at_b) {
    const Vec3 change = step * Vec3::Unit(unknown % 3);
    if (unknown < 3) {
        a.velocity += change;
        a.pose.position += beta_h * change;
    } else {
        turn(unknown < 6 ? a : b, change);
    }
}

}  // namespace scree
