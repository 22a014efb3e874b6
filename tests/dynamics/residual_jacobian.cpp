#include <optional>

#include <catch2/catch.hpp>

#include <scree/overlap/frozen_points.hpp>

#include <tests/dynamics/residual_error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double h = 1e-3;
constexpr double radius = 0.1;
constexpr double depth = 2e-3;
// Central differences give some 10⁻¹⁰ of a smooth function; sides of a hundredth of the size limit the step.
constexpr double differences = 1e-8;

// Pairs of shapes: where the first is, so that it overlaps the second, at the origin, by about the depth.
struct Meeting {
    Shape a, b;
    Vec3 apart;
};

Meeting random_meeting(Random& random, const std::string& kind) {
    const Vec3 way = random.direction();
    if (kind == "polyhedron, half-space") {
        const ConvexPolyhedron stone = random.polyhedron(12, radius);
        double lowest = 0;
        for (const Vec3& v : stone.vertices) {
            lowest = std::min(lowest, v.dot(way));
        }
        return {stone, HalfSpace{way, 0}, -(lowest + depth) * way};
    }
    if (kind == "sphere, half-space") {
        return {Sphere{radius}, HalfSpace{way, 0}, (radius - depth) * way};
    }
    if (kind == "cylinder, half-space" || kind == "capsule, half-space") {
        const Shape rod = kind[1] == 'y' ? Shape(make_frustum(radius, 0.8 * radius, 1.2 * radius))
                                         : Shape(make_capsule(0.8 * radius, 0.7 * radius));
        return {rod, HalfSpace{way, 0}, (reach_along(rod, -way) - depth) * way};
    }
    if (kind == "cylinder, polyhedron") {
        const Vec3 across = Vec3(way.x(), way.y(), 0).normalized();
        const Pose box{Vec3::Zero(), Quat::FromTwoVectors(Vec3::UnitZ(), across)};
        return {make_frustum(radius, radius, 0.9 * radius), transformed(make_box({0.3, 0.3, 0.2}), box),
                (0.1 + radius - depth) * across};
    }
    if (kind == "sphere, sphere") {
        return {Sphere{radius}, Sphere{0.7 * radius}, (1.7 * radius - depth) * way};
    }
    if (kind == "sphere, polyhedron") {
        return {Sphere{radius}, make_box({0.2, 0.2, 0.2}), {0.03, 0.02, 0.1 + radius - depth}};
    }
    return {random.polyhedron(12, radius), random.polyhedron(14, radius), 1.3 * radius * way};
}

// What the second body is.
enum class Second { free, prescribed, conveyor };

// Some points of the first body, deep under planes of the second that lie nearly alike.
std::shared_ptr<const PairGeometry> random_points(Random& random, const Pose& pose_a, const Pose& pose_b) {
    std::vector<FrozenPoint> points;
    const Vec3 up = random.direction();
    for (int i = 0; i < 3; ++i) {
        const Vec3 at = pose_a.position - 0.8 * radius * up + 0.3 * radius * random.vector();
        const Vec3 normal = (up + 0.1 * random.vector()).normalized();
        points.push_back({pose_a.inverse() * at, pose_b.inverse() * (at + 2 * depth * normal),
                          pose_b.orientation.conjugate() * normal});
    }
    auto geometry = std::make_shared<FrozenPoints>();
    geometry->freeze(points, depth * depth);
    return geometry;
}

