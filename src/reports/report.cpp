#include <scree/reports/report.hpp>

#include <algorithm>

#include "about.hpp"
#include "accuracy.hpp"
#include "cost.hpp"
#include "pages.hpp"
#include "stability.hpp"

namespace scree {

namespace {

void append(std::vector<Case>& all, std::vector<Case> more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace

bool make_report(const ReportRequest& request, const ReportProgress& progress) {
    const std::vector<Row> about = about_report(request.quick);
    open_folder(request.out, about);
    std::vector<Case> cases;
    if (request.accuracy) {
        append(cases, accuracy_cases(request));
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
    write_pages(request.out, accuracy_problems(request.quick), about);
    return finished;
}

}  // namespace scree
