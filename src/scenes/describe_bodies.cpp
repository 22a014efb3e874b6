#include <algorithm>
#include <limits>
#include <utility>

#include "text_lines.hpp"

namespace scree {

namespace {

std::string motion_text(const PrescribedMotion& motion) {
    std::ostringstream out;
    if (motion.vibrates()) {
        out << " vibrates by " << motion.amplitude << " m at " << motion.frequency << " Hz along "
            << text(motion.velocity);
    } else if (motion.velocity != Vec3::Zero()) {
        out << " moves by " << text(motion.velocity) << " m/s";
    }
    if (motion.angular_velocity != Vec3::Zero()) {
        out << " turns by " << text(motion.angular_velocity) << " rad/s about " << text(motion.about) << " m";
    }
    if (motion.surface_velocity != Vec3::Zero()) {
        out << " conveys by " << text(motion.surface_velocity) << " m/s";
    }
    return out.str().empty() ? " stays where it is" : out.str();
}

/// Describes each kind of shape.
struct ShapeText {
    const Solid& solid;

    std::string operator()(const MeshShape& mesh) const {
        const auto& hull = std::get<ConvexPolyhedron>(*solid.shape);
        std::ostringstream out;
        out << "mesh " << mesh.file.string() << " times ";
        if (mesh.scale == Vec3::Constant(mesh.scale.x())) {
            out << mesh.scale.x();
        } else {
            out << text(mesh.scale);
        }
        out << ", " << hull.vertices.size() << " vertices, " << hull.face_count() << " faces, "
            << solid.volume << " m³";
        return out.str();
    }
    std::string operator()(const BoxShape& box) const { return "box " + text(box.edges) + " m"; }
    std::string operator()(const Sphere& sphere) const {
        std::ostringstream out;
        out << "sphere, radius " << sphere.radius << " m";
        return out.str();
    }
    std::string operator()(const HalfSpace& half_space) const {
        std::ostringstream out;
        out << "half-space, solid where " << text(half_space.normal) << " · x < " << half_space.offset
            << " m";
        return out.str();
    }
};

}  // namespace

void add_bodies(const Simulation& simulation, Lines& lines) {
    const std::vector<SimulationBody>& bodies = simulation.bodies();
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    double sum = 0;
    std::size_t fixed = 0;
    std::size_t dynamic = 0;
    for (const SimulationBody& body : bodies) {
        fixed += std::holds_alternative<FixedMotion>(body.motion) ? 1U : 0U;
        if (body.dynamic()) {
            const double mass = simulation.scene().materials.at(body.material).density * body.solid.volume;
            ++dynamic;
            least = std::min(least, mass);
            most = std::max(most, mass);
            sum += mass;
        }
    }
    Line line(lines);
    line << "bodies: " << dynamic << " dynamic";
    if (dynamic > 0) {
        line << ", " << least << " to " << most << " kg, " << sum << " kg together";
    }
    line << "; " << fixed << " fixed; " << bodies.size() - dynamic - fixed << " prescribed";
}

/// Bodies of the same motion share a line.
void add_motions(const Simulation& simulation, Lines& lines) {
    std::vector<std::pair<std::string, std::vector<std::string>>> motions;
    for (const SimulationBody& body : simulation.bodies()) {
        if (const auto* motion = std::get_if<PrescribedMotion>(&body.motion)) {
            const std::string words = motion_text(*motion);
            auto found = std::find_if(motions.begin(), motions.end(),
                                      [&](const auto& known) { return known.first == words; });
            if (found == motions.end()) {
                found = motions.insert(motions.end(), {words, {}});
            }
            found->second.push_back(body.name);
        }
    }
    for (const auto& [words, names] : motions) {
        Line line(lines);
        line << "motion: " << names.front();
        if (names.size() > 1) {
            line << " and " << names.size() - 1 << " more, each";
        }
        line << words;
    }
}

void add_shapes(const Simulation& simulation, Lines& lines) {
    for (const auto& [name, shape] : simulation.scene().shapes) {
        Line(lines) << "shape: " << name << ", "
                    << std::visit(ShapeText{simulation.solids().at(name)}, shape);
    }
}

}  // namespace scree
