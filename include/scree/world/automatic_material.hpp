#pragma once

#include <limits>

#include <scree/contact/material.hpp>
#include <scree/detect/body_shape.hpp>

namespace scree {

/// e = exp(−2ζ arccos ζ/√(1−ζ²)): the restitution of a linear spring and dashpot that cannot pull, of damping
/// ratio ζ in [0, 1].
double restitution(double damping_ratio);

/// The inverse of that; 1 for a restitution that no ζ up to 1 gives, 0 for restitutions of 1 and more.
double damping_ratio(double restitution_wanted);

/// γn of a damping ratio at a face of area Lc², from ζ = γn √A/(2 Lc).
double normal_damping(double damping_ratio);

/// The least volume [m³] that a shape has below flat ground when it rests there, a face or a cap down, and
/// has sunk in by `depth` [m].
double resting_volume(const Shape& shape, double depth);

/// What Bullet knows of a body's surface.
struct SurfaceProperties {
    double friction = 0;          ///< μ
    double restitution = 0;       ///< e
    double rolling_friction = 0;  ///< [m], the largest rolling moment over the normal force
    double stiffness = std::numeric_limits<double>::infinity();  ///< [N/m]; infinite: not set
    double damping = 0;                                          ///< [N s/m], where the stiffness is set

    /// Equal in every property.
    bool operator==(const SurfaceProperties&) const = default;
};
/// As set on a Bullet object.
SurfaceProperties surface_properties(const btCollisionObject& object);

/// What is known of a body that was given no material.
struct UnnamedBody {
    double mass = 0;            ///< [kg]; infinite: forces do not move it
    double radius = 0;          ///< ℓ [m], of the sphere of the body's volume
    SurfaceProperties surface;  ///< as Bullet has it
};

/// A Young's modulus with which the body, resting on one of its faces under its own weight, sinks in by 10⁻⁴
/// ℓ at most; damping by its restitution. `gravity` [m/s²] counts as 9.81 when it is less. Where Bullet's
/// contact stiffness k and damping d are set, those of a face of area Lc²: Y = k/Lc and γn = d/√(k m).
/// Bullet's rolling friction is a length, which counts over Lc/2. A body that forces do not move has an
/// infinite modulus: that of whatever it touches.
Material automatic_material(const UnnamedBody& body, const BodyShape& shape, double gravity);

/// What Bullet makes of two bodies that both have no material, in place of the mixing rules: its combined
/// friction, rolling friction, restitution and, where one of them has such, contact stiffness and damping.
/// `pair`: by the mixing rules; `a`, `b`: of the bodies.
PairMaterial combined_by_bullet(PairMaterial pair, const btCollisionObject& object_a, const BodySize& a,
                                const btCollisionObject& object_b, const BodySize& b);

}  // namespace scree
