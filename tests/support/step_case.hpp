#pragma once

#include <deque>
#include <limits>
#include <memory>

#include <scree/dynamics/step_problem.hpp>
#include <scree/mesh/mass_properties.hpp>

#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

namespace scree::test {

/// Stays at one point of a path.
class PointPath final : public PrescribedPath {
  public:
    explicit PointPath(const PathPoint& point) : point_(point) {}
    [[nodiscard]] PathPoint at(double /*time*/) const override { return point_; }
    [[nodiscard]] double reach(double /*begin*/, double /*end*/, double /*radius*/) const override {
        return 0;
    }
    [[nodiscard]] double time_scale() const override { return std::numeric_limits<double>::infinity(); }

  private:
    PathPoint point_;
};

/// A few bodies in contact, one implicit step of them, and the velocities at which to look at it.
struct StepCase {
    System system;
    std::deque<Shape> shapes;                           ///< that the colliders point to
    std::deque<std::unique_ptr<PrescribedPath>> paths;  ///< that the bodies point to
    PairMaterial material{1e7, 0.5, 0.5, 0.5, 2.0 / 7, true};
    double density = 2500;
    Eigen::VectorXd u;              ///< six a body
    std::vector<BodyState> before;  ///< one step before the states, for the second order

    StepCase() = default;
    StepCase(StepCase&&) = default;  // the shapes stay where they are

    /// A free body; a sphere or a polyhedron about its mass centre. Its frame need not have principal axes:
    /// the inertia is made up, and of the size of the true one.
    int add_body(const Shape& shape, const Pose& pose, const Vec3& velocity = Vec3::Zero(),
                 const Vec3& spin = Vec3::Zero()) {
        double volume = 0;
        if (const auto* solid = std::get_if<ConvexPolyhedron>(&shape)) {
            volume = mass_properties(*solid).volume;
        } else {
            volume = 4.0 / 3 * std::numbers::pi * std::pow(bounding_radius(shape), 3);
        }
        Body body;
        body.mass = density * volume;
        body.radius = sphere_radius(volume);
        body.inertia = 0.4 * body.mass * body.radius * body.radius * Vec3(0.9, 1, 1.2);
        return add(body, shape, pose, velocity, spin);
    }

    /// A body that moves as prescribed.
    int add_prescribed(const Shape& shape, const Pose& pose, const Vec3& velocity = Vec3::Zero(),
                       const Vec3& spin = Vec3::Zero()) {
        return add(Body{}, shape, pose, velocity, spin);
    }

    /// A body that is at a point of its path.
    int add_on_path(const Shape& shape, const PathPoint& point) {
        paths.push_back(std::make_unique<PointPath>(point));
        Body body;
        body.path = paths.back().get();
        return add(body, shape, point.pose, point.velocity, point.spin);
    }

    /// A contact between two bodies' first shapes.
    Contact& add_contact(int a, int b) { return add_contact({a, &at(a), {}}, {b, &at(b), {}}); }
    Contact& add_contact(const Collider& a, const Collider& b) {
        Contact contact{a, b, pair_constants(material, size(a.body), size(b.body)), {}};
        system.contacts.push_back(contact);
        return system.contacts.back();
    }

    /// Starts a step of BDF with equal steps h [s] and evaluates it at u.
    void begin(StepProblem& problem, double h, std::size_t order = 1,
               Detail detail = Detail::derivative) const {
        StepFormulas formulas;
        formulas.order = order;
        formulas.step = h;
        formulas.beta_h = order == 1 ? h : 2 * h / 3;
        formulas.past[0][0] = 1;
        formulas.past[1] = {4.0 / 3, -1.0 / 3};
        formulas.friction_beta_h = {h, 2 * h / 3};
        std::vector<BodyStart> starts;
        for (std::size_t b = 0; b < system.states.size(); ++b) {
            const double w = formulas.past[order - 1][0];
            const BodyState& last = system.states[b];
            const BodyState& early = before[b];
            BodyStart start;
            start.position = w * last.position + (1 - w) * early.position;
            start.orientation = w * last.orientation.coeffs() + (1 - w) * early.orientation.coeffs();
            start.momentum = w * last.momentum + (1 - w) * early.momentum;
            start.angular_momentum = w * last.angular_momentum + (1 - w) * early.angular_momentum;
            start.past_orientations.fill(Quat::Identity());
            start.past_orientations[0] = last.orientation;
            start.past_orientations[1] = early.orientation;
            starts.push_back(start);
        }
        problem.begin(formulas, starts);
        problem.evaluate(u, detail);
    }

    [[nodiscard]] BodySize size(int body) const {
        return body_size(system.bodies[static_cast<std::size_t>(body)]);
    }

  private:
    Shape& at(int body) { return shapes[static_cast<std::size_t>(body)]; }

    int add(const Body& body, const Shape& shape, const Pose& pose, const Vec3& velocity, const Vec3& spin) {
        const bool free = body.dynamic();
        system.bodies.push_back(body);
        shapes.push_back(shape);
        const Vec3 momentum = free ? Vec3(body.mass * velocity) : velocity;
        const Vec3 turning = free ? Vec3(world_inertia(body, pose.orientation) * spin) : spin;
        system.states.push_back({pose.position, pose.orientation, momentum, turning});
        before.push_back(system.states.back());
        u.conservativeResize(u.size() + 6);
        u.tail<6>() << velocity, spin;
        return static_cast<int>(system.bodies.size()) - 1;
    }
};

/// The law with the lever held at a value, and without the damping traction: what is left of it has its whole
/// derivative.
template <LawParts parts = LawParts{}>
struct WholeDerivativeLaw {
    static constexpr bool gives_rates = true;
    static constexpr bool gives_power = true;
    BuiltInLaw<parts> law;
    double lever = 0;

    void operator()(const ContactInput& in, ContactForce& out) const {
        ContactGeometry geometry = in.geometry;
        geometry.lever = lever;
        geometry.flat_patch = false;
        law({geometry, in.motion, in.pair, in.history, in.step, in.arms, in.rates, nullptr, in.potential},
            out);
    }
    [[nodiscard]] bool wants_potential() const { return law.wants_potential(); }
};

}  // namespace scree::test
