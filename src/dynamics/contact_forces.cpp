#include <scree/dynamics/contact_forces.hpp>

namespace scree {

ContactWorkspace& contact_workspace() {
    thread_local ContactWorkspace workspace;
    return workspace;
}

ContactWorkspace& second_contact_workspace() {
    thread_local ContactWorkspace workspace;
    return workspace;
}

bool locate(const Contact& contact, const TrialBody& a, const TrialBody& b, Detail detail,
            OverlapWorkspace& workspace, ContactGeometry& geometry, PairArms& arms) {
    const Pose pose_a = a.pose * contact.a.local;
    const Pose pose_b = b.pose * contact.b.local;
    const bool line = contact.history.centre_line;
    const bool touching =
        contact.geometry
            ? contact.geometry->geometry(pose_a, pose_b, detail, line, workspace, geometry)
            : overlap(*contact.a.shape, pose_a, *contact.b.shape, pose_b, detail, line, workspace, geometry);
    if (!touching) {
        return false;
    }
    arms.a = geometry.centroid + a.pose.orientation * contact.a.local.position;
    arms.b = arms.a + (a.pose.position - b.pose.position);
    arms.frame_a = a.pose.orientation;
    arms.frame_b = b.pose.orientation;
    return true;
}

const PatchCells* locate_cells(const Contact& contact, const TrialBody& a, const FrictionStep& step,
                               bool co_rotation, ContactWorkspace& workspace) {
    const ContactGeometry& g = workspace.geometry;
    PatchCells& cells = workspace.cells;
    cells.axis =
        patch_axis(contact.history, g.normal, g.normal.unitOrthogonal(), step, co_rotation, nullptr).axis;
    return cut_into_cells(g, a.pose * contact.a.local, workspace.overlap, cells) ? &cells : nullptr;
}

const DepthPotential* locate_potential(const Contact& contact, const TrialBody& a, Detail detail,
                                       ContactWorkspace& workspace) {
    const auto* solid = std::get_if<ConvexPolyhedron>(contact.a.shape);
    if (contact.geometry || solid == nullptr || !std::holds_alternative<ConvexPolyhedron>(*contact.b.shape)) {
        return nullptr;
    }
    depth_potential(*solid, a.pose * contact.a.local, workspace.geometry, detail, workspace.overlap,
                    workspace.potential);
    return &workspace.potential;
}

void account_as_lost(const ContactGeometry& geometry, const RelativeMotion& motion, ContactForce& law) {
    const double normal = law.force.dot(geometry.normal) * geometry.normal.dot(motion.velocity);
    law.power = {};
    law.power.normal = -normal;
    law.power.tangential = normal - law.force.dot(motion.velocity) - law.moment.dot(motion.spin);
}

void settle(const ContactGeometry& geometry, const RelativeMotion& motion, const TrialBody& a,
            const PairArms& arms, const MotionRates* rates, ContactResult& result) {
    const ContactForce& law = result.law;
    result.point = a.pose.position + arms.a;
    result.normal = geometry.normal;
    result.volume = geometry.volume;
    result.area = geometry.area;
    result.depth = geometry.depth;
    result.centre_line = geometry.centre_line;
    result.slip_speed = (motion.velocity - motion.velocity.dot(geometry.normal) * geometry.normal).norm();
    result.moment_a = law.moment + arms.a.cross(law.force);
    result.moment_b = -(law.moment + arms.b.cross(law.force));
    if (rates == nullptr) {
        return;
    }
    const Mat3 force = cross_matrix(law.force);
    result.moment_a_rate = law.moment_rate - force * rates->arm_a;
    result.moment_a_rate.noalias() += cross_matrix(arms.a) * law.force_rate;
    result.moment_b_rate = force * rates->arm_b - law.moment_rate;
    result.moment_b_rate.noalias() -= cross_matrix(arms.b) * law.force_rate;
}

}  // namespace scree
