#include "accuracy.hpp"

namespace scree {

namespace {

constexpr double steps[] = {2e-2, 5e-3, 1e-3, 2e-4, 5e-5};        // [s], of implicit methods
constexpr double small_steps[] = {1e-3, 2e-4, 5e-5, 2e-5, 5e-6};  // of explicit ones
constexpr double tolerances[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
constexpr double bullet_steps[] = {1.0 / 60, 1.0 / 240, 1e-3, 2e-4};
constexpr int bullet_iterations[] = {10, 50, 200};

/// Every one of a list, or every other one of it in a quick report.
template <class Add, class Value, std::size_t count>
void each(const Value (&values)[count], bool quick, Add&& add) {
    for (std::size_t i = quick && count > 3 ? 1 : 0; i < count; i += quick ? 2 : 1) {
        add(values[i]);
    }
}

void add_bdf(std::vector<MethodChoice>& methods, bool quick) {
    for (const int order : quick ? std::vector{1, 2, 3, 5} : std::vector{1, 2, 3, 4, 5}) {
        each(tolerances, quick, [&](double rtol) { methods.push_back(adaptive_bdf(order, rtol)); });
        each(steps, quick, [&](double step) { methods.push_back(fixed_bdf(order, step)); });
    }
    if (quick) {  // the cheapest answers, beside Bullet's
        methods.push_back(adaptive_bdf(2, tolerances[0]));
        methods.push_back(fixed_bdf(2, steps[0]));
    }
}

void add_solvers(std::vector<MethodChoice>& methods, bool quick) {
    for (const Solver solver : {Solver::newton, Solver::fixed_point}) {
        for (const double rtol : {1e-2, 1e-3, 1e-4, 1e-5}) {
            if (!quick || rtol == 1e-3) {
                methods.push_back(adaptive_bdf(2, rtol, solver));
            }
        }
        for (const double step : {1e-3, 1e-4, 2e-5}) {
            if (!quick || step == 1e-4) {
                methods.push_back(fixed_bdf(2, step, solver));
            }
        }
    }
}

void add_manifolds(std::vector<MethodChoice>& methods, bool quick) {
    for (const double rtol : {1e-2, 1e-3, 1e-4, 1e-5}) {
        if (!quick || rtol == 1e-3) {
            methods.push_back(on_manifolds(adaptive_bdf(2, rtol)));
        }
    }
    for (const double step : {2e-5, 5e-6}) {
        if (!quick) {
            methods.push_back(on_manifolds(explicit_method(SteppingMethod::verlet, step)));
        }
    }
}

void add_explicit(std::vector<MethodChoice>& methods, bool quick) {
    for (const SteppingMethod kind : {SteppingMethod::symplectic_euler, SteppingMethod::verlet}) {
        each(small_steps, quick, [&](double step) { methods.push_back(explicit_method(kind, step)); });
    }
}

void add_bullet(std::vector<MethodChoice>& methods, bool quick) {
    for (const int iterations : bullet_iterations) {
        for (const double step : bullet_steps) {
            if (quick && step == 1e-3) {
                continue;
            }
            if (!quick || iterations != 200) {
                methods.push_back(bullet_method(step, iterations));
            }
            if (!quick || iterations != 10) {
                methods.push_back(bullet_at_best(step, iterations));
            }
        }
    }
}

/// A whole tells no more by more rows than these.
std::vector<MethodChoice> whole_methods(bool quick) {
    std::vector<MethodChoice> methods;
    for (const int order : {1, 2, 3, 4, 5}) {
        methods.push_back(adaptive_bdf(order, 1e-2));
    }
    methods.insert(methods.end(),
                   {fixed_bdf(1, 2e-3), fixed_bdf(2, 2e-3), on_manifolds(adaptive_bdf(2, 1e-2)),
                    explicit_method(SteppingMethod::symplectic_euler, 1e-4),
                    explicit_method(SteppingMethod::verlet, 1e-4), bullet_method(1.0 / 60, 10),
                    bullet_method(1.0 / 240, 10), bullet_method(1e-3, 50), bullet_at_best(1.0 / 240, 50),
                    bullet_at_best(1e-3, 200)});
    if (!quick) {
        methods.insert(methods.end(),
                       {adaptive_bdf(2, 1e-3), adaptive_bdf(3, 1e-3), adaptive_bdf(2, 1e-2, Solver::newton),
                        adaptive_bdf(2, 1e-2, Solver::fixed_point), fixed_bdf(2, 5e-4),
                        explicit_method(SteppingMethod::verlet, 2e-5)});
    }
    return methods;
}

}  // namespace

std::vector<MethodChoice> accuracy_methods(const Problem& problem, bool quick) {
    if (problem.chaotic) {
        return whole_methods(quick);
    }
    std::vector<MethodChoice> methods;
    add_bdf(methods, quick);
    if (!problem.free_flight) {
        add_solvers(methods, quick);
        add_manifolds(methods, quick);
    }
    add_explicit(methods, quick);
    if (problem.free_flight) {
        each(bullet_steps, quick, [&](double step) { methods.push_back(bullet_method(step, 10)); });
    } else if (!problem.no_bullet) {
        add_bullet(methods, quick);
    }
    return methods;
}

}  // namespace scree
