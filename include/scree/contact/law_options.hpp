#pragma once

namespace scree {

/// What resists sliding.
enum class FrictionLaw {
    cundall_strack,     ///< a spring with memory, cut off at μ fn: Eqs. (5.13)–(5.16)
    cundall_strack_2d,  ///< the same as a signed number along e_y × n, for motion in the x–z plane: Eq.
                        ///< (5.12)
    viscous,  ///< against the velocity and without memory, cut off at μ fn; nothing then holds still
    none,     ///< no tangential force at all
};

/// What the elastic part of the normal force is.
enum class Elasticity {
    volume,     ///< (Y/Lc) V along n, Eq. (5.7); of a corner on a corner it has no potential
    potential,  ///< the gradient of a potential: (Y/Lc) ∫ e dV of DepthPotential, of polyhedra on one another
};

/// Where the normal damping acts.
enum class DampingPlace {
    patch,     ///< a traction on a polygonal patch, which damps rocking, too
    centroid,  ///< a force at the centroid, literally as in the source
};

/// cn, the normal damping per volume and second.
enum class NormalDamping {
    length,  ///< γn √(Y M_red/Lc³), Eq. (5.7): a face has ζ = γn √A/(2 Lc), and corners next to none
    patch,   ///< γn √(Y M_red/(Lc ‖S‖)): every contact has ζ = γn/2, whatever its patch
};

/// kt, the stiffness of the tangential spring.
enum class TangentialStiffness {
    length,     ///< Yt Lc, Eq. (5.17)
    patch,      ///< (Yt/Lc) ‖S‖: grows and shrinks with the patch, as the normal stiffness does
    no_length,  ///< Yt times one metre, Eq. (5.18); far too stiff for bodies of millimetres
};

/// M of the tangential damping γt √(kt M).
enum class ReducedMass {
    point,  ///< 1/m₁ + 1/m₂, Eq. (5.28)
    round,  ///< with r²/I of either body, Eq. (5.20)
    exact,  ///< of the two bodies at this contact in this direction, Eqs. (5.22)–(5.26)
};

/// Choices that are made while the law runs.
struct LawOptions {
    Elasticity elasticity = Elasticity::volume;            ///< of the normal force
    DampingPlace damping = DampingPlace::patch;            ///< where the normal damping acts
    NormalDamping normal_damping = NormalDamping::length;  ///< its size
    TangentialStiffness tangential_stiffness = TangentialStiffness::length;  ///< of the friction's spring
    ReducedMass reduced_mass = ReducedMass::point;                           ///< of the friction's damping
    bool co_rotation =
        true;  ///< turn the stored force with the pair; false: the literal scheme of the source
};

/// Which parts a scene can enter; what is left out is not compiled into its loop.
struct LawParts {
    FrictionLaw friction = FrictionLaw::cundall_strack;  ///< none: neither torsion nor cells
    bool torsion = true;                                 ///< about the normal, where a pair has it
    bool rolling = false;                                ///< resistance, where a pair has it

    /// The same parts.
    bool operator==(const LawParts&) const = default;
};

}  // namespace scree
