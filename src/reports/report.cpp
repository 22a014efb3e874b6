#include <scree/reports/report.hpp>

#include <algorithm>

#include "about.hpp"
#include "accuracy.hpp"
#include "cost.hpp"
#include "stability.hpp"

namespace scree {

namespace {

void append(std::vector<Case>& all, std::vector<Case> more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace

bool make_report(const ReportRequest& request, const ReportProgress& progress) {
    open_folder(request.out, about_report(request.quick));
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
    for (const Case& each : cases) {
        if (!progress(done, cases.size(), each.name)) {
            return false;
        }
        each.run();
        ++done;
    }
    return true;
}

}  // namespace scree
