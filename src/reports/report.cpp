#include <scree/reports/report.hpp>

#include <algorithm>

#include <scree/scenes/scene_error.hpp>

#include "about.hpp"
#include "accuracy.hpp"
#include "claims.hpp"
#include "cost.hpp"
#include "pages.hpp"
#include "scene_parts.hpp"
#include "stability.hpp"

namespace scree {

namespace {

void append(std::vector<Case>& all, std::vector<Case> more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
}

/// Every name that `only` may have.
std::vector<std::string> known_names(bool quick) {
    std::vector<std::string> names = {"claims",   "stable_steps", "stages",  "bodies",
                                      "vertices", "threads",      "left_out"};
    for (const Problem& problem : accuracy_problems(quick)) {
        names.push_back(problem.name);
    }
    names.insert(names.end(), std::begin(axes), std::end(axes));
    return names;
}

void check_names(const ReportRequest& request) {
    const std::vector<std::string> names = known_names(request.quick);
    std::string all;
    for (const std::string& name : names) {
        all += together({all.empty() ? "" : ", ", name});
    }
    for (const std::string& name : request.only) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throw SceneError(together({"--only ", name}), "no such problem, axis or table", all);
        }
    }
}

}  // namespace

bool make_report(const ReportRequest& request, const ReportProgress& progress) {
    check_names(request);
    const std::vector<Row> about = about_report(request.quick);
    open_folder(request.out, about);
    std::vector<Case> cases;
    if (request.accuracy) {
        append(cases, accuracy_cases(request));
        append(cases, claim_cases(request));
    }
    if (request.stability) {
        append(cases, stability_cases(request));
        append(cases, stable_step_cases(request));
    }
    if (request.cost) {
        append(cases, stage_cases(request));
        append(cases, scaling_cases(request));
        append(cases, left_out_cases(request));
        libraries_table(request.out);
    }
    std::size_t done = 0;
    bool finished = true;
    for (const Case& each : cases) {
        finished = progress(done, cases.size(), each.name);
        if (!finished) {
            break;
        }
        each.run();
        ++done;
    }
    std::filesystem::remove_all(meshes_folder(request.out));
    write_pages(request.out, accuracy_problems(request.quick), about);
    return finished;
}

}  // namespace scree
