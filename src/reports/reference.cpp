#include "reference.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include <scree/output/csv_file.hpp>

namespace scree {

namespace {

const Row columns = {"problem", "method", "step", "rtol", "settings", "status", "seconds", "samples"};
const Row keys = {"problem", "method", "step", "rtol", "settings"};

std::vector<Values> at_times(const Problem& problem, const std::function<Values(double)>& outcome) {
    std::vector<Values> samples;
    for (const double time : looking_times(problem)) {
        samples.push_back(outcome(time));
    }
    return samples;
}

/// Every answer that the table has.
std::vector<std::vector<Values>> answers(const Problem& problem, const Table& table) {
    std::vector<std::vector<Values>> all;
    for (const Row& row : table.rows()) {
        if (table.at(row, "problem") == problem.name && table.at(row, "status") == "done") {
            all.push_back(unpacked_samples(table.at(row, "samples")));
        }
    }
    return all;
}

std::vector<Values> mean_of(const std::vector<std::vector<Values>>& all) {
    std::vector<Values> mean = all.front();
    for (std::size_t s = 0; s < mean.size(); ++s) {
        for (std::size_t q = 0; q < mean[s].size(); ++q) {
            double sum = 0;
            for (const std::vector<Values>& each : all) {
                sum += each[s][q];
            }
            mean[s][q] = sum / static_cast<double>(all.size());
        }
    }
    return mean;
}

Reference agreed(const Problem& problem, const std::vector<std::vector<Values>>& all) {
    Reference reference;
    if (all.size() < 2) {
        return reference;  // one method alone proves nothing
    }
    reference.samples = problem.chaotic ? mean_of(all) : all.front();
    for (const std::vector<Values>& each : all) {
        reference.agreement =
            std::max(reference.agreement, largest_difference(each, reference.samples).value);
    }
    return reference;
}

}  // namespace

std::vector<double> looking_times(const Problem& problem) {
    const OutputTimes times(problem.scene.output.every, problem.scene.end_time);
    std::vector<double> result;
    for (std::int64_t i = problem.last_only ? times.last() : 1; i <= times.last(); ++i) {
        result.push_back(times.at(i));
    }
    return result;
}

std::string packed_samples(const std::vector<Values>& samples) {
    std::string text;
    for (const Values& sample : samples) {
        text += text.empty() ? "" : "; ";
        for (std::size_t i = 0; i < sample.size(); ++i) {
            text += i == 0 ? "" : " ";
            append_number(text, sample[i]);
        }
    }
    return text;
}

std::vector<Values> unpacked_samples(const std::string& text) {
    std::vector<Values> samples;
    std::istringstream all(text);
    for (std::string part; std::getline(all, part, ';');) {
        std::istringstream numbers(part);
        Values& sample = samples.emplace_back();
        for (double value = 0; numbers >> value;) {
            sample.push_back(value);
        }
    }
    return samples;
}

Table reference_table(const std::filesystem::path& folder) {
    return {folder / "references.csv", columns, keys};
}

Row reference_row(const Problem& problem, const MethodChoice& method, const Budget& budget) {
    const Observation seen = observe_run(problem, method, budget);
    return {problem.name,       method.name(),
            method.step(),      method.rtol(),
            method.settings(),  seen.finished ? "done" : seen.message,
            cell(seen.seconds), packed_samples(seen.samples)};
}

std::vector<Values> rigid_samples(const Problem& problem) {
    return problem.rigid ? at_times(problem, problem.rigid) : std::vector<Values>();
}

Reference reference_of(const Problem& problem, const Table& table) {
    Reference reference;
    if (problem.model) {
        reference.samples = at_times(problem, problem.model);
    } else {
        reference = agreed(problem, answers(problem, table));
    }
    reference.model_error = reference.known() && problem.rigid
                                ? largest_difference(reference.samples, rigid_samples(problem)).value
                                : std::numeric_limits<double>::quiet_NaN();
    return reference;
}

Difference largest_difference(const std::vector<Values>& a, const std::vector<Values>& b) {
    Difference largest;
    for (std::size_t s = 0; s < std::min(a.size(), b.size()); ++s) {
        const Difference here = largest_difference(a[s], b[s]);
        if (!(here.value <= largest.value)) {
            largest = here;
        }
    }
    return largest;
}

}  // namespace scree
