#include <scree/contact/normal_force.hpp>

namespace scree {

namespace {

// The traction cn (n_A·v_rel) n on the patch, its moment about the centroid. The mean of the integrals over
// A's and over B's surface is taken, so that the bodies' order does not matter; they differ by the overlap's
// volume. The derivative follows the motion and leaves the patch's own change out, which is of higher order
// in the overlap.
void add_rocking_damping(const ContactInput& in, ContactForce& out) {
    const ContactGeometry& g = in.geometry;
    const Mat3 across = -in.pair.normal_damping * g.tilting * cross_matrix(g.normal);
    const Mat3 by_velocity = across * (g.first_moment - 0.5 * g.volume * Mat3::Identity());
    const Mat3 by_spin = across * g.second_moment;
    out.moment += by_velocity * in.motion.velocity + by_spin * in.motion.spin;
    if (in.rates != nullptr) {
        out.moment_rate.noalias() += by_velocity * in.rates->velocity;
        out.moment_rate.noalias() += by_spin * in.rates->spin;
    }
}

}  // namespace

double volume_rate(const ContactGeometry& geometry, const RelativeMotion& motion) {
    return geometry.area_vector.dot(motion.velocity) + geometry.area_moment().dot(motion.spin);
}

bool add_normal_force(const ContactInput& in, ContactForce& out, Row9& normal_force_rate) {
    const ContactGeometry& g = in.geometry;
    const double elastic = in.pair.elastic * g.volume;
    const double stored = -elastic * g.normal.dot(in.motion.velocity);
    if (g.depth_moment >= 0) {
        out.normal_energy = in.pair.elastic * g.depth_moment;
    } else {
        out.power.normal_elastic = stored;
    }
    out.power.normal_damping = -stored;  // less the work of the force, below
    const double fn = elastic + in.pair.normal_damping * volume_rate(g, in.motion);
    if (!(fn > 0)) {
        return false;
    }
    out.normal_force = fn;
    out.force += fn * g.normal;
    if (in.rates != nullptr) {
        normal_force_rate =
            in.pair.elastic * in.rates->volume + in.pair.normal_damping * in.rates->volume_rate;
        out.force_rate.noalias() += g.normal * normal_force_rate;
        out.force_rate.noalias() += fn * in.rates->normal;
    }
    if (g.flat_patch) {
        add_rocking_damping(in, out);
    }
    out.power.normal = -(out.force.dot(in.motion.velocity) + out.moment.dot(in.motion.spin));
    out.power.normal_damping += out.power.normal;
    return true;
}

}  // namespace scree
