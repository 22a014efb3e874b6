#include "claims.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include <scree/overlap/overlap.hpp>
#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/incline.hpp>
#include <scree/scenes/read_scene.hpp>

#include "observation.hpp"
#include "run_clock.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

const Row columns = {"claim", "value", "unit", "how"};
constexpr double degree = std::numbers::pi / 180;

/// Blocks, grounds, directions, friction and stiffness at random, the same every time.
std::vector<Incline> inclines(int count) {
    const char* const meshes[] = {"cube", "hexagonal_prism", "flat_stone", "stone_a"};
    std::mt19937 random(1);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    std::vector<Incline> all;
    for (int i = 0; i < count; ++i) {
        Incline& incline = all.emplace_back();
        incline.mesh = shipped_mesh(meshes[i % 4], 1).file;
        if (i % 2 == 1) {
            incline.ground = shipped_mesh("slab", 1).file;
            incline.ground_scale = 20;
        }
        incline.turn_ground = i / 2 % 2 == 1;
        incline.azimuth = i < 4 ? 0 : uniform(0, 2 * std::numbers::pi);
        incline.turn = uniform(0, 2 * std::numbers::pi);
        incline.youngs_modulus = std::pow(10, uniform(8, 12));
        // A block must not tip before it slides.
        incline.friction = uniform(0.1, std::min(1.2, 0.6 * std::tan(tipping_angle(incline))));
    }
    return all;
}

Row row_of(const std::string& claim, double value, const std::string& unit, const std::string& how) {
    return {claim, cell(value), unit, how};
}

std::string cases_text(const std::vector<Incline>& all) {
    return together({"worst of ", std::to_string(all.size()),
                     " blocks, grounds, directions, frictions and stiffnesses at random"});
}

template <class Measure>
double worst_of(const std::vector<Incline>& all, const Measure& measure) {
    double worst = 0;
    for (const Incline& incline : all) {
        worst = std::max(worst, measure(incline));
    }
    return worst;
}

Row sliding_angle_row(const std::string& claim, bool quick) {
    const std::vector<Incline> all = inclines(quick ? 4 : 16);
    const double worst = worst_of(all, [](const Incline& incline) {
        return std::abs(measure_sliding_angle(incline, 1e-4 * degree).angle - sliding_angle(incline)) /
               degree;
    });
    return row_of(claim, worst, "degrees", cases_text(all) + ", by bisection to 1e-4 degrees");
}

Row creep_row(const std::string& claim, bool quick) {
    const std::vector<Incline> all = inclines(quick ? 4 : 16);
    const double worst = worst_of(all, [](const Incline& incline) {
        return run_incline(incline, 0.75 * sliding_angle(incline), 10).creep;
    });
    return row_of(claim, worst, "m", cases_text(all) + ", at three quarters of the angle, from 2 s to 10 s");
}

Row slip_row(const std::string& claim, bool quick) {
    const std::vector<Incline> all = inclines(quick ? 4 : 16);
    const double worst = worst_of(all, [](const Incline& incline) {
        const double slope = sliding_angle(incline) + 8 * degree;
        return std::abs(run_incline(incline, slope, 1).acceleration - sliding_acceleration(incline, slope)) /
               earth_gravity;
    });
    return row_of(claim, worst, "g", cases_text(all) + ", 8 degrees above the angle");
}

Row drift_row(const std::string& claim, bool quick) {
    const std::vector<Incline> all = inclines(quick ? 4 : 16);
    const double worst = worst_of(all, [](const Incline& incline) {
        const InclineRun run = run_incline(incline, sliding_angle(incline) + 8 * degree, 1);
        return std::abs(run.drift / run.slide);
    });
    return row_of(claim, worst, "of the slide", cases_text(all) + ", 8 degrees above the angle");
}

/// Microseconds of one overlap, derivatives included or not: the least of several times.
double overlap_time(const Shape& a, const Pose& pose_a, const Shape& b, Detail detail) {
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    constexpr int rounds = 3000;
    double least = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < 31; ++repetition) {
        RunClock clock;
        clock.start();
        for (int i = 0; i < rounds; ++i) {
            // Never twice the same, so that branches are not learnt by heart.
            const Pose pose{pose_a.position + Vec3(1e-4 * (i % 97), 1e-4 * (i % 89), 0), pose_a.orientation};
            overlap(a, pose, b, {}, detail, false, workspace, geometry);
        }
        clock.stop();
        least = std::min(least, 1e6 * clock.seconds() / rounds);
    }
    return least;
}

