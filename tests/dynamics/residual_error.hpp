#pragma once

#include <tests/support/finite_difference.hpp>
#include <tests/support/step_case.hpp>

namespace scree::test {

struct ResidualError {
    double error = 0;
    ContactState state = ContactState::open;  ///< of the first contact
};

/// The Jacobian of a step's residual by the velocities of its free bodies against differences. Steps are
/// shares of what moves a body by `depth` [m], turns by `depth/radius`.
inline ResidualError residual_error(const StepCase& step, ContactForces& forces, double h, std::size_t order,
                                    double depth, double radius) {
    StepProblem problem(step.system, forces);
    step.begin(problem, h, order);
    ResidualError found;
    found.state = problem.results()[0].law.state;
    problem.factorize();
    const Eigen::MatrixXd whole = problem.jacobian().dense();

    std::vector<Eigen::Index> free;  // numbers of the unknowns
    for (std::size_t b = 0; b < step.system.bodies.size(); ++b) {
        for (std::size_t i = 0; i < 6 && step.system.bodies[b].dynamic(); ++i) {
            free.push_back(static_cast<Eigen::Index>(6 * b + i));
        }
    }
    const auto f = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        Eigen::VectorXd u = step.u;
        u(free) = x;
        problem.evaluate(u, Detail::force);
        return problem.residual()(free);
    };
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::VectorXd scale(count);
    Eigen::VectorXd rows(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const bool turns = free[static_cast<std::size_t>(i)] % 6 >= 3;
        scale(i) = depth / h / (turns ? radius : 1);
        rows(i) = turns ? radius : 1;
    }
    found.error = jacobian_error(f, step.u(free), whole(free, free), scale, rows);
    return found;
}

}  // namespace scree::test
