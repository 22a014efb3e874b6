#include <scree/scenes/features.hpp>

#include <algorithm>

namespace scree {

namespace {

using S = SceneDescription;

/// Whether some pair of the scene's materials can have a positive value.
template <auto of_material, auto of_pair>
bool anywhere(const S& scene) {
    const auto material_has = [](const auto& entry) { return entry.second.*of_material > 0; };
    const auto pair_has = [](const PairDescription& pair) { return (pair.*of_pair).value_or(0) > 0; };
    return std::any_of(scene.materials.begin(), scene.materials.end(), material_has) ||
           std::any_of(scene.pairs.begin(), scene.pairs.end(), pair_has);
}

template <class Kind>
bool has_shape(const S& scene) {
    const auto is_kind = [&](const auto& body) {
        return std::holds_alternative<Kind>(scene.shapes.at(body.shape));
    };
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), is_kind) ||
           std::any_of(scene.fill.begin(), scene.fill.end(), is_kind);
}

template <class Kind>
bool has_motion(const S& scene) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                       [](const BodyDescription& body) { return std::holds_alternative<Kind>(body.motion); });
}

template <Parts parts>
bool has_parts(const S& scene) {
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const auto& entry) {
        const auto* mesh = std::get_if<MeshShape>(&entry.second);
        return mesh != nullptr && mesh->parts == parts;
    });
}

bool has_friction(const S& scene) {
    return scene.law.friction != FrictionLaw::none &&
           anywhere<&Material::friction, &PairDescription::friction>(scene);
}

bool by_bullet(const S& scene) {
    return scene.stepping.method == SteppingMethod::bullet;
}

bool by_law(const S& scene) {
    return !by_bullet(scene);
}

bool has_polygonal_patches(const S& scene) {
    return has_shape<MeshShape>(scene) || has_shape<BoxShape>(scene);
}

template <FrictionLaw law>
bool has_friction_law(const S& scene) {
    return by_law(scene) && has_friction(scene) && scene.law.friction == law;
}

bool has_normal_damping(const S& scene) {
    return anywhere<&Material::normal_damping, &PairDescription::normal_damping>(scene);
}

bool has_tangential_damping(const S& scene) {
    return by_law(scene) && has_friction(scene) &&
           anywhere<&Material::tangential_damping, &PairDescription::tangential_damping>(scene);
}

struct Feature {
    const char* name;
    bool (*used)(const S&);
};

constexpr Feature features[] = {
    {"gravity", [](const S& s) { return s.gravity != Vec3::Zero(); }},
    {"friction", has_friction},
    {"plane_friction", has_friction_law<FrictionLaw::cundall_strack_2d>},
    {"viscous_friction", has_friction_law<FrictionLaw::viscous>},
    {"kinetic_friction",
     [](const S& s) {
         const auto differs = [](const auto& entry) { return entry.second.kinetic_friction.has_value(); };
         const auto pair_differs = [](const PairDescription& p) { return p.kinetic_friction.has_value(); };
         return by_law(s) && has_friction(s) &&
                (std::any_of(s.materials.begin(), s.materials.end(), differs) ||
                 std::any_of(s.pairs.begin(), s.pairs.end(), pair_differs));
     }},
    {"torsion",
     [](const S& s) {
         return by_law(s) && has_friction(s) && s.law.friction != FrictionLaw::cundall_strack_2d &&
                has_polygonal_patches(s) && anywhere<&Material::torsion, &PairDescription::torsion>(s);
     }},
    {"patch_friction",
     [](const S& s) {
         const auto flagged = [](const auto& entry) { return entry.second.patch_friction; };
         const auto pair_flagged = [](const PairDescription& p) { return p.patch_friction; };
         return by_law(s) && has_friction(s) && s.law.friction != FrictionLaw::cundall_strack_2d &&
                has_polygonal_patches(s) &&
                (std::any_of(s.materials.begin(), s.materials.end(), flagged) ||
                 std::any_of(s.pairs.begin(), s.pairs.end(), pair_flagged));
     }},
    {"rolling_friction",
     [](const S& s) {
         return by_law(s) && anywhere<&Material::rolling_friction, &PairDescription::rolling_friction>(s);
     }},
    {"cohesion",
     [](const S& s) { return by_law(s) && anywhere<&Material::cohesion, &PairDescription::cohesion>(s); }},
    {"normal_damping", has_normal_damping},
    {"rocking_damping",
     [](const S& s) {
         return by_law(s) && has_normal_damping(s) && has_polygonal_patches(s) &&
                s.law.damping == DampingPlace::patch;
     }},
    {"damping_by_patch",
     [](const S& s) {
         return by_law(s) && has_normal_damping(s) && s.law.normal_damping == NormalDamping::patch;
     }},
    {"tangential_damping", has_tangential_damping},
    {"effective_mass",
     [](const S& s) { return has_tangential_damping(s) && s.law.reduced_mass != ReducedMass::point; }},
    {"patch_stiffness",
     [](const S& s) {
         return by_law(s) && has_friction(s) && s.law.tangential_stiffness == TangentialStiffness::patch;
     }},
    {"co_rotation",
     [](const S& s) { return has_friction_law<FrictionLaw::cundall_strack>(s) && s.law.co_rotation; }},
    {"elasticity", by_law},
    {"elastic_potential", [](const S& s) { return by_law(s) && s.law.normal == NormalLaw::energy; }},
    {"pairs", [](const S& s) { return !s.pairs.empty(); }},
    {"meshes", has_shape<MeshShape>},
    {"boxes", has_shape<BoxShape>},
    {"spheres", has_shape<Sphere>},
    {"half_spaces", has_shape<HalfSpace>},
    {"decomposition", has_parts<Parts::decompose>},
    {"part_files", has_parts<Parts::files>},
    {"surfaces", has_parts<Parts::surface>},
    {"bullet_manifolds", [](const S& s) { return s.law.normal == NormalLaw::manifold; }},
    {"fixed_bodies", has_motion<FixedMotion>},
    {"prescribed_motion", has_motion<PrescribedMotion>},
    {"fill", [](const S& s) { return !s.fill.empty(); }},
    {"newton", [](const S& s) { return s.stepping.method == SteppingMethod::bdf; }},
    {"error_control", [](const S& s) { return !s.stepping.step; }},
    {"energy_ledger", by_law},
    {"sleep", [](const S& s) { return s.stepping.sleep && s.stepping.method == SteppingMethod::bdf; }},
    {"bullet_solver", by_bullet},
    {"replay", [](const S& s) { return s.output.replay; }},
    {"vtk_frames", [](const S& s) { return s.output.vtk; }},
    {"checkpoints", [](const S& s) { return s.output.checkpoint_every > 0; }},
};

}  // namespace

bool Features::uses(std::string_view feature) const {
    return std::find(used.begin(), used.end(), feature) != used.end();
}

Features scene_features(const SceneDescription& scene) {
    Features result;
    for (const Feature& feature : features) {
        (feature.used(scene) ? result.used : result.left_out).emplace_back(feature.name);
    }
    return result;
}

}  // namespace scree