Row overlap_row(const std::string& claim, const Shape& a, const Pose& pose, const Shape& b, Detail detail) {
    return row_of(claim, overlap_time(a, pose, b, detail), "µs",
                  detail == Detail::force ? "least of several, one core" : "the same, with all derivatives");
}

/// The pile that comes with scree, until it is at rest.
Row pile_row(const std::string& claim) {
    Simulation simulation(read_scene(find_scene("pile")));
    RunClock clock;
    clock.start();
    while (simulation.tick() < simulation.times().last() && simulation.advance()) {
    }
    clock.stop();
    double speed = 0;
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        speed = std::max(speed, simulation.body_motion(b).velocity.norm());
    }
    const StepReport& report = simulation.report();
    return row_of(
        claim, speed, "m/s",
        together({"fastest stone at ", cell(simulation.time()), " s; ", cell(std::round(clock.seconds())),
                  " s for ", std::to_string(report.steps.accepted), " steps"}));
}

/// What is claimed, and how it is measured.
struct Claim {
    std::string name;
    std::function<Row(const std::string&)> measure;
};

std::vector<Claim> claims(bool quick) {
    const auto cube = std::make_shared<const Shape>(make_box(Vec3::Constant(1)));
    const std::shared_ptr<const Shape> stone = make_solid(shipped_mesh("icosahedron", 1), {}).shape;
    const Pose on_ground{Vec3(0, 0, 0.499), Quat::Identity()};
    const Pose on_cube{Vec3(0.2, 0.1, 0.999), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()))};
    const Pose beside{Vec3(0.2, 0.1, 1.5), Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
    std::vector<Claim> all = {
        {"sliding angle against atan μ",
         [=](const std::string& name) { return sliding_angle_row(name, quick); }},
        {"creep below the angle", [=](const std::string& name) { return creep_row(name, quick); }},
        {"acceleration in steady slip against g (sin θ − μ cos θ)",
         [=](const std::string& name) { return slip_row(name, quick); }},
        {"sideways drift in steady slip", [=](const std::string& name) { return drift_row(name, quick); }}};
    const std::tuple<const char*, std::shared_ptr<const Shape>, Pose, std::shared_ptr<const Shape>> pairs[] =
        {{"overlap of two icosahedra", stone, beside, stone},
         {"overlap of two cubes, face on face", cube, on_cube, cube},
         {"overlap of a cube and a half-space", cube, on_ground, std::make_shared<const Shape>(HalfSpace{})}};
    for (const auto& [name, a, pose, b] : pairs) {
        for (const Detail detail : {Detail::force, Detail::derivative}) {
            all.push_back({together({name, detail == Detail::force ? "" : ", with derivatives"}),
                           [a = a, pose = pose, b = b, detail](const std::string& claim) {
                               return overlap_row(claim, *a, pose, *b, detail);
                           }});
        }
    }
    if (!quick) {
        all.push_back({"pile of 100 mesh stones at rest", pile_row});
    }
    return all;
}

}  // namespace

Table claims_table(const std::filesystem::path& folder) {
    return {folder / "claims.csv", columns, {"claim"}};
}

std::vector<Case> claim_cases(const ReportRequest& request) {
    const Budget budget{request.quick ? 10.0 : 200.0};
    const auto table = std::make_shared<Table>(claims_table(request.out));
    std::vector<Case> cases;
    if (!wanted(request, "claims")) {
        return cases;
    }
    for (const Claim& claim : claims(request.quick)) {
        if (!table->has({claim.name})) {
            cases.push_back(
                {claim.name, [=] {
                     const Isolated answer = isolated_row([&] { return claim.measure(claim.name); }, budget);
                     table->add(answer.done ? answer.row : Row{claim.name, "", "", answer.message});
                 }});
        }
    }
    return cases;
}

}  // namespace scree
