#include <scree/bdf/newton.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr std::size_t most_iterations = 25;
constexpr std::size_t full_steps = 4;  // before the search sets in
constexpr std::size_t most_age = 20;   // steps that a factorisation serves
constexpr double most_change = 0.3;    // of βh, that a factorisation survives
constexpr double still_share = 1e-2;   // of what is solved, that a prediction needs no iteration for
constexpr double hard_share =
    30;  // times what is solved, that will do where bodies collide: nothing creeps there
constexpr double stall = 0.5;  // ratio of successive defects, above which they are noise
constexpr double slow = 0.2;   // ratio of successive defects, above which the matrix is made anew
constexpr double steep = 0.5;  // share of the first slope that a searched step may leave
constexpr int most_searches = 8;
constexpr double small_share = 0.3;  // of a direction, twice in a row: a smaller step costs less
constexpr double caps[] = {0.3, 1, 3, 10, 30};
constexpr double roundings = 32;  // units in the last place of a position that count as none

}  // namespace

double defect_norm(const StepProblem& problem, std::span<const Body> bodies, double gravity) {
    const ErrorScale scale(bodies, problem.trial(), gravity);
    double largest = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!bodies[b].dynamic()) {
            continue;
        }
        const auto row = static_cast<Eigen::Index>(6 * b);
        BodyState defect;
        defect.orientation = problem.trial()[b].pose.orientation;
        defect.momentum = problem.residual().segment<3>(row);
        defect.angular_momentum = problem.residual().segment<3>(row + 3);
        const double size =
            scale.norm(b, {Vec3::Zero(), Vec3::Zero(), velocity(bodies[b], defect), spin(bodies[b], defect)});
        largest = size <= largest ? largest : size;
    }
    return largest;
}

bool at_rounding(const StepProblem& problem, std::span<const Body> bodies, const Eigen::VectorXd& change) {
    constexpr double unit = roundings * std::numeric_limits<double>::epsilon();
    const double beta_h = problem.formulas().beta_h;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const auto row = static_cast<Eigen::Index>(6 * b);
        const double size = bodies[b].radius;
        const double moved = beta_h * change.segment<3>(row).norm();
        const double turned = beta_h * change.segment<3>(row + 3).norm();
        const double here = problem.trial()[b].pose.position.norm() + size;
        if (bodies[b].dynamic() && !(moved + turned * size <= unit * here)) {
            return false;
        }
    }
    return true;
}

bool Newton::solve(StepProblem& problem, std::span<const Body> bodies, double gravity, double tolerance,
                   Persistence persistence, Eigen::VectorXd& u) {
    predicted_ = u;
    effort_ = 0;
    persistence_ = persistence;
    if (iterate(problem, bodies, gravity, tolerance, u) == Outcome::converged) {
        return true;
    }
    if (persistence == Persistence::brief) {
        forget();
        u = predicted_;
        return false;
    }
    // From softer friction to the law as it is, each from the last solution.
    u = predicted_;
    for (const double cap : caps) {
        problem.cap_friction(cap);
        forget();
        if (iterate(problem, bodies, gravity, tolerance, u) == Outcome::failed) {
            break;
        }
    }
    problem.cap_friction(std::numeric_limits<double>::infinity());
    forget();
    if (iterate(problem, bodies, gravity, tolerance, u) == Outcome::converged) {
        return true;
    }
    forget();
    u = predicted_;
    return false;
}

Newton::Outcome Newton::iterate(StepProblem& problem, std::span<const Body> bodies, double gravity,
                                double tolerance, Eigen::VectorXd& u) {
    bool anew = stale(problem);
    ++age_;
    problem.evaluate(u, anew ? Detail::derivative : Detail::force);
    double last = defect_norm(problem, bodies, gravity);
    bool crawling = false;  // the last direction was searched to a small part
    if (last <= still_share * solved_share * tolerance) {
        return Outcome::converged;
    }
    for (std::size_t i = 0; i < most_iterations; ++i) {
        anew = anew || problem.states_changed();
        if (anew && !refresh(problem, u)) {
            return Outcome::failed;
        }
        direction_ = -problem.residual();
        if (!problem.solve(direction_)) {
            return Outcome::failed;
        }
        ++statistics_.iterations;
        ++effort_;
        const double share = i < full_steps ? 1 : search(problem, u, direction_);
        if (persistence_ == Persistence::brief && share < small_share && std::exchange(crawling, true)) {
            return Outcome::failed;
        }
        u += share * direction_;
        // Who had to renew the matrix once will probably have to again.
        problem.evaluate(u, anew ? Detail::derivative : Detail::force);
        const double defect = defect_norm(problem, bodies, gravity);
        if (!std::isfinite(defect)) {
            return Outcome::failed;
        }
        // At the rounding of the forces, or of the positions that they follow from, an exact direction gains
        // nothing more.
        const bool stalled = anew && defect > stall * last;
        const double enough = solved_share * tolerance * (i + 1 >= full_steps ? hard_share : 1);
        if (defect <= enough ||
            (stalled && (defect <= tolerance || at_rounding(problem, bodies, direction_)))) {
            return Outcome::converged;
        }
        anew = defect > slow * last || share < 1;
        last = defect;
    }
    return Outcome::failed;
}

bool Newton::stale(const StepProblem& problem) const {
    return !factorized_ || age_ >= most_age ||
           std::abs(problem.formulas().beta_h / factorized_beta_h_ - 1) > most_change;
}

bool Newton::refresh(StepProblem& problem, const Eigen::VectorXd& u) {
    if (problem.detail() != Detail::derivative) {
        problem.evaluate(u, Detail::derivative);
    }
    ++statistics_.jacobians;
    ++statistics_.factorizations;
    factorized_ = problem.factorize();
    factorized_beta_h_ = problem.formulas().beta_h;
    age_ = 0;
    return factorized_;
}

// The share of the direction where R·du vanishes, by regula falsi between its ends, or 1 while it has not
// passed.
double Newton::search(StepProblem& problem, const Eigen::VectorXd& u, const Eigen::VectorXd& direction) {
    const double slope = problem.residual().dot(direction);
    const auto slope_at = [&](double share) {
        trial_ = u + share * direction;
        problem.evaluate(trial_, Detail::force);
        return problem.residual().dot(direction);
    };
    double low = 0;
    double low_slope = slope;
    double high = 1;
    double high_slope = slope_at(high);
    if (!(slope < 0) || high_slope <= steep * std::abs(slope)) {
        return 1;
    }
    double share = high;
    for (int i = 0; i < most_searches; ++i) {
        share = low + (high - low) * std::clamp(-low_slope / (high_slope - low_slope), 0.1, 0.9);
        const double at = slope_at(share);
        if (std::abs(at) <= steep * std::abs(slope)) {
            break;
        }
        (at < 0 ? low : high) = share;
        (at < 0 ? low_slope : high_slope) = at;
    }
    return share;
}

}  // namespace scree
