#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/dynamics/energy.hpp>
#include <scree/output/body_record.hpp>

namespace scree {

/// What summary.json says of a run. What has no value is written as null.
struct RunSummary {
    std::string scene;
    std::string status;   ///< done, interrupted or failed
    std::string message;  ///< why, when failed
    double end_time = 0;  ///< [s], of the scene
    double reached = 0;   ///< [s]
    std::size_t threads = 1;

    /// Wall time [s] by stage.
    struct Times {
        double wall = 0;
        double detection = 0;
        double contacts = 0;  ///< evaluated without derivatives
        double jacobian = 0;  ///< contacts evaluated with derivatives, and the assembly
        double solve = 0;     ///< factorisations and their use
        double output = 0;
    } time;

    /// Of the group with the most.
    struct Steps {
        std::size_t accepted = 0, rejected_error = 0, rejected_newton = 0, rejected_contact = 0;
    } steps;

    std::optional<double> smallest_step, mean_step, largest_step;  ///< [s], of those accepted
    std::vector<std::size_t> orders;                               ///< accepted steps of order 1, 2, …
    /// What solving the equations took.
    struct Newton {
        std::size_t iterations = 0, jacobians = 0, factorizations = 0;
    } newton;
    std::size_t functional_iterations = 0;

    std::size_t contact_evaluations = 0;
    std::size_t contacts_now = 0, contacts_most = 0;
    double largest_overlap = 0;  ///< depth over body size

    EnergyLedger energy;
    double momentum_residual = 0;  ///< [kg m/s]

    std::vector<std::string> used, left_out;
    std::vector<BodyRecord> bodies;
};

/// The text of summary.json.
std::string summary_json(const RunSummary& summary);

/// Whether a summary.json says that its run is done and has reached the scene's end. One that cannot be read
/// does not.
bool is_finished(const std::filesystem::path& file);

}  // namespace scree
