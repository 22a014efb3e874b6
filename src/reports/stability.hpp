#pragma once

#include <filesystem>
#include <optional>

#include "case.hpp"
#include "observation.hpp"

namespace scree {

// What stiff and extreme cases do to every method.

/// A case of the stability table: a scene of which it is known how it must end.
struct Extreme {
    std::string axis;   ///< what is varied
    std::string value;  ///< to what
    Problem problem;
    double limit = 1e-2;                  ///< an error above it is inaccurate
    std::vector<MethodChoice> methods{};  ///< empty: the usual ones
    std::optional<Problem> twin{};  ///< must come out alike, by the same method, in place of a known end
};

/// What they vary, for `only`.
constexpr const char* axes[] = {"Y [Pa]",
                                "step",
                                "size [m]",
                                "gravity [g]",
                                "origin [m]",
                                "units",
                                "sliver plate",
                                "sliver needle",
                                "faces",
                                "stack",
                                "mass ratio",
                                "aligned",
                                "friction",
                                "damping [critical]",
                                "spin [rad/s]",
                                "spin on the floor [rad/s]",
                                "speed at a thin wall [m/s]",
                                "overlap [size]"};

/// All of them.
std::vector<Extreme> extremes(const std::filesystem::path& folder, bool quick);

// By what is varied, each group in a file of its own.
void add_settling(std::vector<Extreme>& all, bool quick);
void add_shapes(std::vector<Extreme>& all, const std::filesystem::path& folder, bool quick);
void add_contact_laws(std::vector<Extreme>& all, bool quick);
void add_impacts(std::vector<Extreme>& all, bool quick);

/// A body let go a little above the floor, slightly tilted, which must come to rest on it.
struct Settling {
    double edge = 0.1;                      ///< [m], of the cube, or the scale of the mesh
    double gravity = 9.81;                  ///< [m/s²]
    double youngs_modulus = 1e9;            ///< [Pa]
    double density = 2600;                  ///< [kg/m³]
    Vec3 place = Vec3::Zero();              ///< [m], of the floor's origin
    std::optional<ShapeDescription> shape;  ///< in place of the cube
};
Problem settling_problem(const Settling& settling);

/// status: stable, inaccurate or failed; number and decided_by say why. told: what the run itself says of it.
Table stability_table(const std::filesystem::path& folder);
/// method, Y and the greatest step with which a cube stays at rest.
Table stable_steps_table(const std::filesystem::path& folder);

/// The methods, with steps that fit the time that a case takes [s].
std::vector<MethodChoice> stability_methods(double end_time, bool quick);

Row stability_row(const Extreme& extreme, const MethodChoice& method, const Budget& budget);
std::vector<Case> stability_cases(const ReportRequest& request);
std::vector<Case> stable_step_cases(const ReportRequest& request);

}  // namespace scree
