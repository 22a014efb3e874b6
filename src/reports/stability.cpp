#include "stability.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include "reference.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

const Row columns = {"axis",
                     "value",
                     "method",
                     "step",
                     "rtol",
                     "settings",
                     "status",
                     "number",
                     "decided_by",
                     "limit",
                     "told",
                     "energy_residual",
                     "energy_invented",
                     "momentum_residual",
                     "largest_overlap",
                     "reached",
                     "seconds"};
const Row keys = {"axis", "value", "method", "step", "rtol", "settings"};

constexpr double gone = 1;               // an error of a body's size or all of a velocity: nothing is right
constexpr double invented = 0.1;         // of the scale of energies
constexpr double clear_residual = 0.01;  // that the run's own account shows

Row row_keys(const Extreme& extreme, const MethodChoice& method) {
    return {extreme.axis, extreme.value, method.name(), method.step(), method.rtol(), method.settings()};
}

/// What energies [J] and momenta [kg m/s] are measured by: what the scene starts with, and a fall of every
/// body by its size.
struct Scales {
    double energy = 0;
    double momentum = 0;
    double start = 0;  ///< kinetic and gravity energy at first [J]
};

Scales scales_of(const Simulation& simulation) {
    Scales scales;
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        const SimulationBody& body = simulation.bodies()[i];
        if (!body.dynamic()) {
            continue;
        }
        const double mass = simulation.scene().materials.at(body.material).density * body.solid.volume;
        const double size = std::cbrt(body.solid.volume);
        const FrameMotion motion = simulation.body_motion(i);
        const Vec3 spin = motion.pose.orientation.conjugate() * motion.angular_velocity;
        const double density = mass / body.solid.volume;
        const double kinetic = 0.5 * mass * motion.velocity.squaredNorm() +
                               0.5 * density * body.solid.inertia.dot(spin.cwiseAbs2());
        const double gravity = simulation.scene().gravity.norm();
        const bool resting = gravity == 0 && motion.velocity.isZero() && motion.angular_velocity.isZero();
        const double fall = (resting ? earth_gravity : gravity) * size;
        scales.energy += kinetic + mass * fall;
        scales.momentum += mass * (motion.velocity.norm() + std::sqrt(fall));
        scales.start += kinetic - mass * simulation.scene().gravity.dot(motion.pose.position);
    }
    return scales;
}

double lost(const EnergyLedger& energy) {
    return energy.lost_normal_damping + energy.lost_tangential_damping + energy.lost_friction;
}

/// The run's accounts over their scales.
struct Accounts {
    double residual = 0;
    double invented = 0;
    double momentum = 0;
};

Accounts accounts_of(const Observation& seen, const MethodChoice& method, const Scales& scales) {
    const EnergyLedger& energy = seen.report.energy;
    Accounts accounts;
    if (method.by_bullet()) {
        const double gained = energy.kinetic + energy.gravity - scales.start;
        accounts.residual = accounts.momentum = std::numeric_limits<double>::quiet_NaN();  // it keeps none
        accounts.invented =
            std::max(0.0, gained) / std::max(scales.energy, std::numeric_limits<double>::min());
        return accounts;
    }
    const double start = energy.held() + lost(energy) - energy.work_applied - energy.residual;
    // What is stored at first is known against a half-space alone; else what came of it says how much it was.
    const double stored =
        std::max(0.0, start - scales.start) + std::abs(energy.normal_elastic) + lost(energy);
    const double scale = std::max(scales.energy + stored, std::numeric_limits<double>::min());
    accounts.residual = energy.residual / scale;
    accounts.invented = std::max(0.0, energy.residual - lost(energy)) / scale;
    accounts.momentum =
        seen.report.momentum_residual.norm() / std::max(scales.momentum, std::numeric_limits<double>::min());
    return accounts;
}

std::string told(const Observation& seen, const Accounts& accounts) {
    if (!seen.finished) {
        return seen.message;
    }
    return std::abs(accounts.residual) > clear_residual ? "energy residual" : "";
}

std::vector<Values> expected(const Extreme& extreme, const MethodChoice& method, const Budget& budget) {
    if (extreme.twin) {
        return observe_run(*extreme.twin, method, budget).samples;
    }
    std::vector<Values> samples;
    for (const double time : looking_times(extreme.problem)) {
        samples.push_back(extreme.problem.model(time));
    }
    return samples;
}

