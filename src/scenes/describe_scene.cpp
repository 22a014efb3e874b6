#include <scree/scenes/describe_scene.hpp>

#include <scree/scenes/features.hpp>

#include "materials.hpp"
#include "option_words.hpp"
#include "text_lines.hpp"

namespace scree {

namespace {

void add_constants(const SceneDescription& scene, const PairMaterial& pair, Line& line) {
    if (scene.stepping.method == SteppingMethod::bullet) {
        line << "friction " << pair.friction << ", restitution " << pair_restitution(pair);
        return;
    }
    line << "Y " << pair.youngs_modulus << " Pa, friction " << pair.friction << ", damping "
         << pair.normal_damping << " normal, " << pair.tangential_damping << " tangential, Yt/Y "
         << pair.tangential_ratio << ", torsion "
         << (!pair.torsion         ? "off"
             : pair.patch_friction ? "on patch cells"
                                   : "on");
    if (pair.kinetic_friction) {
        line << ", kinetic friction " << *pair.kinetic_friction;
    }
    if (pair.rolling_friction > 0) {
        line << ", rolling friction " << pair.rolling_friction;
    }
    if (pair.cohesion > 0) {
        line << ", cohesion " << pair.cohesion << " N";
    }
}

void add_materials(const SceneDescription& scene, Lines& lines) {
    for (const auto& [name, material] : scene.materials) {
        Line line(lines);
        line << "material: " << name << ", " << material.density << " kg/m³; on itself ";
        add_constants(scene, pair_material(scene, name, name), line);
    }
    for (const PairDescription& entry : scene.pairs) {
        const auto& [a, b] = entry.materials;
        Line line(lines);
        line << "pair: " << a << " on " << b << ", ";
        add_constants(scene, pair_material(scene, a, b), line);
    }
}

void add_law(const SceneDescription& scene, Lines& lines) {
    if (scene.stepping.method == SteppingMethod::bullet) {
        lines.emplace_back("law: none of scree's, impulses of Bullet's own solver");
        return;
    }
    const LawDescription& law = scene.law;
    Line(lines) << "law: normal " << word_of(normal_laws, law.normal) << ", friction "
                << word_of(friction_laws, law.friction) << ", damping "
                << word_of(damping_places, law.damping) << ", normal damping by "
                << word_of(normal_dampings, law.normal_damping) << ", tangential stiffness "
                << word_of(tangential_stiffnesses, law.tangential_stiffness) << ", co-rotation "
                << (law.co_rotation ? "on" : "off") << ", reduced mass "
                << word_of(reduced_masses, law.reduced_mass);
}

void add_stepping(const SceneDescription& scene, Lines& lines) {
    const SteppingDescription& stepping = scene.stepping;
    Line line(lines);
    line << "stepping: " << word_of(stepping_methods, stepping.method);
    if (stepping.step) {
        line << ", step " << *stepping.step << " s";
    } else {
        line << ", adaptive step";
    }
    if (stepping.method == SteppingMethod::bullet) {
        line << " at most, " << stepping.iterations << " iterations, "
             << (stepping.separating_axis ? "separating axes" : "GJK") << ", friction directions "
             << stepping.friction_directions;
    }
    if (stepping.method == SteppingMethod::bdf) {
        line << ", orders 1 to " << stepping.max_order << ", rtol " << stepping.rtol << ", atol "
             << stepping.atol << ", solver " << word_of(solver_choices, stepping.solver)
             << (stepping.sleep ? ", groups at rest sleep" : "");
    }
}

void add_output(const OutputDescription& output, Lines& lines) {
    const std::pair<const char*, bool> files[] = {{" bodies.csv", output.bodies},
                                                  {" energy.csv", output.energy},
                                                  {" contacts.csv", output.contacts},
                                                  {" replay.glb", output.replay}};
    Line line(lines);
    line << "output: summary.json";
    for (const auto& [name, wanted] : files) {
        line << (wanted ? name : "");
    }
    if (output.checkpoint_every > 0) {
        line << ", a checkpoint every " << output.checkpoint_every << " s";
    }
}

void add_words(const char* title, const std::vector<std::string>& words, Lines& lines) {
    Line line(lines);
    line << title << ":";
    for (const std::string& word : words) {
        line << " " << word;
    }
}

}  // namespace

std::vector<std::string> describe_scene(const Simulation& simulation) {
    const SceneDescription& scene = simulation.scene();
    Lines lines;
    Line(lines) << scene.name << ": " << simulation.bodies().size() << " bodies for " << scene.end_time
                << " s, an output every " << scene.output.every << " s";
    Line(lines) << "gravity: " << scene.gravity << " m/s²";
    add_bodies(simulation, lines);
    add_motions(simulation, lines);
    add_shapes(simulation, lines);
    add_materials(scene, lines);
    add_law(scene, lines);
    add_stepping(scene, lines);
    add_output(scene.output, lines);
    const Features features = scene_features(scene);
    add_words("used", features.used, lines);
    add_words("left out", features.left_out, lines);
    for (const std::string& note : simulation.notes()) {
        Line(lines) << "note: " << note;
    }
    return lines;
}

}  // namespace scree