// One contact of that kind with random velocities and a random past; empty when it has no force.
std::optional<StepCase> random_step(Random& random, const std::string& kind, double friction, Second second,
                                    const PairMaterial& more) {
    const Meeting meeting = random_meeting(random, kind);
    const double speed = 0.2 * depth / h;
    StepCase step;
    step.material.rolling_friction = more.rolling_friction;
    step.material.cohesion = more.cohesion;
    step.material.friction = friction;
    const Pose pose_a{meeting.apart, Quat::Identity()};
    const Pose frame{random.vector(), random.rotation()};
    step.add_body(meeting.a, frame * pose_a, speed * random.vector(), 10 * speed * random.vector());
    if (second == Second::conveyor) {
        step.add_on_path(meeting.b, {frame, 0.2 * random.vector(), random.vector(), speed * random.vector()});
    } else if (second == Second::prescribed || std::holds_alternative<HalfSpace>(meeting.b)) {
        step.add_prescribed(meeting.b, frame, 0.2 * random.vector(), random.vector());
    } else {
        step.add_body(meeting.b, frame, speed * random.vector(), 10 * speed * random.vector());
    }
    // The bodies came from somewhere else than where they are now straight on.
    for (std::size_t b = 0; b < 2; ++b) {
        step.before[b].position -= 0.1 * depth * random.vector();
        step.before[b].orientation = rotation(0.02 * random.vector()) * step.before[b].orientation;
    }
    Contact& contact = step.add_contact(0, 1);
    contact.pair.cohesion *= contact.pair.elastic * std::pow(depth, 3);
    if (kind == "frozen points") {
        const auto pose = [&](std::size_t b) -> Pose {
            return {step.system.states[b].position, step.system.states[b].orientation};
        };
        contact.geometry = random_points(random, pose(0), pose(1));
    }
    const double force = contact.pair.elastic * std::pow(depth, 3) * friction;
    const double length = contact.pair.length;
    const double stiffness = contact.pair.tangential_stiffness / (length * length) * depth * radius;
    for (int j = 0; j < 2; ++j) {
        const Vec3 normal = random.direction();
        FrictionRecord record{force * random.vector(), normal, random.uniform(0.2, 2) * stiffness};
        record.rolling = force * normal.cross(random.vector());
        contact.history.push(record);
    }
    ForcesOf<WholeDerivativeLaw<>> forces({});
    StepProblem problem(step.system, forces);
    step.begin(problem, h);
    const ContactResult& result = problem.results()[0];
    if (result.law.state == ContactState::open || result.volume < 1e-3 * std::pow(depth, 3) ||
        result.centre_line) {
        return std::nullopt;
    }
    return step;
}

struct Seen {
    int stick = 0;
    int slip = 0;
    double worst = 0;
};

template <LawParts parts = LawParts{}>
Seen check(const std::string& kind, double friction, Second second, const LawOptions& options,
           std::size_t order, const PairMaterial& more = {}) {
    Random random(201 + order);
    Seen seen;
    for (int i = 0; i < 120; ++i) {
        const auto step = random_step(random, kind, friction, second, more);
        if (!step) {
            continue;
        }
        ForcesOf<WholeDerivativeLaw<parts>> forces({{options}, 0.3 * radius});
        const ResidualError found = residual_error(*step, forces, h, order, depth, radius);
        seen.worst = std::max(seen.worst, found.error);
        seen.stick += found.state == ContactState::stick;
        seen.slip += found.state == ContactState::slip;
    }
    return seen;
}

const std::string kinds[] = {"polyhedron, half-space", "polyhedron, polyhedron", "sphere, half-space",
                             "sphere, sphere",         "sphere, polyhedron",     "cylinder, half-space",
                             "capsule, half-space",    "cylinder, polyhedron",   "frozen points"};

}  // namespace

TEST_CASE("The residual's Jacobian agrees with differences without friction", "[dynamics]") {
    for (const std::string& kind : kinds) {
        INFO(kind);
        const Seen seen = check(kind, 0, Second::free, {}, 1);
        CHECK(seen.slip > 20);
        CHECK(seen.worst < differences);
    }
}

TEST_CASE("The residual's Jacobian agrees with differences in stick and in slip, at first and second order",
          "[dynamics]") {
    for (const std::string& kind : kinds) {
        for (const std::size_t order : {1, 2}) {
            INFO(kind << ", order " << order);
            const Seen sticking = check(kind, 1e6, Second::free, {}, order);
            CHECK(sticking.stick > 20);
            CHECK(sticking.worst < differences);
            const Seen slipping = check(kind, 0.3, Second::free, {}, order);
            CHECK(slipping.slip > 20);
            CHECK(slipping.worst < differences);
        }
    }
}

