#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scree/scenes/scene_description.hpp>
#include <scree/scenes/simulation.hpp>

#include "method.hpp"

namespace scree {

/// What is looked at, each in the unit that makes an error of one a large one.
using Values = std::vector<double>;

/// A scene whose outcome is known.
struct Problem {
    std::string name;     ///< of its scene
    std::string purpose;  ///< a sentence: what happens, what is compared, in which unit
    SceneDescription scene;
    std::vector<std::string> quantities;  ///< names of the values
    std::function<Values(const Simulation&)> observe;
    /// The outcome of rigid bodies under Coulomb's law, in closed form; null: there is none.
    std::function<Values(double time)> rigid;
    /// The outcome of the force model in closed form; null: two methods have to agree on it.
    std::function<Values(double time)> model;
    bool last_only = false;    ///< the end decides; else every output time does
    bool chaotic = false;      ///< single paths mean nothing: values are those of the whole
    bool no_bullet = false;    ///< what only a soft contact can do
    bool free_flight = false;  ///< nothing touches
    /// Where the model has no closed form: the first says what comes out, the others how far to trust it. Of
    /// a chaotic problem it is their mean.
    std::vector<MethodChoice> references;
};

/// A problem around a scene as bare_scene() makes it, with the same name.
Problem bare_problem(const std::string& name, double end_time, int looks);

/// The problems of the accuracy report, in order.
std::vector<Problem> accuracy_problems(bool quick);

// Each is in a file of its own.
Problem incline_problem();
Problem sliding_to_rest_problem();
Problem bounce_problem();
Problem free_top_problem(bool quick);
Problem stack_problem(bool quick);
Problem mass_ratio_problem();
Problem cradle_problem();
Problem rolling_problem();
Problem floating_block_problem();
Problem sliding_disc_problem();
Problem pile_problem(bool quick);

/// Cubes of 0.1 m of these masses [kg] on one another, from below, that start as they rest.
Problem standing_cubes(const std::string& name, double end_time, double youngs_modulus,
                       const std::vector<double>& masses);

/// Largest difference of two outcomes, and where.
struct Difference {
    double value = 0;  ///< NaN when one of them is
    std::size_t quantity = 0;
};
Difference largest_difference(const Values& a, const Values& b);

}  // namespace scree
