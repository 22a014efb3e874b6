#include <set>

#include <scree/scenes/read_scene.hpp>

#include "body_names.hpp"
#include "json_text.hpp"
#include "materials.hpp"
#include "plane_motion.hpp"

namespace scree {

namespace {

constexpr std::size_t most_bodies = 1'000'000;
constexpr double most_rows = 1e9;
constexpr double most_steps = 1e12;

template <class Named>
void require_name(const Named& named, const std::string& name, const std::string& place, const char* what) {
    if (!named.contains(name)) {
        throw SceneError(place, in_quotes(name), std::string("the name of a ") + what);
    }
}

void check_kinetic_friction(const SceneDescription& scene, std::size_t pair) {
    const PairDescription& entry = scene.pairs[pair];
    const double friction = pair_material(scene, entry.materials[0], entry.materials[1]).friction;
    if (entry.kinetic_friction.value_or(0) > friction) {
        throw SceneError("pairs." + std::to_string(pair) + ".kinetic_friction",
                         shown(*entry.kinetic_friction), "at most the pair's friction, " + shown(friction));
    }
}

void check_pairs(const SceneDescription& scene) {
    std::set<std::set<std::string>> seen;
    for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
        const std::string place = "pairs." + std::to_string(i) + ".materials";
        const auto& [a, b] = scene.pairs[i].materials;
        require_name(scene.materials, a, place + ".0", "material");
        require_name(scene.materials, b, place + ".1", "material");
        if (!seen.insert({a, b}).second) {
            throw SceneError(place, in_quotes(a) + " and " + in_quotes(b) + " again", "one entry a pair");
        }
        check_kinetic_friction(scene, i);
    }
}

// Velocities of the body itself are where a dynamic one starts from.
void check_start(const BodyDescription& body, const std::string& place) {
    if (std::holds_alternative<DynamicMotion>(body.motion)) {
        return;
    }
    const bool fixed = std::holds_alternative<FixedMotion>(body.motion);
    const char* found = fixed ? "a fixed body that moves" : "a prescribed body with a velocity of its own";
    const char* expected = fixed ? "no velocity" : "it in \"motion\"";
    if (body.velocity != Vec3::Zero()) {
        throw SceneError(place + ".velocity", found, expected);
    }
    if (body.angular_velocity != Vec3::Zero()) {
        throw SceneError(place + ".angular_velocity", found, expected);
    }
}

void check_vibration(const PrescribedMotion& motion, const std::string& place) {
    if (motion.amplitude == 0 && motion.frequency == 0) {
        return;
    }
    if (motion.amplitude == 0) {
        throw SceneError(place + ".frequency", "a frequency without an amplitude", "both above 0, or none");
    }
    if (motion.frequency == 0) {
        throw SceneError(place + ".amplitude", "an amplitude without a frequency", "both above 0, or none");
    }
    if (motion.velocity == Vec3::Zero()) {
        throw SceneError(place + ".velocity", "none", "the direction of the vibration");
    }
}

bool is_surface(const ShapeDescription& shape) {
    const auto* mesh = std::get_if<MeshShape>(&shape);
    return mesh != nullptr && mesh->parts == Parts::surface;
}

void check_bodies(const SceneDescription& scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDescription& body = scene.bodies[i];
        const std::string place = "bodies." + std::to_string(i);
        require_name(scene.shapes, body.shape, place + ".shape", "shape");
        require_name(scene.materials, body.material, place + ".material", "material");
        if (std::holds_alternative<HalfSpace>(scene.shapes.at(body.shape)) &&
            std::holds_alternative<DynamicMotion>(body.motion)) {
            throw SceneError(place + ".motion", "a half-space that is dynamic", "\"fixed\" or an object");
        }
        if (is_surface(scene.shapes.at(body.shape)) && std::holds_alternative<DynamicMotion>(body.motion)) {
            throw SceneError(place + ".motion", "a surface that is dynamic", "\"fixed\" or an object");
        }
        check_start(body, place);
        if (const auto* motion = std::get_if<PrescribedMotion>(&body.motion)) {
            check_vibration(*motion, place + ".motion");
        }
    }
}

void check_fill(const SceneDescription& scene) {
    for (std::size_t i = 0; i < scene.fill.size(); ++i) {
        const FillDescription& fill = scene.fill[i];
        const std::string place = "fill." + std::to_string(i);
        require_name(scene.shapes, fill.shape, place + ".shape", "shape");
        require_name(scene.materials, fill.material, place + ".material", "material");
        if (std::holds_alternative<HalfSpace>(scene.shapes.at(fill.shape))) {
            throw SceneError(place + ".shape", in_quotes(fill.shape) + ", a half-space", "a bounded shape");
        }
        if (is_surface(scene.shapes.at(fill.shape))) {
            throw SceneError(place + ".shape", in_quotes(fill.shape) + ", a surface", "a solid");
        }
    }
}

// No run may be longer than anyone waits for: a step and a turn each take some work.
void check_duration(const SceneDescription& scene) {
    const double end = scene.end_time;
    if (scene.stepping.step && end / *scene.stepping.step > most_steps) {
        throw SceneError("stepping.step", "more than 1e12 steps to make", "a longer step");
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDescription& body = scene.bodies[i];
        const std::string place = "bodies." + std::to_string(i);
        const auto* motion = std::get_if<PrescribedMotion>(&body.motion);
        if (body.angular_velocity.norm() * end > most_steps) {
            throw SceneError(place + ".angular_velocity", "more than 1e12 radians to turn", "a slower turn");
        }
        if (motion != nullptr && motion->angular_velocity.norm() * end > most_steps) {
            throw SceneError(place + ".motion.angular_velocity", "more than 1e12 radians to turn",
                             "a slower turn");
        }
        if (motion != nullptr && motion->frequency * end > most_steps) {
            throw SceneError(place + ".motion.frequency", "more than 1e12 periods", "a slower vibration");
        }
    }
}

void check_size(const SceneDescription& scene) {
    std::size_t bodies = scene.bodies.size();
    for (const FillDescription& fill : scene.fill) {
        bodies += fill.count;
    }
    if (bodies == 0) {
        throw SceneError("", "no bodies", "at least one in \"bodies\" or \"fill\"");
    }
    if (bodies > most_bodies) {
        throw SceneError("fill", std::to_string(bodies) + " bodies",
                         std::to_string(most_bodies) + " at most");
    }
    const double ticks = scene.end_time / scene.output.every;
    if (ticks * static_cast<double>(scene.output.bodies ? bodies : 1) > most_rows) {
        throw SceneError("output.every", "more than 1e9 rows to write", "a longer time between outputs");
    }
}

}  // namespace

void check_scene(const SceneDescription& scene) {
    try {
        check_pairs(scene);
        check_bodies(scene);
        check_fill(scene);
        check_size(scene);
        check_duration(scene);
        check_plane_motion(scene);
        body_names(scene);
    } catch (const SceneError& error) {
        throw error.in_file(scene.file.string());
    }
}

}  // namespace scree
