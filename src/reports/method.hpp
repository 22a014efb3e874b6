#pragma once

#include <string>
#include <vector>

#include <scree/scenes/scene_description.hpp>

namespace scree {

/// How a scene is stepped: what a row of a table differs in from the others of its scene.
struct MethodChoice {
    SteppingDescription stepping;
    NormalLaw geometry = NormalLaw::volume;

    /// bdf1 to bdf5, verlet, symplectic_euler or bullet.
    [[nodiscard]] std::string name() const;
    /// What the name, the step and the tolerance do not say.
    [[nodiscard]] std::string settings() const;
    [[nodiscard]] std::string step() const;  ///< [s], or "adaptive"
    [[nodiscard]] std::string rtol() const;  ///< empty where the step is fixed
    /// All of that in one line.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] bool by_bullet() const { return stepping.method == SteppingMethod::bullet; }
    [[nodiscard]] bool by_bdf() const { return stepping.method == SteppingMethod::bdf; }

    void apply(SceneDescription& scene) const;
};

MethodChoice adaptive_bdf(int order, double rtol, Solver solver = Solver::automatic);
MethodChoice fixed_bdf(int order, double step, Solver solver = Solver::automatic);
/// Velocity Verlet or symplectic Euler.
MethodChoice explicit_method(SteppingMethod method, double step);
MethodChoice bullet_method(double step, int iterations);
/// Bullet's solver at its best: contacts by separating axes, and two directions of friction.
MethodChoice bullet_at_best(double step, int iterations);
/// The same with Bullet's manifold as geometry.
MethodChoice on_manifolds(MethodChoice method);

}  // namespace scree
