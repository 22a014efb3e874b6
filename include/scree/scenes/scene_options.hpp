#pragma once

#include <optional>

namespace scree {

enum class NormalLaw { volume, manifold, energy };
enum class FrictionLaw { cundall_strack, cundall_strack_2d, viscous, none };
enum class DampingPlace { patch, centroid };
enum class TangentialStiffness {
    length,     ///< Yt Lc, Eq. (5.17)
    patch,      ///< grows with the patch
    no_length,  ///< Yt, Eq. (5.18)
};
enum class ReducedMass {
    point,  ///< Eq. (5.28)
    round,  ///< Eq. (5.20)
    exact,
};

/// Which parts a contact's force has.
struct LawDescription {
    NormalLaw normal = NormalLaw::volume;
    FrictionLaw friction = FrictionLaw::cundall_strack;
    DampingPlace damping = DampingPlace::patch;
    TangentialStiffness tangential_stiffness = TangentialStiffness::length;
    bool co_rotation = true;  ///< turn the stored force with the pair; false: the literal scheme
    ReducedMass reduced_mass = ReducedMass::point;
};

enum class SteppingMethod { bdf, verlet, symplectic_euler, bullet };
enum class SolverChoice { automatic, newton, fixed_point };

/// How steps are made.
struct SteppingDescription {
    SteppingMethod method = SteppingMethod::bdf;
    int max_order = 2;           ///< 1 to 5
    std::optional<double> step;  ///< [s], fixed; without one it is chosen by the error test
    double rtol = 1e-3;          ///< dimensionless, as is atol
    double atol = 1e-6;
    SolverChoice solver = SolverChoice::automatic;
    int iterations = 10;  ///< of Bullet's own solver
};

/// What is written, and when.
struct OutputDescription {
    double every = 0.02;  ///< [s], between output times; also the world's tick
    bool bodies = true;
    bool energy = true;
    bool contacts = false;
    bool replay = true;
    bool vtk = false;
    double checkpoint_every = 0;  ///< [s]; 0: none
};

}  // namespace scree