/// The status and what decided it.
struct Verdict {
    std::string status;
    double number = 0;
    std::string by;
};

Verdict verdict_of(const Extreme& extreme, const Observation& seen, const std::vector<Values>& wanted,
                   const Accounts& accounts) {
    if (!seen.finished) {
        const bool slow = seen.message.starts_with("stopped");
        return {slow ? "stopped" : "failed", seen.reached, slow ? "time" : "reached"};
    }
    if (wanted.size() != seen.samples.size()) {
        return {"failed", 0, "its twin does not finish"};
    }
    if (!(accounts.invented < invented)) {
        return {"failed", accounts.invented, "energy invented"};
    }
    const Difference error = largest_difference(seen.samples, wanted);
    const bool right = error.value <= extreme.limit;
    return {right                 ? "stable"
            : error.value <= gone ? "inaccurate"
                                  : "failed",
            error.value, extreme.problem.quantities[error.quantity]};
}

Row measured(const Extreme& extreme, const MethodChoice& method, const Budget& budget) {
    SceneDescription scene = extreme.problem.scene;
    method.apply(scene);
    const Scales scales = scales_of(Simulation(scene));
    const Observation seen = observe_run(extreme.problem, method, budget);
    const Accounts accounts = accounts_of(seen, method, scales);
    const Verdict verdict = verdict_of(extreme, seen, expected(extreme, method, budget), accounts);
    Row row = row_keys(extreme, method);
    row.insert(row.end(),
               {verdict.status, cell(verdict.number), verdict.by, cell(extreme.limit), told(seen, accounts),
                cell(accounts.residual), cell(accounts.invented), cell(accounts.momentum),
                cell(seen.report.largest_overlap), cell(seen.reached), cell(seen.seconds)});
    return row;
}

}  // namespace

Table stability_table(const std::filesystem::path& folder) {
    return {folder / "stability.csv", columns, keys};
}

Row stability_row(const Extreme& extreme, const MethodChoice& method, const Budget& budget) {
    const Isolated answer = isolated_row([&] { return measured(extreme, method, budget); }, budget);
    if (answer.done) {
        return answer.row;
    }
    Row row = row_keys(extreme, method);
    row.insert(row.end(), {"failed", "", answer.message, cell(extreme.limit), "", "", "", "", "", "", ""});
    return row;
}

std::vector<Extreme> extremes(const std::filesystem::path& folder, bool quick) {
    std::vector<Extreme> all;
    add_settling(all, quick);
    add_shapes(all, folder, quick);
    add_contact_laws(all, quick);
    add_impacts(all, quick);
    return all;
}

std::vector<MethodChoice> stability_methods(double end_time, bool quick) {
    const double fine = end_time / (quick ? 2e4 : 2e5);
    std::vector<MethodChoice> methods = {adaptive_bdf(1, 1e-3),
                                         adaptive_bdf(2, 1e-3),
                                         adaptive_bdf(5, 1e-3),
                                         fixed_bdf(2, end_time / 1000),
                                         explicit_method(SteppingMethod::symplectic_euler, fine),
                                         explicit_method(SteppingMethod::verlet, fine),
                                         bullet_method(std::min(1.0 / 240, end_time / 10), 10),
                                         bullet_at_best(std::min(1e-3, end_time / 50), 50)};
    return methods;
}

std::vector<Case> stability_cases(const ReportRequest& request) {
    const Budget budget{request.quick ? 0.5 : 4.0};
    const auto table = std::make_shared<Table>(stability_table(request.out));
    std::vector<Case> cases;
    for (const Extreme& extreme : extremes(request.out, request.quick)) {
        if (!wanted(request, extreme.axis)) {
            continue;
        }
        std::vector<MethodChoice> methods = extreme.methods;
        if (methods.empty()) {
            methods = stability_methods(extreme.problem.scene.end_time, request.quick);
        }
        for (const MethodChoice& method : methods) {
            if (!table->has(row_keys(extreme, method))) {
                cases.push_back({extreme.axis + " " + extreme.value + ": " + method.text(),
                                 [=] { table->add(stability_row(extreme, method, budget)); }});
            }
        }
    }
    return cases;
}

}  // namespace scree
