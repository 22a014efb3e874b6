// Newton's cradle, and a block that floats: contacts that only store energy.

#include <cmath>

#include <scree/mesh/mass_properties.hpp>

#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

constexpr int balls = 5;
constexpr double radius = 0.05;  // [m]
constexpr double speed = 1;      // [m/s]

Values velocities(const Simulation& simulation) {
    Values values;
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        values.push_back(simulation.file_motion(i).velocity.x() / speed);
    }
    return values;
}

const Vec3 block_edges(0.2, 0.15, 0.1);  // [m]
constexpr double block_density = 500;    // [kg/m³]

Values attitude(const Simulation& simulation) {
    const FrameMotion now = simulation.file_motion(1);
    const Vec3 up = now.pose.orientation.conjugate() * Vec3::UnitZ();
    return {now.pose.position.z() / block_edges.z(), up.x(), up.y()};
}

}  // namespace

Problem cradle_problem() {
    Problem problem = bare_problem("cradle", 0.02, 2);
    problem.purpose =
        "Four balls in a row that touch, and a fifth that hits them at 1 m/s; nothing is damped. Of rigid "
        "balls that hit one after the other the last leaves with all of the speed; the law has them in touch "
        "all at once, so that some of it stays behind. The error is the largest difference in velocity, over "
        "that of the fifth.";
    SceneDescription& scene = problem.scene;
    scene.gravity.setZero();
    MaterialDescription& rock = scene.materials["rock"];
    rock.friction = rock.normal_damping = rock.tangential_damping = 0;
    rock.youngs_modulus = 1e9;
    scene.shapes["ball"] = Sphere{radius};
    for (int i = 0; i < balls; ++i) {
        add_body(scene, "ball", Vec3(2 * radius * i, 0, 0));
    }
    problem.quantities = {"ball 1", "ball 2", "ball 3", "ball 4", "ball 5"};
    scene.bodies[0].position.x() -= 0.005;
    scene.bodies[0].velocity.x() = speed;
    problem.observe = velocities;
    problem.rigid = [](double) { return Values{0, 0, 0, 0, 1}; };
    problem.last_only = true;
    problem.references = {adaptive_bdf(2, 1e-9), explicit_method(SteppingMethod::verlet, 1e-7)};
    return problem;
}

Problem floating_block_problem() {
    Problem problem = bare_problem("floating_block", 2, 8);
    problem.purpose =
        "A block floats, tilted, to half its height in a half-space as soft as water, and heaves and rolls "
        "without damping for two seconds. The error is the largest difference in height, in heights of the "
        "block, or in the vertical as the block sees it.";
    SceneDescription& scene = problem.scene;
    MaterialDescription& rock = scene.materials["rock"];
    rock.density = block_density;
    rock.friction = rock.normal_damping = rock.tangential_damping = 0;
    // (Y/Lc) V/2 bears the block's weight.
    rock.youngs_modulus = 2 * block_density * earth_gravity * 2 * sphere_radius(block_edges.prod());
    scene.shapes["block"] = BoxShape{block_edges};
    add_floor(scene);
    add_body(scene, "block", Vec3(0, 0, 0.01)).orientation =
        Quat(Eigen::AngleAxisd(0.15, Vec3(1, 2, 0).normalized()));
    problem.quantities = {"height", "tilt x", "tilt y"};
    problem.observe = attitude;
    problem.no_bullet = true;
    problem.references = {adaptive_bdf(5, 1e-10), explicit_method(SteppingMethod::verlet, 1e-5)};
    return problem;
}

}  // namespace scree
