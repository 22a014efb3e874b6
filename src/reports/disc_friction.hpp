#pragma once

namespace scree {

/// Friction on the base of a disc of even pressure that moves at v and turns at ω, `ratio` being v/(R ω): the
/// force over μ N, against the motion.
double disc_force(double ratio);
/// And the moment over μ N R, against the turning.
double disc_moment(double ratio);

}  // namespace scree
