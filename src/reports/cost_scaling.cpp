// Time and memory against the number of bodies, of vertices of a mesh, and of threads.

#include <cmath>
#include <memory>
#include <random>

#include <scree/mesh/mass_properties.hpp>

#include "cost.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

const Row columns = {"by",          "value",    "method", "seconds_per_step", "us_per_contact",
                     "us_per_body", "contacts", "bodies", "bytes_per_body",   "bytes_per_contact",
                     "steps",       "status"};
const Row keys = {"by", "value", "method"};

constexpr double size = 0.05;  // [m]
constexpr double near = 1.6;   // spacing over the size at which some icosahedra touch
constexpr double far = 3;

Quat random_turn(std::mt19937_64& random) {
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1; };
    const Eigen::Vector4d q(uniform(), uniform(), uniform(), uniform());
    return Quat(q.normalized());
}

/// What is varied, the scene, and the same scene with nothing in touch.
struct Sample {
    std::string by;
    std::string value;
    SceneDescription scene;
    SceneDescription apart;
    std::size_t threads = 1;
};

Row sample_row(const Sample& sample, const MethodChoice& method, const Budget& budget) {
    const Expense expense = expense_of(sample.scene, {sample.threads, false, {}, 2}, budget);
    const Expense apart = expense_of(sample.apart, {sample.threads, false, {}, 0}, budget);
    SceneDescription alone = sample.apart;
    alone.bodies.resize(1);
    const double base = expense_of(alone, {sample.threads, false, {}, 0}, budget).bytes;
    const double steps = static_cast<double>(std::max<std::size_t>(1, expense.report.steps.accepted));
    const double contacts = static_cast<double>(expense.report.most_contacts);
    const double bodies = static_cast<double>(std::max<std::size_t>(1, expense.bodies));
    const double each = expense.seconds / steps;
    return {sample.by,
            sample.value,
            method.name(),
            cell(each),
            contacts > 0 ? cell(1e6 * each / contacts) : "",
            cell(1e6 * each / bodies),
            cell(contacts),
            cell(bodies),
            cell((apart.bytes - base) / std::max(1.0, bodies - 1)),
            contacts > 0 ? cell((expense.bytes - apart.bytes) / contacts) : "",
            cell(steps),
            expense.finished ? "done" : expense.message};
}

Sample sample_of(const std::string& by, double value, std::size_t count, const ShapeDescription& shape) {
    return {by, cell(value), lattice(count, shape, near * size, true),
            lattice(count, shape, far * size, true)};
}

std::vector<Sample> samples(const ReportRequest& request) {
    const bool quick = request.quick;
    std::vector<Sample> all;
    const MeshShape icosahedron = shipped_mesh("icosahedron", size);
    for (const std::size_t count : {10U, 100U, 1000U, 10000U}) {
        if (wanted(request, "bodies") && (!quick || count < 10000)) {
            all.push_back(sample_of("bodies", static_cast<double>(count), count, icosahedron));
        }
    }
    for (const int points : {8, 12, 50, 200, 1000, 2500}) {
        if (wanted(request, "vertices") && (!quick || points < 1000)) {
            MeshShape stone;
            stone.file = std::filesystem::absolute(write_round_stone(request.out, points));
            stone.scale = Vec3::Constant(2 * size);
            all.push_back(sample_of("vertices", points, 64, stone));
        }
    }
    for (const std::size_t threads : {1U, 2U, 4U}) {
        if (wanted(request, "threads")) {
            all.push_back(
                sample_of("threads", static_cast<double>(threads), quick ? 1000 : 300, icosahedron));
            all.back().threads = threads;
        }
    }
    return all;
}

}  // namespace

SceneDescription lattice(std::size_t count, const ShapeDescription& shape, double spacing, bool turned) {
    SceneDescription scene = bare_scene("lattice", 1e-3, 2);
    scene.gravity.setZero();
    scene.materials["rock"].youngs_modulus = 1e7;
    scene.shapes["stone"] = shape;
    std::mt19937_64 random(1);
    const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count)) - 1e-9));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place(static_cast<double>(i % side), static_cast<double>(i / side % side),
                         static_cast<double>(i / side / side));
        BodyDescription& body = add_body(scene, "stone", spacing * place);
        if (turned) {
            body.orientation = random_turn(random);
        }
    }
    return scene;
}

Table scaling_table(const std::filesystem::path& folder) {
    return {folder / "scaling.csv", columns, keys};
}

std::vector<Case> scaling_cases(const ReportRequest& request) {
    const Budget budget{request.quick ? 3.0 : 60.0};
    const auto table = std::make_shared<Table>(scaling_table(request.out));
    std::vector<Case> cases;
    for (const Sample& sample : samples(request)) {
        for (const MethodChoice& method :
             {explicit_method(SteppingMethod::verlet, 5e-5), fixed_bdf(2, 2e-4, Solver::newton)}) {
            const bool too_long = request.quick && method.by_bdf() && sample.scene.bodies.size() > 100;
            if (too_long || table->has({sample.by, sample.value, method.name()})) {
                continue;
            }
            Sample with = sample;
            method.apply(with.scene);
            method.apply(with.apart);
            cases.push_back({"scaling with " + sample.by + ", " + sample.value + ": " + method.text(), [=] {
                                 const Isolated answer =
                                     isolated_row([&] { return sample_row(with, method, budget); }, budget);
                                 Row row(columns.size());
                                 row[0] = with.by;
                                 row[1] = with.value;
                                 row[2] = method.name();
                                 row.back() = answer.message;
                                 table->add(answer.done ? answer.row : row);
                             }});
        }
    }
    return cases;
}

}  // namespace scree
