#include <scree/scenes/incline.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <scree/scenes/simulation.hpp>

namespace scree {

namespace {

constexpr double gravity = 9.81;
constexpr double bracket = 0.02;  // [rad], each side of where the rigid block begins to slide
constexpr double output_every = 0.02;

// The face to lie on: the one that tips last. `ratio` is the tangent of the tipping slope.
struct Base {
    Vec3 normal;
    double height = 0;  // of the mass centre above it [m]
    double ratio = -std::numeric_limits<double>::infinity();
};

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// How far the mass centre, the origin, lies inside the nearest edge of a face, seen along its normal.
double inside_by(const ConvexPolyhedron& solid, int face) {
    double least = std::numeric_limits<double>::infinity();
    const int begin = solid.face_begin[at(face)];
    const int end = solid.face_begin[at(face) + 1];
    for (int e = begin; e < end; ++e) {
        const Vec3& from = solid.vertices[at(solid.half_edges[at(e)].vertex)];
        const Vec3& to = solid.vertices[at(solid.half_edges[at(e + 1 < end ? e + 1 : begin)].vertex)];
        const Vec3 inward = solid.planes[at(face)].normal.cross(to - from).normalized();
        least = std::min(least, -inward.dot(from));
    }
    return least;
}

Base broadest_base(const ConvexPolyhedron& solid) {
    Base best;
    for (int f = 0; f < solid.face_count(); ++f) {
        const Plane& plane = solid.planes[at(f)];
        const double ratio = inside_by(solid, f) / plane.offset;
        if (ratio > best.ratio) {
            best = {plane.normal, plane.offset, ratio};
        }
    }
    return best;
}

const ConvexPolyhedron& polyhedron(const Solid& solid) {
    return std::get<ConvexPolyhedron>(*solid.shape);
}

MeshShape mesh_shape(const std::filesystem::path& file, double scale) {
    MeshShape mesh;
    mesh.file = file;
    mesh.scale = Vec3::Constant(scale);
    return mesh;
}

Solid block_of(const Incline& incline) {
    return make_solid(mesh_shape(std::filesystem::absolute(incline.mesh), incline.scale), {});
}

// The block's file frame on the plane z = 0.
Pose lying(const Incline& incline, const Solid& block) {
    const Base base = broadest_base(polyhedron(block));
    const Quat turned(Eigen::AngleAxisd(incline.turn, Vec3::UnitZ()));
    const Pose body{Vec3(0, 0, base.height), turned * Quat::FromTwoVectors(base.normal, -Vec3::UnitZ())};
    return body * block.body_in_file.inverse();
}

// From the frame of the slope, whose x runs downhill before the azimuth is counted, to the world.
Quat slope_turn(const Incline& incline, double slope) {
    if (!incline.turn_ground) {
        return Quat::Identity();
    }
    const Vec3 level(-std::sin(incline.azimuth), std::cos(incline.azimuth), 0);
    return Quat(Eigen::AngleAxisd(slope, level));
}

Vec3 downhill(const Incline& incline) {
    return {std::cos(incline.azimuth), std::sin(incline.azimuth), 0};
}

double ground_top(const Incline& incline) {
    const Solid ground =
        make_solid(mesh_shape(std::filesystem::absolute(incline.ground), incline.ground_scale), {});
    return bounds(*ground.shape, ground.body_in_file).high.z();
}

BodyDescription body(const std::string& name, const Pose& pose, MotionDescription motion) {
    BodyDescription description;
    description.name = description.shape = name;
    description.material = "rock";
    description.position = pose.position;
    description.orientation = pose.orientation;
    description.motion = std::move(motion);
    return description;
}

// Runs to the end and keeps how the block moved half-way, and how far it got from where it had settled.
void slide(Simulation& simulation, InclineRun& run, FrameMotion& half, double& half_time) {
    const std::int64_t ticks = simulation.times().last();
    FrameMotion settled = half;
    run.finished = true;
    for (std::int64_t tick = 1; tick <= ticks && run.finished; ++tick) {
        run.finished = simulation.advance();
        const FrameMotion now = simulation.body_motion(1);
        if (tick == ticks / 5) {
            settled = now;
        }
        if (tick > ticks / 5) {
            run.creep = std::max(run.creep, (now.pose.position - settled.pose.position).norm());
        }
        if (tick == ticks / 2) {
            half = now;
            half_time = simulation.time();
        }
    }
}

}  // namespace

double sliding_angle(const Incline& incline) {
    return std::atan(incline.friction);
}

double sliding_acceleration(const Incline& incline, double slope) {
    return gravity * (std::sin(slope) - incline.friction * std::cos(slope));
}

double tipping_angle(const Incline& incline) {
    return std::atan(broadest_base(polyhedron(block_of(incline))).ratio);
}

SceneDescription incline_scene(const Incline& incline, double slope, double duration) {
    SceneDescription scene;
    scene.name = "incline";
    scene.gravity = -gravity * Vec3::UnitZ();
    if (!incline.turn_ground) {
        scene.gravity = gravity * (std::sin(slope) * downhill(incline) - std::cos(slope) * Vec3::UnitZ());
    }
    MaterialDescription rock;
    rock.density = 2600;
    rock.youngs_modulus = incline.youngs_modulus;
    rock.friction = incline.friction;
    scene.materials["rock"] = rock;
    scene.shapes["block"] = mesh_shape(std::filesystem::absolute(incline.mesh), incline.scale);
    const Pose turn{Vec3::Zero(), slope_turn(incline, slope)};
    Pose ground = turn;
    if (incline.ground.empty()) {
        scene.shapes["slope"] = HalfSpace{Vec3::UnitZ(), 0};
    } else {
        scene.shapes["slope"] = mesh_shape(std::filesystem::absolute(incline.ground), incline.ground_scale);
        ground = turn * Pose{Vec3(0, 0, -ground_top(incline)), Quat::Identity()};
    }
    scene.bodies = {body("slope", ground, FixedMotion{}),
                    body("block", turn * lying(incline, block_of(incline)), DynamicMotion{})};
    scene.stepping.rtol = incline.relative_tolerance;
    scene.end_time = duration;
    scene.output.every = output_every;
    return scene;
}

InclineRun run_incline(const Incline& incline, double slope, double duration) {
    Simulation simulation(incline_scene(incline, slope, duration));
    const Quat back = slope_turn(incline, slope).conjugate();
    const FrameMotion start = simulation.body_motion(1);
    InclineRun run;
    FrameMotion half = start;
    double half_time = 0;
    const auto clock = std::chrono::steady_clock::now();
    slide(simulation, run, half, half_time);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
    const FrameMotion end = simulation.body_motion(1);
    const Vec3 along = downhill(incline);
    const Vec3 moved = back * (end.pose.position - start.pose.position);
    run.acceleration = along.dot(back * (end.velocity - half.velocity)) / (simulation.time() - half_time);
    run.slide = along.dot(moved);
    run.drift = Vec3::UnitZ().cross(along).dot(moved);
    run.turn = end.pose.orientation.angularDistance(start.pose.orientation);
    const StepReport& report = simulation.report();
    run.message = report.message;
    run.steps = report.steps.accepted;
    run.newton_iterations = report.steps.newton.iterations;
    return run;
}

MeasuredAngle measure_sliding_angle(const Incline& incline, double tolerance) {
    MeasuredAngle measured;
    double low = std::max(0.0, sliding_angle(incline) - bracket);
    double high = sliding_angle(incline) + 1.1 * bracket;  // not symmetric: the answer is not the first guess
    while (high - low > tolerance) {
        const double middle = 0.5 * (low + high);
        const InclineRun run = run_incline(incline, middle, 1);
        // One part in 10⁹ of gravity is far above rounding and far below what the tolerance can tell apart.
        (run.acceleration > 1e-9 * gravity ? high : low) = middle;
        measured.seconds += run.seconds;
        measured.steps += run.steps;
        measured.newton_iterations += run.newton_iterations;
        ++measured.runs;
    }
    measured.angle = 0.5 * (low + high);
    return measured;
}

}  // namespace scree
