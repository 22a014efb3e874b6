#pragma once

#include <optional>

#include <scree/bdf/options.hpp>
#include <scree/contact/law_options.hpp>

namespace scree {

/// Where the normal force comes from: Eq. (5.7), Bullet's manifolds, or a potential.
enum class NormalLaw { volume, manifold, energy };

/// Which parts a contact's force has.
struct LawDescription : LawOptions {
    NormalLaw normal = NormalLaw::volume;                ///< by the overlap's volume, Eq. (5.7)
    FrictionLaw friction = FrictionLaw::cundall_strack;  ///< with memory, Eqs. (5.13) to (5.17)
};

/// Scree's methods, or Bullet's own solver.
enum class SteppingMethod { bdf, verlet, symplectic_euler, bullet };

/// How steps are made.
struct SteppingDescription {
    SteppingMethod method = SteppingMethod::bdf;  ///< of stepping
    int max_order = 2;                            ///< 1 to 5
    std::optional<double> step;                   ///< [s], fixed; without one it is chosen by the error test
    double rtol = 1e-3;                           ///< dimensionless, as is atol
    double atol = 1e-6;                           ///< over the same scales as rtol
    Solver solver = Solver::automatic;            ///< of the equations of a BDF step
    bool sleep = false;  ///< groups at rest are stepped no more until something reaches them
    // Of Bullet's own solver, as it comes when nothing is said:
    int iterations = 10;           ///< of the constraint solver
    bool separating_axis = false;  ///< contacts of polyhedra by the separating axis test and clipped faces
    int friction_directions = 1;   ///< 2: friction does not depend on where the axes lie
};

/// What is written, and when.
struct OutputDescription {
    double every = 0.02;          ///< [s], between output times; also the world's tick
    bool bodies = true;           ///< bodies.csv
    bool energy = true;           ///< energy.csv
    bool contacts = false;        ///< contacts.csv
    bool replay = true;           ///< replay.glb
    bool vtk = false;             ///< frames for ParaView
    double checkpoint_every = 0;  ///< [s]; 0: none
};

}  // namespace scree
