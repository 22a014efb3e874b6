#pragma once

#include "observation.hpp"

namespace scree {

/// What the force model says comes out, as far as it is known.
struct Reference {
    std::vector<Values> samples;  ///< at the problem's output times, or at its end; empty: not known
    double agreement = 0;         ///< largest difference of the methods that were asked; 0 in closed form
    double model_error = 0;       ///< largest difference from the rigid outcome; NaN where there is none

    [[nodiscard]] bool known() const { return !samples.empty(); }
};

/// Samples as one cell of a table, exactly, and back.
std::string packed_samples(const std::vector<Values>& samples);
std::vector<Values> unpacked_samples(const std::string& text);

/// The table of what the methods that a reference asks have answered.
Table reference_table(const std::filesystem::path& folder);
/// What it says of the case, as a row of that table.
Row reference_row(const Problem& problem, const MethodChoice& method, const Budget& budget);

/// From the closed form, or from the rows of the table.
Reference reference_of(const Problem& problem, const Table& table);

/// The times at which a problem is looked at [s].
std::vector<double> looking_times(const Problem& problem);

/// Largest difference over all samples.
Difference largest_difference(const std::vector<Values>& a, const std::vector<Values>& b);
/// The rigid outcome at the problem's times; empty where there is none.
std::vector<Values> rigid_samples(const Problem& problem);

}  // namespace scree
