#include <scree/dynamics/pair_motion.hpp>

namespace scree {

RelativeMotion relative_motion(const TrialBody& a, const TrialBody& b, const PairArms& arms) {
    return {(a.velocity - b.velocity) + a.spin.cross(arms.a) - b.spin.cross(arms.b), a.spin - b.spin};
}

void add_surface_motion(const Vec3& surface, const Vec3& normal, RelativeMotion& motion, MotionRates* rates) {
    const double across = surface.dot(normal);
    motion.velocity += surface - across * normal;
    if (rates != nullptr) {
        rates->velocity -= across * rates->normal;
        rates->velocity.noalias() -= normal * (surface.transpose() * rates->normal);
    }
}

// Everything is seen by an observer who moves with B, for whom only ξ, the motion of A against B, changes the
// geometry; then turned with B.
void motion_rates(const ContactGeometry& g, const RelativeMotion& motion, const TrialBody& a,
                  const TrialBody& b, const PairArms& arms, double beta_h, MotionRates& rates) {
    const Mat3 arm_a = cross_matrix(arms.a);
    const Mat3 arm_b = cross_matrix(arms.b);
    const Vec3 area_moment = g.area_moment();

    Mat69& xi = rates.xi;
    xi << beta_h * Mat3::Identity(), -arm_a * a.turn_rate, arm_b * b.turn_rate,  //
        Mat3::Zero(), a.turn_rate, -b.turn_rate;
    rates.turn_a.setZero();
    rates.turn_a.middleCols<3>(3) = a.turn_rate;
    rates.turn_b.setZero();
    rates.turn_b.rightCols<3>() = b.turn_rate;

    rates.volume.noalias() = g.area_vector.transpose() * xi.topRows<3>();
    rates.volume.noalias() += area_moment.transpose() * xi.bottomRows<3>();
    rates.normal.noalias() = g.normal_rate * xi;
    rates.normal.rightCols<3>() -= cross_matrix(g.normal) * b.turn_rate;

    Mat39 centroid;  // as the observer on B sees it
    centroid.noalias() = g.first_moment * xi.topRows<3>();
    centroid.noalias() += g.second_moment * xi.bottomRows<3>();
    centroid /= g.volume;
    rates.arm_b = centroid;
    rates.arm_b.rightCols<3>() -= arm_b * b.turn_rate;
    rates.arm_a = rates.arm_b;
    rates.arm_a.leftCols<3>() -= beta_h * Mat3::Identity();

    rates.spin << Mat3::Zero(), Mat3::Identity(), -Mat3::Identity();
    rates.velocity << Mat3::Identity(), -arm_a, arm_b;
    rates.velocity.noalias() += cross_matrix(a.spin) * rates.arm_a;
    rates.velocity.noalias() -= cross_matrix(b.spin) * rates.arm_b;

    // V̇ = S·v + (∫ r×n_A dA)·ω; S and the moment change along the boundary, the moment also with its point c.
    Eigen::Matrix<double, 6, 1> twist;
    twist << motion.velocity, motion.spin;
    const Eigen::Matrix<double, 1, 6> by_boundary = twist.transpose() * g.boundary;
    rates.volume_rate.noalias() = by_boundary * xi;
    rates.volume_rate.noalias() += g.area_vector.transpose() * rates.velocity;
    rates.volume_rate.noalias() += area_moment.transpose() * rates.spin;
    rates.volume_rate.noalias() -= g.area_vector.cross(motion.spin).transpose() * centroid;
    const Vec3 turned = g.area_vector.cross(motion.velocity) + area_moment.cross(motion.spin);
    rates.volume_rate.rightCols<3>() += turned.transpose() * b.turn_rate;
}

}  // namespace scree
