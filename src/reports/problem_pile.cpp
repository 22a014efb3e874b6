// Stones fall into a box and settle. Where each of them ends is chance; what the pile is like is not.

#include <cmath>

#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

constexpr double size = 0.05;   // [m], of a stone
constexpr double width = 0.07;  // [m], from the middle of the box to a wall

void add_wall(SceneDescription& scene, const Vec3& inward) {
    const std::string name = "wall " + std::to_string(scene.shapes.size());
    scene.shapes[name] = HalfSpace{inward, -width};
    add_fixed(scene, name, {});
}

/// Eight stones of a mesh, at random places in the box.
void add_stones(SceneDescription& scene, const std::string& mesh) {
    scene.shapes[mesh] = shipped_mesh(mesh, size);
    FillDescription fill;
    fill.shape = mesh;
    fill.material = "rock";
    fill.count = 8;
    fill.low = Vec3(-width, -width, 0);
    fill.high = Vec3(width, width, 0.2);
    fill.seed = scene.fill.size() + 1;
    scene.fill.push_back(fill);
}

/// The mean of n nᵀ over the contacts, and their number.
struct Fabric {
    Mat3 tensor = Mat3::Zero();
    double contacts = 0;
};

Fabric fabric_of(const Simulation& simulation) {
    Fabric fabric;
    for (const ContactResult& contact : simulation.contact_results()) {
        if (contact.touching && contact.law.state != ContactState::open) {
            fabric.tensor += contact.normal * contact.normal.transpose();
            ++fabric.contacts;
        }
    }
    fabric.tensor /= std::max(1.0, fabric.contacts);
    return fabric;
}

Values observe(const Simulation& simulation) {
    Vec3 middle = Vec3::Zero();
    double weight = 0;
    double stones = 0;
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        if (simulation.bodies()[i].dynamic()) {
            middle += simulation.body_motion(i).pose.position;
            weight += 2600 * simulation.bodies()[i].solid.volume * earth_gravity;
            ++stones;
        }
    }
    middle /= stones * size;
    const Fabric fabric = fabric_of(simulation);
    const EnergyLedger& energy = simulation.report().energy;
    return {middle.x(),
            middle.y(),
            middle.z(),
            (energy.kinetic + energy.gravity) / (weight * size),
            2 * fabric.contacts / stones / 10,
            fabric.tensor(0, 0),
            fabric.tensor(1, 1),
            fabric.tensor(2, 2)};
}

}  // namespace

Problem pile_problem(bool quick) {
    Problem problem = bare_problem("pile", 0.6, 12);
    problem.purpose =
        "Sixteen mesh stones of 5 cm fall into a box and settle for 0.6 s. Paths are chaotic, so the whole "
        "is compared: mean position, in sizes of a stone, energy over weight and size, contacts a stone over "
        "ten, and the fabric, the mean of n nᵀ. The error is the largest difference from the mean of several "
        "fine runs; these differ among themselves by as much as is said below, and less than that means "
        "nothing.";
    SceneDescription& scene = problem.scene;
    scene.materials["rock"].youngs_modulus = 1e7;
    add_floor(scene);
    for (const Vec3& inward :
         {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitY())}) {
        add_wall(scene, inward);
    }
    add_stones(scene, "stone_a");
    add_stones(scene, "stone_b");
    problem.quantities = {"mean x",           "mean y",    "mean z",    "energy",
                          "contacts a stone", "fabric xx", "fabric yy", "fabric zz"};
    problem.observe = observe;
    problem.last_only = problem.chaotic = true;
    problem.references = {adaptive_bdf(2, 1e-3), adaptive_bdf(2, 9e-4),
                          explicit_method(SteppingMethod::verlet, 2e-5)};
    if (!quick) {
        problem.references = {adaptive_bdf(2, 1e-4), adaptive_bdf(2, 2e-4), adaptive_bdf(1, 3e-4),
                              explicit_method(SteppingMethod::verlet, 5e-6),
                              explicit_method(SteppingMethod::verlet, 4e-6)};
    }
    return problem;
}

}  // namespace scree
