// Time by stage and by contact, for scenes that come with scree and more.

#include <memory>

#include "cost.hpp"
#include "problem.hpp"

namespace scree {

namespace {

const Row columns = {"scene",
                     "method",
                     "step",
                     "rtol",
                     "seconds",
                     "detection",
                     "contacts",
                     "jacobian",
                     "solve",
                     "other",
                     "steps",
                     "evaluations",
                     "us_per_evaluation",
                     "most_contacts",
                     "us_per_contact_step",
                     "status"};
const Row keys = {"scene", "method", "step", "rtol"};

Row stage_row(const Problem& problem, const MethodChoice& method, const Budget& budget) {
    SceneDescription scene = problem.scene;
    method.apply(scene);
    const Expense expense = expense_of(scene, {}, budget);
    const StepReport& report = expense.report;
    const SteppingStatistics& all = report.all_steps;
    const double contacts =
        static_cast<double>(report.most_contacts * std::max<std::size_t>(1, report.steps.accepted));
    const double evaluations = static_cast<double>(std::max<std::size_t>(1, all.contact_evaluations));
    const double named = report.times.detection + all.contact_time + all.jacobian_time + all.solve_time;
    return {problem.name,
            method.name(),
            method.step(),
            method.rtol(),
            cell(expense.seconds),
            cell(report.times.detection),
            cell(all.contact_time),
            cell(all.jacobian_time),
            cell(all.solve_time),
            cell(std::max(0.0, report.times.detection + report.times.stepping - named)),
            std::to_string(report.steps.accepted),
            std::to_string(all.contact_evaluations),
            cell(1e6 * (all.contact_time + all.jacobian_time) / evaluations),
            std::to_string(report.most_contacts),
            cell(contacts > 0 ? 1e6 * expense.seconds / contacts : 0),
            expense.finished ? "done" : expense.message};
}

}  // namespace

Table stages_table(const std::filesystem::path& folder) {
    return {folder / "stages.csv", columns, keys};
}

std::vector<Case> stage_cases(const ReportRequest& request) {
    const Budget budget{request.quick ? 2.0 : 20.0};
    const auto table = std::make_shared<Table>(stages_table(request.out));
    std::vector<Case> cases;
    if (!wanted(request, "stages")) {
        return cases;
    }
    for (const Problem& problem :
         {incline_problem(), stack_problem(request.quick), pile_problem(request.quick)}) {
        for (const MethodChoice& method :
             {adaptive_bdf(2, 1e-2), adaptive_bdf(2, 1e-4), explicit_method(SteppingMethod::verlet, 1e-5)}) {
            if (!table->has({problem.name, method.name(), method.step(), method.rtol()})) {
                cases.push_back({"stages of " + problem.name + ": " + method.text(), [=] {
                                     const Isolated answer = isolated_row(
                                         [&] { return stage_row(problem, method, budget); }, budget);
                                     Row row(columns.size());
                                     row[0] = problem.name;
                                     row[1] = method.name();
                                     row[2] = method.step();
                                     row[3] = method.rtol();
                                     row.back() = answer.message;
                                     table->add(answer.done ? answer.row : row);
                                 }});
            }
        }
    }
    return cases;
}

}  // namespace scree
