#include "problem.hpp"

namespace scree {

std::vector<Problem> accuracy_problems(bool quick) {
    return {incline_problem(),        sliding_to_rest_problem(), bounce_problem(),   free_top_problem(quick),
            stack_problem(quick),     mass_ratio_problem(),      cradle_problem(),   rolling_problem(),
            floating_block_problem(), sliding_disc_problem(),    pile_problem(quick)};
}

}  // namespace scree
