#include "comparison.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

Work work_of(const Table& table, const Row& row) {
    const std::string& method = table.at(row, "method");
    const std::string& step = table.at(row, "step");
    const std::string& settings = table.at(row, "settings");
    const bool adaptive = step == "adaptive";
    const std::string manner =
        adaptive ? together({"rtol ", table.at(row, "rtol")}) : together({"step ", step, " s"});
    const std::string tail = settings.empty() ? "" : together({"; ", settings});
    Work work;
    work.label = together({method, ", ", manner, tail});
    work.by_bullet = method == "bullet";
    const bool one_manner = work.by_bullet || !method.starts_with("bdf");
    const std::size_t best = tail.find("; separating");
    const std::string short_tail =
        best == std::string::npos ? tail : together({tail.substr(0, best), ", best"});
    work.family = together({method, one_manner ? "" : adaptive ? ", adaptive" : ", fixed", short_tail});
    work.seconds = table.number(row, "seconds");
    work.error = table.number(row, "error");
    work.numerical_error = table.number(row, "numerical_error");
    return work;
}

}  // namespace

std::vector<Work> finished_work(const Table& accuracy, const std::string& problem) {
    std::vector<Work> all;
    for (const Row& row : accuracy.rows()) {
        const Work work = work_of(accuracy, row);
        if (accuracy.at(row, "problem") == problem && std::isfinite(work.error) &&
            std::isfinite(work.seconds)) {
            all.push_back(work);
        }
    }
    return all;
}

const Work* most_exact(const std::vector<Work>& work, bool by_bullet, double within) {
    const Work* best = nullptr;
    for (const Work& each : work) {
        const bool counts = each.by_bullet == by_bullet && each.seconds <= within;
        if (counts && (best == nullptr || each.error < best->error)) {
            best = &each;
        }
    }
    return best;
}

const Work* fastest(const std::vector<Work>& work, bool by_bullet, double error) {
    const Work* best = nullptr;
    for (const Work& each : work) {
        const bool counts = each.by_bullet == by_bullet && each.error <= error;
        if (counts && (best == nullptr || each.seconds < best->seconds)) {
            best = &each;
        }
    }
    return best;
}

Standing standing(const std::vector<Work>& work) {
    Standing result;
    const Work* best = most_exact(work, true);
    for (const Work& each : work) {
        if (!each.by_bullet) {
            continue;
        }
        const Work* rival = most_exact(work, false, each.seconds);
        const bool beaten = rival != nullptr && rival->error <= each.error;
        ++result.bullet_rows;
        result.beaten += beaten ? 1 : 0;
        result.best_beaten = result.best_beaten || (&each == best && beaten);
    }
    if (result.bullet_rows == 0) {
        result.verdict = "Bullet has no answer";
    } else if (result.beaten == result.bullet_rows) {
        result.verdict = "ahead without exception";
    } else {
        result.verdict = result.best_beaten ? "ahead of Bullet's most exact, behind some of its faster runs"
                                            : "behind Bullet's most exact";
    }
    return result;
}

}  // namespace scree
