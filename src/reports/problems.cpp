#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

Problem bare_problem(const std::string& name, double end_time, int looks) {
    Problem problem;
    problem.name = name;
    problem.scene = bare_scene(name, end_time, looks);
    return problem;
}

std::vector<Problem> accuracy_problems(bool quick) {
    return {incline_problem(),        sliding_to_rest_problem(), bounce_problem(),   free_top_problem(quick),
            stack_problem(quick),     mass_ratio_problem(),      cradle_problem(),   rolling_problem(),
            floating_block_problem(), sliding_disc_problem(),    pile_problem(quick)};
}

}  // namespace scree
