#pragma once

#include <tests/contact/law_path.hpp>
#include <tests/support/finite_difference.hpp>

namespace scree::test {

/// The law's derivative against differences: force over its size, moment over force and lever.
inline double law_error(const ContactCase& c, const LawPath& path,
                        FrictionLaw friction = FrictionLaw::cundall_strack) {
    const auto f = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        const ContactForce out = path.at(c, x).force_by(friction);
        Eigen::VectorXd all(6);
        all << out.force, out.moment;
        return all;
    };
    const MotionRates rates = path.rates(c);
    const ContactForce out = c.force_by(friction, &rates);
    Eigen::MatrixXd jacobian(6, 9);
    jacobian << out.force_rate, out.moment_rate;
    Eigen::VectorXd rows(6);
    rows << Vec3::Constant(c.normal_force()), Vec3::Constant(c.normal_force() * 0.03);
    return jacobian_error(f, Eigen::VectorXd::Zero(9), jacobian, Eigen::VectorXd::Ones(9), rows);
}

}  // namespace scree::test
