#pragma once

#include <cstddef>

#include <scree/bdf/error_norm.hpp>

namespace scree {

/// How a step is made: by an implicit BDF, or by one of two explicit methods, for comparison.
enum class Method { bdf, symplectic_euler, velocity_verlet };

/// How the equations of an implicit step are solved.
enum class Solver {
    automatic,    ///< by iteration where an estimate of the stiffness says that it converges, else by Newton
    newton,       ///< Newton's method, whatever the stiffness
    fixed_point,  ///< the functional corrector alone; a step that it cannot solve is made smaller
};

/// How the steps of a system are made.
struct SteppingOptions {
    Method method = Method::bdf;  ///< of stepping
    std::size_t max_order = 2;    ///< of BDF, 1 to 5; only 1 and 2 are A-stable
    /// [s]; 0: chosen by the error test, which only BDF has. BDF makes shorter ones where bodies would pass
    /// through each other, or where the equations are not solved.
    double fixed_step = 0;
    Solver solver = Solver::automatic;  ///< of the equations of a BDF step
    bool sleep = false;                 ///< groups at rest are stepped no more until something reaches them
    Tolerances tolerances;              ///< of the error test, and of the equations' solution
};

}  // namespace scree
