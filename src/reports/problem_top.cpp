// A free asymmetric top: Euler's equations in Jacobi's elliptic functions.

#include <array>
#include <cmath>

#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

const Vec3 edges(0.2, 0.1414213562373095, 0.02);  // [m]: moments nearly as 1 : 2 : 3
const Vec3 first_spin(1.2, 0.7, 2.0);             // ω [rad/s] at first, in the top's own axes

/// Principal moments [kg m²].
Vec3 moments() {
    const Vec3 squares = edges.cwiseAbs2();
    return 2600 * edges.prod() / 12 * (Vec3::Constant(squares.sum()) - squares);
}

Vec3 first_momentum() {
    return moments().cwiseProduct(first_spin);
}

struct Elliptic {
    double sn = 0, cn = 1, dn = 1;
};

/// sn, cn and dn by the arithmetic–geometric mean (Abramowitz and Stegun 16.4).
Elliptic jacobi(double u, double parameter) {
    std::array<double, 40> means{1}, halves{std::sqrt(parameter)};
    double other = std::sqrt(1 - parameter);
    std::size_t n = 0;
    while (halves[n] > 1e-17 && n + 1 < means.size()) {
        means[n + 1] = 0.5 * (means[n] + other);
        halves[n + 1] = 0.5 * (means[n] - other);
        other = std::sqrt(means[n] * other);
        ++n;
    }
    double phase = std::ldexp(means[n] * u, static_cast<int>(n));
    for (; n > 0; --n) {
        phase = 0.5 * (phase + std::asin(halves[n] / means[n] * std::sin(phase)));
    }
    const double sine = std::sin(phase);
    return {sine, std::cos(phase), std::sqrt(1 - parameter * sine * sine)};
}

/// ω in the top's axes as amplitudes times cn, sn and dn, for I₁ < I₂ < I₃ and L² > 2 E I₂: the top turns
/// about its third axis (Landau and Lifshitz, Mechanics, § 37). Time counts from where ω₂ is zero.
struct Motion {
    Vec3 amplitudes = Vec3::Zero();
    double rate = 0;
    double parameter = 0;
    double start = 0;  ///< [s], on its own clock

    [[nodiscard]] Vec3 spin(double time) const {
        const Elliptic at = jacobi(rate * (start + time), parameter);
        return amplitudes.cwiseProduct(Vec3(at.cn, at.sn, at.dn));
    }
};

Motion motion_of_top() {
    const Vec3 i = moments();
    const double twice_energy = i.dot(first_spin.cwiseAbs2());
    const double square = first_momentum().squaredNorm();
    Motion motion;
    const double upper = twice_energy * i[2] - square;
    const double lower = square - twice_energy * i[0];
    motion.amplitudes = {std::sqrt(upper / (i[0] * (i[2] - i[0]))), std::sqrt(upper / (i[1] * (i[2] - i[1]))),
                         std::sqrt(lower / (i[2] * (i[2] - i[0])))};
    motion.rate = std::sqrt((i[2] - i[1]) * lower / (i[0] * i[1] * i[2]));
    motion.parameter = (i[1] - i[0]) * upper / ((i[2] - i[1]) * lower);
    // F(φ|m) where sn and cn are those of the first spin, by Newton's method on sn.
    double u = 0;
    const double sine = first_spin[1] / motion.amplitudes[1];
    for (int n = 0; n < 100; ++n) {
        const Elliptic at = jacobi(u, motion.parameter);
        u -= (at.sn - sine) / (at.cn * at.dn);
    }
    motion.start = u / motion.rate;
    return motion;
}

/// Angle [rad] by which the top has turned about its angular momentum: the integral of
/// L (I₁ω₁² + I₂ω₂²)/(I₁²ω₁² + I₂²ω₂²), by Gauss's rule of five points.
double precession(const Motion& motion, double time) {
    constexpr double points[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                 0.9061798459386640};
    constexpr double weights[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                  0.4786286704993665, 0.2369268850561891};
    const int parts = 40 + static_cast<int>(40 * time);
    const double half = time / (2 * parts);
    double sum = 0;
    for (int part = 0; part < parts; ++part) {
        for (std::size_t p = 0; p < 5; ++p) {
            const Vec3 spin = motion.spin(half * (2 * part + 1 + points[p]));
            const Vec3 momentum = moments().cwiseProduct(spin);
            const double across = spin[0] * momentum[0] + spin[1] * momentum[1];
            sum += weights[p] * across / (momentum[0] * momentum[0] + momentum[1] * momentum[1]);
        }
    }
    return first_momentum().norm() * half * sum;
}

/// The turn from a frame whose z axis is the angular momentum to the top's axes, the angle about it apart.
Quat lean(const Vec3& momentum) {
    const Vec3 along = momentum.normalized();
    const Vec3 node = Vec3::UnitZ().cross(along).normalized();
    Mat3 axes;  // of the frame, as the top sees them
    axes << node, along.cross(node), along;
    return Quat(Mat3(axes.transpose()));
}

Quat orientation_at(double time) {
    const Motion motion = motion_of_top();
    const Vec3 momentum = moments().cwiseProduct(motion.spin(time));
    const Quat about(Eigen::AngleAxisd(precession(motion, time), Vec3::UnitZ()));
    return lean(first_momentum()).conjugate() * about * lean(momentum);
}

Values axes_of(const Quat& turn) {
    const Mat3 axes = turn.toRotationMatrix();
    return {axes.data(), axes.data() + axes.size()};
}

Values exact(double time) {
    Values values = axes_of(orientation_at(time));
    values.insert(values.end(), {1, 0});
    return values;
}

Values observe(const Simulation& simulation) {
    const FrameMotion now = simulation.body_motion(0);
    const Vec3 spin = now.pose.orientation.conjugate() * now.angular_velocity;
    const Vec3 momentum = now.pose.orientation * moments().cwiseProduct(spin);
    Values values = axes_of(now.pose.orientation);
    values.push_back(moments().dot(spin.cwiseAbs2()) / moments().dot(first_spin.cwiseAbs2()));
    values.push_back((momentum - first_momentum()).norm() / first_momentum().norm());
    return values;
}

}  // namespace

Problem free_top_problem(bool quick) {
    Problem problem = bare_problem("free_top", quick ? 10 : 100, 10);
    problem.purpose =
        "A free plate whose moments are nearly as 1 : 2 : 3 tumbles at 2.4 rad/s; Jacobi's elliptic "
        "functions say where it looks. The error is the largest difference in the components of its axes, in "
        "energy, or in angular momentum, over their first values.";
    SceneDescription& scene = problem.scene;
    scene.gravity.setZero();
    scene.shapes["plate"] = BoxShape{edges};
    add_body(scene, "plate", Vec3::Zero()).angular_velocity = first_spin;
    problem.quantities = {"axis 1 x", "axis 1 y", "axis 1 z", "axis 2 x", "axis 2 y",        "axis 2 z",
                          "axis 3 x", "axis 3 y", "axis 3 z", "energy",   "angular momentum"};
    problem.observe = observe;
    problem.rigid = exact;
    problem.model = exact;
    problem.free_flight = true;
    return problem;
}

}  // namespace scree