TEST_CASE("The residual's Jacobian agrees with differences against a body that moves and turns as prescribed",
          "[dynamics]") {
    const Second second = GENERATE(Second::prescribed, Second::conveyor);
    for (const std::string& kind : kinds) {
        for (const double friction : {0.3, 1e6}) {
            INFO(kind << ", μ = " << friction << (second == Second::conveyor ? ", conveyor" : ""));
            const Seen seen = check(kind, friction, second, {}, 2);
            CHECK(seen.stick + seen.slip > 20);
            CHECK(seen.worst < differences);
        }
    }
}

TEST_CASE(
    "The residual's Jacobian agrees with differences in the literal scheme, without the pair's rotation",
    "[dynamics]") {
    const Seen seen = check("polyhedron, polyhedron", 1e6, Second::free, {.co_rotation = false}, 2);
    CHECK(seen.stick > 20);
    CHECK(seen.worst < differences);
}

TEST_CASE("The residual's Jacobian agrees with differences for springs of the patch and exact masses",
          "[dynamics]") {
    const LawOptions options{.tangential_stiffness = TangentialStiffness::patch,
                             .reduced_mass = ReducedMass::exact};
    for (const std::string& kind : kinds) {
        for (const double friction : {1e-3, 1e6}) {  // the springs are soft
            INFO(kind << ", μ = " << friction);
            const Seen seen = check(kind, friction, Second::free, options, 2);
            CHECK((friction < 1 ? seen.slip : seen.stick) > 10);
            CHECK(seen.worst < differences);
        }
    }
}

TEST_CASE("The residual's Jacobian agrees with differences for viscous and for two-dimensional friction",
          "[dynamics]") {
    const LawOptions options{.reduced_mass = ReducedMass::exact};
    for (const std::string& kind : kinds) {
        for (const double friction : {0.3, 1e6}) {
            INFO(kind << ", μ = " << friction);
            const Seen viscous =
                check<LawParts{FrictionLaw::viscous}>(kind, friction, Second::free, options, 2);
            const Seen plane =
                check<LawParts{FrictionLaw::cundall_strack_2d}>(kind, friction, Second::free, options, 2);
            CHECK(viscous.stick + viscous.slip > 20);
            CHECK(plane.stick + plane.slip > 20);
            CHECK(viscous.worst < differences);
            CHECK(plane.worst < 10 * differences);  // a normal near y turns its tangent fast
        }
    }
}

TEST_CASE("The residual's Jacobian agrees with differences for rolling resistance and cohesion",
          "[dynamics]") {
    PairMaterial more;
    more.cohesion = 0.5;  // of the force that presses a cube of the depth
    for (const std::string& kind : kinds) {
        for (const double friction : {0.3, 1e6}) {
            more.rolling_friction = friction;
            INFO(kind << ", μ = μ_r = " << friction);
            const Seen seen = check<LawParts{.rolling = true}>(kind, friction, Second::free, {}, 2, more);
            CHECK(seen.stick + seen.slip > 20);
            CHECK(seen.worst < differences);
        }
    }
}

TEST_CASE("The residual's Jacobian agrees with differences for the force of a potential", "[dynamics]") {
    const LawOptions options{.elasticity = Elasticity::potential};
    for (const std::string kind :
         {"polyhedron, polyhedron", "polyhedron, half-space", "sphere, polyhedron"}) {
        for (const double friction : {0.0, 0.3, 1e6}) {
            INFO(kind << ", μ = " << friction);
            const Seen seen = check(kind, friction, Second::free, options, 2);
            CHECK(seen.stick + seen.slip > 20);
            CHECK(seen.worst <
                  10 * differences);  // third differences of cells that are smaller than the overlap
        }
    }
}
