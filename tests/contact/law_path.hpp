#pragma once

#include <tests/support/contact_case.hpp>

namespace scree::test {

/// A smooth way for what a law sees to depend on nine unknowns, with random rates: V, S, n, the relative
/// motion, the arms and the turns of the bodies, and ∫ r×n_A dA with them. The patch's other moments stay,
/// and so does r̄, whose change the law's derivative leaves out. n need not follow S: a law must not ask.
class LawPath {
  public:
    LawPath(Random& random, const ContactCase& c, bool geometry_moves = true) {
        const auto matrix = [&](double size) {
            Mat39 m;
            for (int column = 0; column < 9; ++column) {
                m.col(column) = size * random.vector();
            }
            return m;
        };
        volume_ = (geometry_moves ? 0.3 : 0) * c.geometry.volume * matrix(1).row(0);
        normal_ = matrix(geometry_moves ? 0.3 : 0);
        velocity_ = matrix(0.3 * c.motion.velocity.norm());
        spin_ = matrix(0.3 * c.motion.spin.norm());
        turn_a_ = matrix(0.3);
        turn_b_ = matrix(0.3);
        arm_a_ = matrix(0.3 * c.arms.a.norm());
        arm_b_ = matrix(0.3 * c.arms.b.norm());
        const Mat36 by_xi = c.geometry.boundary.topRows<3>();
        const double most = by_xi.norm();
        const double motion = geometry_moves && most > 0 ? 0.3 * c.geometry.area / most : 0;
        xi_ << matrix(motion), matrix(motion);
        area_vector_ = by_xi * xi_;
        const Mat39 centroid = arm_b_ + cross_matrix(c.arms.b) * turn_b_;
        area_moment_ = c.geometry.boundary.bottomRows<3>() * xi_;
        area_moment_ += cross_matrix(c.geometry.area_vector) * centroid;
        area_moment_ -= cross_matrix(c.geometry.area_moment()) * turn_b_;
        if (!geometry_moves) {
            area_moment_.setZero();
        }
    }

    [[nodiscard]] ContactCase at(const ContactCase& start, const Eigen::VectorXd& x) const {
        ContactCase c = start;
        c.geometry.volume += volume_ * x;
        c.geometry.area_vector += area_vector_ * x;
        c.geometry.area = c.geometry.area_vector.norm();
        c.geometry.first_moment -= 0.5 * cross_matrix(area_moment_ * x);
        c.geometry.normal = (start.geometry.normal + normal_ * x).normalized();
        c.motion.velocity += velocity_ * x;
        c.motion.spin += spin_ * x;
        c.arms.a += arm_a_ * x;
        c.arms.b += arm_b_ * x;
        c.arms.frame_a = rotation(turn_a_ * x) * start.arms.frame_a;
        c.arms.frame_b = rotation(turn_b_ * x) * start.arms.frame_b;
        for (std::size_t j = 0; j < highest_order; ++j) {
            c.turn_a[j] = rotation(turn_a_ * x) * start.turn_a[j];
            c.turn_b[j] = rotation(turn_b_ * x) * start.turn_b[j];
        }
        return c;
    }

    [[nodiscard]] MotionRates rates(const ContactCase& c) const {
        const Vec3& n = c.geometry.normal;
        MotionRates rates;
        rates.xi = xi_;
        rates.volume = volume_;
        rates.volume_rate =
            c.geometry.area_vector.transpose() * velocity_ + c.geometry.area_moment().transpose() * spin_ +
            c.motion.velocity.transpose() * area_vector_ + c.motion.spin.transpose() * area_moment_;
        rates.normal = (Mat3::Identity() - n * n.transpose()) * normal_;
        rates.velocity = velocity_;
        rates.spin = spin_;
        rates.turn_a = turn_a_;
        rates.turn_b = turn_b_;
        rates.arm_a = arm_a_;
        rates.arm_b = arm_b_;
        return rates;
    }

  private:
    Row9 volume_;
    Mat69 xi_;
    Mat39 area_vector_, area_moment_, normal_, velocity_, spin_, turn_a_, turn_b_, arm_a_, arm_b_;
};

}  // namespace scree::test
