#include <scree/dynamics/body.hpp>

namespace scree {

BodySize body_size(const Body& body) {
    BodySize size{body.mass, body.radius};
    if (body.dynamic() && (body.restraint == nullptr || !body.restraint->around.isZero(0))) {
        size.inertia = body.inertia;
    }
    return size;
}

Mat3 world_inertia(const Body& body, const Quat& orientation) {
    const Mat3 axes = orientation.toRotationMatrix();
    return axes * body.inertia.asDiagonal() * axes.transpose();
}

Vec3 velocity(const Body& body, const BodyState& state) {
    return body.dynamic() ? Vec3(state.momentum / body.mass) : state.momentum;
}

Vec3 spin(const Body& body, const BodyState& state) {
    if (!body.dynamic()) {
        return state.angular_momentum;
    }
    const Vec3 inner = state.orientation.conjugate() * state.angular_momentum;
    return state.orientation * Vec3(inner.cwiseQuotient(body.inertia));
}

}  // namespace scree
