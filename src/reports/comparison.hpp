#pragma once

#include <limits>
#include <string>
#include <vector>

#include "table.hpp"

namespace scree {

/// A finished row of the accuracy table, as a point of a diagram.
struct Work {
    std::string label;   ///< method, step or tolerance, settings
    std::string family;  ///< the same but for step and tolerance
    bool by_bullet = false;
    double seconds = 0;
    double error = 0;
    double numerical_error = std::numeric_limits<double>::quiet_NaN();
};

/// The finished rows of a problem, right or wrong in the end.
std::vector<Work> finished_work(const Table& accuracy, const std::string& problem);

/// The one with the least error, or the least time among those with at most an error, or the least error
/// among those within a time. Null: there is none.
const Work* most_exact(const std::vector<Work>& work, bool by_bullet,
                       double within = std::numeric_limits<double>::infinity());
const Work* fastest(const std::vector<Work>& work, bool by_bullet, double error);

/// How scree and Bullet's own solver stand on a problem.
struct Standing {
    std::size_t bullet_rows = 0;
    std::size_t beaten = 0;    ///< of them: some row of scree's takes no longer and is no less exact
    bool best_beaten = false;  ///< the most exact of Bullet's
    std::string verdict;
};
Standing standing(const std::vector<Work>& work);

}  // namespace scree
