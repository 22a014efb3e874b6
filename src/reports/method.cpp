#include "method.hpp"

#include "table.hpp"

namespace scree {

namespace {

constexpr double atol_over_rtol = 1e-3;  // as the defaults of a scene have it

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : "; ") + word;
    }
    return text;
}

}  // namespace

std::string MethodChoice::name() const {
    switch (stepping.method) {
        case SteppingMethod::verlet:
            return "verlet";
        case SteppingMethod::symplectic_euler:
            return "symplectic_euler";
        case SteppingMethod::bullet:
            return "bullet";
        case SteppingMethod::bdf:
            break;
    }
    return "bdf" + std::to_string(stepping.max_order);
}

std::string MethodChoice::settings() const {
    std::vector<std::string> words;
    if (by_bullet()) {
        words.push_back(std::to_string(stepping.iterations) + " iterations");
        if (stepping.separating_axis) {
            words.emplace_back("separating axis");
        }
        if (stepping.friction_directions != 1) {
            words.push_back(std::to_string(stepping.friction_directions) + " friction directions");
        }
    }
    if (by_bdf() && stepping.solver != Solver::automatic) {
        words.emplace_back(stepping.solver == Solver::newton ? "newton" : "functional");
    }
    if (geometry == NormalLaw::manifold) {
        words.emplace_back("manifold");
    }
    return joined(words);
}

std::string MethodChoice::step() const {
    return stepping.step ? cell(*stepping.step) : "adaptive";
}

std::string MethodChoice::rtol() const {
    return stepping.step ? "" : cell(stepping.rtol);
}

std::string MethodChoice::text() const {
    std::string all = name() + (stepping.step ? ", step " + step() + " s" : ", rtol " + rtol());
    return settings().empty() ? all : all + "; " + settings();
}

void MethodChoice::apply(SceneDescription& scene) const {
    const bool sleep = scene.stepping.sleep;
    scene.stepping = stepping;
    scene.stepping.sleep = sleep;
    scene.law.normal = geometry;
}

MethodChoice adaptive_bdf(int order, double rtol, Solver solver) {
    MethodChoice method;
    method.stepping.max_order = order;
    method.stepping.rtol = rtol;
    method.stepping.atol = atol_over_rtol * rtol;
    method.stepping.solver = solver;
    return method;
}

MethodChoice fixed_bdf(int order, double step, Solver solver) {
    MethodChoice method;
    method.stepping.max_order = order;
    method.stepping.step = step;
    method.stepping.solver = solver;
    return method;
}

MethodChoice explicit_method(SteppingMethod kind, double step) {
    MethodChoice method;
    method.stepping.method = kind;
    method.stepping.step = step;
    return method;
}

MethodChoice bullet_method(double step, int iterations) {
    MethodChoice method = explicit_method(SteppingMethod::bullet, step);
    method.stepping.iterations = iterations;
    return method;
}

MethodChoice bullet_at_best(double step, int iterations) {
    MethodChoice method = bullet_method(step, iterations);
    method.stepping.separating_axis = true;
    method.stepping.friction_directions = 2;
    return method;
}

MethodChoice on_manifolds(MethodChoice method) {
    method.geometry = NormalLaw::manifold;
    return method;
}

}  // namespace scree
