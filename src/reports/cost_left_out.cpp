// Pairs of scenes that differ in one need: what enters, what is stored and what it takes, with it and
// without.

#include <cmath>
#include <memory>

#include <scree/scenes/features.hpp>

#include "build_facts.hpp"
#include "cost.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

const Row columns = {"need",        "side",          "seconds",         "loading",        "bytes",
                     "written",     "newton",        "jacobians",       "factorizations", "functional",
                     "evaluations", "pair_searches", "pairs_by_bullet", "entered",        "libraries",
                     "status"};
const Row keys = {"need", "side"};

constexpr double edge = 0.05;  // [m]

/// Thirty-six cubes, each on its own, pushed over the floor.
SceneDescription pushed_cubes(const ShapeDescription& shape) {
    SceneDescription scene = bare_scene("pushed", 0.2, 10);
    scene.materials["rock"].youngs_modulus = 1e9;
    scene.shapes["stone"] = shape;
    add_floor(scene);
    for (int i = 0; i < 36; ++i) {
        BodyDescription& body = add_body(scene, "stone", Vec3(0.2 * (i % 6), 0.2 * (i / 6), edge / 2));
        body.velocity = 0.3 * odd_direction();
    }
    return scene;
}

/// A need, and the scene with it and without.
struct Pair {
    std::string need;
    SceneDescription with;
    SceneDescription without;
    bool write = false;
};

Pair same(const std::string& need, const ShapeDescription& shape = shipped_mesh("cube", edge)) {
    return {need, pushed_cubes(shape), pushed_cubes(shape)};
}

Pair materials_pair() {
    Pair pair = same("several materials");
    pair.with.materials["other"] = pair.with.materials["rock"];
    pair.with.materials["other"].friction = 0.4;
    PairDescription entry;
    entry.materials = {"rock", "other"};
    entry.friction = 0.3;
    pair.with.pairs.push_back(entry);
    for (std::size_t i = 1; i < pair.with.bodies.size(); i += 2) {
        pair.with.bodies[i].material = "other";
    }
    return pair;
}

/// Balls without friction do not turn: there is no moment. Their unknowns stay.
Pair rotation_pair() {
    Pair pair = same("rotation", Sphere{edge / 2});
    pair.without.law.friction = FrictionLaw::none;
    pair.with.law.friction = FrictionLaw::none;
    for (std::size_t i = 1; i < pair.with.bodies.size(); ++i) {
        pair.with.bodies[i].angular_velocity = Vec3(3, 2, 1);
    }
    return pair;
}

Pair sleep_pair() {
    Pair pair = same("bodies that are awake");
    for (SceneDescription* scene : {&pair.with, &pair.without}) {
        scene->end_time = 4;
        scene->output.every = 0.02;
    }
    pair.without.stepping.sleep = true;
    return pair;
}

std::vector<Pair> pairs() {
    std::vector<Pair> all;
    all.push_back(same("friction"));
    all.back().without.law.friction = FrictionLaw::none;
    all.push_back(same("damping"));
    all.back().without.materials["rock"].normal_damping = 0;
    all.back().without.materials["rock"].tangential_damping = 0;
    all.push_back(same("torsion"));
    all.back().without.materials["rock"].torsion = false;
    all.push_back({"polyhedra", pushed_cubes(shipped_mesh("icosahedron", edge / 1.618)),
                   pushed_cubes(Sphere{edge / 2})});
    all.push_back(rotation_pair());
    all.push_back(materials_pair());
    all.push_back(same("output"));
    all.back().write = true;
    all.push_back({"mesh files", pushed_cubes(shipped_mesh("cube", edge)),
                   pushed_cubes(BoxShape{Vec3::Constant(edge)})});
    all.push_back(same("stiff contacts"));
    all.back().without.materials["rock"].youngs_modulus = 2e4;
    all.push_back(sleep_pair());
    return all;
}

std::string words(const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& word : all) {
        text.append(text.empty() ? "" : " ").append(word);
    }
    return text;
}

Row side_row(const Pair& pair, bool with, const std::filesystem::path& folder, const Budget& budget) {
    const SceneDescription& scene = with ? pair.with : pair.without;
    const Expense expense = expense_of(scene, {1, with && pair.write, folder, 5}, budget);
    const SteppingStatistics& all = expense.report.all_steps;
    return {pair.need,
            with ? "with" : "without",
            cell(expense.seconds),
            cell(expense.loading),
            cell(expense.bytes),
            std::to_string(expense.files),
            std::to_string(all.newton.iterations),
            std::to_string(all.newton.jacobians),
            std::to_string(all.newton.factorizations),
            std::to_string(all.newton.functional_iterations),
            std::to_string(all.contact_evaluations),
            std::to_string(expense.report.pair_searches),
            std::to_string(expense.report.manifold_pairs),
            words(scene_features(scene).used),
            mapped_libraries(),
            expense.finished ? "done" : expense.message};
}

}  // namespace

Table left_out_table(const std::filesystem::path& folder) {
    return {folder / "left_out.csv", columns, keys};
}

Table libraries_table(const std::filesystem::path& folder) {
    Table table(folder / "libraries.csv", {"component", "links"}, {"component"});
    for (const auto& [component, links] : component_links) {
        if (!table.has({component})) {
            table.add({component, links});
        }
    }
    return table;
}

std::vector<Case> left_out_cases(const ReportRequest& request) {
    const Budget budget{request.quick ? 2.0 : 10.0};
    const auto table = std::make_shared<Table>(left_out_table(request.out));
    std::vector<Case> cases;
    if (!wanted(request, "left_out")) {
        return cases;
    }
    for (const Pair& pair : pairs()) {
        for (const bool with : {true, false}) {
            const std::string side = with ? "with" : "without";
            if (!table->has({pair.need, side})) {
                cases.push_back({"left out: " + side + " " + pair.need, [=, out = request.out] {
                                     const Isolated answer = isolated_row(
                                         [&] { return side_row(pair, with, out, budget); }, budget);
                                     Row row(columns.size());
                                     row[0] = pair.need;
                                     row[1] = side;
                                     row.back() = answer.message;
                                     table->add(answer.done ? answer.row : row);
                                 }});
            }
        }
    }
    return cases;
}

}  // namespace scree
