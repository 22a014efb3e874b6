#pragma once

#include <limits>
#include <optional>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// What a body is made of.
struct Material {
    double density = 0;                   ///< [kg/m³]
    double youngs_modulus = 0;            ///< Y [Pa]
    double friction = 0;                  ///< μ
    double normal_damping = 0.5;          ///< γn
    double tangential_damping = 0.5;      ///< γt
    double tangential_ratio = 2.0 / 7.0;  ///< Yt/Y
    bool torsion = true;                  ///< resist spin about the contact normal
    /// μ while it slides, at most that above; empty: the same.
    std::optional<double> kinetic_friction = std::nullopt;
    double rolling_friction = 0;  ///< μ_r: the largest rolling moment over the normal force and Lc/2
    double cohesion = 0;          ///< [N], the largest pull that a contact bears
    bool patch_friction = false;  ///< with torsion: friction on cells of the patch, each with its own memory

    /// Equal in every constant.
    bool operator==(const Material&) const = default;
};

/// What a pair of materials is made of; the same fields, without the density.
struct PairMaterial {
    double youngs_modulus = 0;                              ///< Y [Pa]
    double friction = 0;                                    ///< μ
    double normal_damping = 0.5;                            ///< γn
    double tangential_damping = 0.5;                        ///< γt
    double tangential_ratio = 2.0 / 7.0;                    ///< Yt/Y
    bool torsion = true;                                    ///< resist spin about the contact normal
    std::optional<double> kinetic_friction = std::nullopt;  ///< μ while it slides; empty: `friction`
    double rolling_friction = 0;                            ///< μ_r
    double cohesion = 0;                                    ///< [N]
    bool patch_friction = false;                            ///< with torsion: on cells of the patch
    bool even_damping = false;  ///< NormalDamping::patch, whatever the law's options say
};

/// The mixing rules: harmonic mean of Y; the smaller μ at rest, in motion and of rolling, the smaller
/// cohesion; means of the dampings and of Yt/Y; torsion and friction on cells if both have it.
PairMaterial mix(const Material& a, const Material& b);

/// What the pair constants need to know of a body.
struct BodySize {
    double mass =
        std::numeric_limits<double>::infinity();  ///< [kg]; infinite for a body that forces do not move
    double radius = 0;  ///< [m], of the sphere of the body's volume; not asked of a body of infinite mass
    /// Principal moments [kg m²]; infinite for a body that does not turn.
    Vec3 inertia = Vec3::Constant(std::numeric_limits<double>::infinity());
};

/// The constants of a pair of bodies, fixed for its life.
struct PairConstants {
    double length = 0;                      ///< Lc [m], Eq. (5.3)
    double reduced_mass = 0;                ///< M_red [kg], Eq. (5.28)
    double round_mass = 0;                  ///< M_red [kg] of round bodies at their surfaces, Eq. (5.20)
    double elastic = 0;                     ///< Y/Lc [N/m³]: elastic force per overlap volume, Eq. (5.7)
    double normal_damping = 0;              ///< γn √(Y M_red/Lc³) [N s/m³], Eq. (5.7)
    double tangential_stiffness = 0;        ///< Yt Lc [N/m], Eq. (5.17)
    double tangential_damping = 0;          ///< γt √(Yt M_red Lc) [N s/m], Eq. (5.21)
    double friction = 0;                    ///< μ
    double kinetic_friction = 0;            ///< μ from when a contact slips until it sticks again
    double rolling_friction = 0;            ///< μ_r
    double cohesion = 0;                    ///< [N]
    bool torsion = true;                    ///< both materials have it
    bool patch_friction = false;            ///< on cells of the patch
    bool even_damping = false;              ///< the normal damping is that of NormalDamping::patch
    int law = 0;                            ///< which of a world's laws; 0: the one for all pairs
    Vec3 inverse_inertia_a = Vec3::Zero();  ///< about A's principal axes [1/(kg m²)]
    Vec3 inverse_inertia_b = Vec3::Zero();  ///< about B's [1/(kg m²)]
};

/// Lc = 4 r₁ r₂/(r₁ + r₂), our reading of Eq. (5.3): two equal spheres have the distance of their centres. A
/// body of infinite mass takes the other's radius.
double characteristic_length(const BodySize& a, const BodySize& b);

/// 1/(1/m₁ + 1/m₂), Eq. (5.28).
double reduced_mass(const BodySize& a, const BodySize& b);

/// 1/(1/m₁ + 1/m₂ + r₁²/I₁ + r₂²/I₂), Eq. (5.20), and (5.27) against a body that does not move. For bodies
/// that are not round r is the radius of the sphere of their volume and I the mean of their principal
/// moments.
double round_mass(const BodySize& a, const BodySize& b);

/// Of a pair material between two bodies, by Eqs. (5.3), (5.7), (5.17), (5.20), (5.21) and (5.28).
PairConstants pair_constants(const PairMaterial& material, const BodySize& a, const BodySize& b);

}  // namespace scree
