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
    std::string scene;        ///< its name
    std::string status;       ///< done, interrupted or failed
    std::string message;      ///< why, when failed
    double end_time = 0;      ///< [s], of the scene
    double reached = 0;       ///< [s]
    std::size_t threads = 1;  ///< that shared out the work

    /// Wall time [s] by stage.
    struct Times {
        double wall = 0;       ///< all of it
        double detection = 0;  ///< of candidate pairs
        double contacts = 0;   ///< evaluated without derivatives
        double jacobian = 0;   ///< contacts evaluated with derivatives, and the assembly
        double solve = 0;      ///< factorisations and their use
        double output = 0;     ///< writing files
    } time;                    ///< of the run

    /// Of the group with the most.
    struct Steps {
        std::size_t accepted = 0,  ///< steps
            rejected_error = 0,    ///< the error test failed
            rejected_newton = 0,   ///< the equations were not solved
            rejected_contact = 0;  ///< a body left the region that its candidate pairs cover
    } steps;                       ///< of the run

    std::optional<double> smallest_step,  ///< [s], of those accepted
        mean_step,                        ///< [s]
        largest_step;                     ///< [s]
    std::vector<std::size_t> orders;      ///< accepted steps of order 1, 2, …
    /// What solving the equations took.
    struct Newton {
        std::size_t iterations = 0,         ///< of Newton's method
            jacobians = 0,                  ///< assembled
            factorizations = 0;             ///< of the Jacobian
    } newton;                               ///< in all steps
    std::size_t functional_iterations = 0;  ///< of the functional corrector

    std::size_t contact_evaluations = 0;  ///< of one contact each
    std::size_t contacts_now = 0,         ///< that touch at the end
        contacts_most = 0;                ///< that touched at the end of a tick
    double largest_overlap = 0;           ///< depth over body size

    EnergyLedger energy;           ///< [J], at the end
    double momentum_residual = 0;  ///< [kg m/s]

    std::vector<std::string> used,   ///< features, as Features has them
        left_out;                    ///< all others
    std::vector<BodyRecord> bodies;  ///< at the end, in scene order
};

/// The text of summary.json.
std::string summary_json(const RunSummary& summary);

/// Whether a summary.json says that its run is done and has reached the scene's end. One that cannot be read
/// does not.
bool is_finished(const std::filesystem::path& file);

}  // namespace scree
