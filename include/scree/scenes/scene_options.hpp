#pragma once

#include <optional>

#include <scree/bdf/options.hpp>
#include <scree/contact/law_options.hpp>

namespace scree {

enum class NormalLaw { volume, manifold, energy };

/// Which parts a contact's force has.
struct LawDescription : LawOptions {
    NormalLaw normal = NormalLaw::volume;
    FrictionLaw friction = FrictionLaw::cundall_strack;
};

enum class SteppingMethod { bdf, verlet, symplectic_euler, bullet };

/// How steps are made.
struct SteppingDescription {
    SteppingMethod method = SteppingMethod::bdf;
    int max_order = 2;           ///< 1 to 5
    std::optional<double> step;  ///< [s], fixed; without one it is chosen by the error test
    double rtol = 1e-3;          ///< dimensionless, as is atol
    double atol = 1e-6;
    Solver solver = Solver::automatic;
    bool sleep = false;   ///< groups at rest are stepped no more until something reaches them
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
