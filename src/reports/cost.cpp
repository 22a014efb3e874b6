#include "cost.hpp"

#include <link.h>
#include <malloc.h>

#include <chrono>
#include <memory>
#include <optional>
#include <set>

#include <scree/output/bodies_csv.hpp>
#include <scree/output/contacts_csv.hpp>
#include <scree/output/energy_csv.hpp>

#include "run_clock.hpp"

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Bytes that are in use on the heap.
double heap() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// The tables that a run may write.
class Tables {
  public:
    explicit Tables(const std::filesystem::path& folder)
        : folder_(folder),
          bodies_(folder / "bodies.tmp"),
          energy_(folder / "energy.tmp"),
          contacts_(folder / "contacts.tmp") {}
    ~Tables() {
        for (const char* name : names) {
            std::error_code error;
            std::filesystem::remove(folder_ / name, error);
        }
    }
    Tables(const Tables&) = delete;
    Tables& operator=(const Tables&) = delete;

    void write(const Simulation& simulation) {
        std::vector<BodyRecord> records;
        std::vector<std::string> bodies;
        for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
            const FrameMotion motion = simulation.file_motion(i);
            bodies.push_back(simulation.bodies()[i].name);
            records.push_back({bodies.back(), motion.pose, motion.velocity, motion.angular_velocity});
        }
        bodies_.write(simulation.time(), records);
        energy_.write(simulation.time(), simulation.report().energy);
        contacts_.write(simulation.time(), simulation.contacts(), simulation.contact_results(), bodies);
    }
    [[nodiscard]] std::size_t size() const {
        std::size_t sum = 0;
        for (const char* name : names) {
            sum += std::filesystem::file_size(folder_ / name);
        }
        return sum;
    }

  private:
    static constexpr const char* names[] = {"bodies.tmp", "energy.tmp", "contacts.tmp"};

    std::filesystem::path folder_;
    BodiesCsv bodies_;
    EnergyCsv energy_;
    ContactsCsv contacts_;
};

/// Steps and, where there are tables, writes to the end or until the time is up. Returns the seconds.
double measure(Simulation& simulation, std::optional<Tables>& tables, const Running& running,
               const Budget& budget, std::string& message) {
    RunClock clock;
    const auto seconds = [&] { return running.threads > 1 ? clock.by_clock() : clock.seconds(); };
    while (simulation.tick() < simulation.times().last() && message.empty()) {
        clock.start();
        if (!simulation.advance()) {
            message = simulation.report().message;
        }
        if (tables) {
            tables->write(simulation);
        }
        clock.stop();
        if (seconds() > budget.seconds && simulation.tick() < simulation.times().last()) {
            message = "stopped after " + cell(budget.seconds) + " s of computing";
        }
    }
    return seconds();
}

/// One run into an expense whose seconds are the least so far.
void run_once(const SceneDescription& scene, const Running& running, const Budget& budget, bool first,
              Expense& expense) {
    const double before = heap();
    const Clock::time_point loading = Clock::now();
    Simulation simulation(scene);
    expense.loading = seconds_since(loading);
    if (running.threads > 1) {
        simulation.world().set_threads(running.threads);
    }
    std::optional<Tables> tables;
    if (running.write) {
        tables.emplace(running.place);
    }
    const double seconds = measure(simulation, tables, running, budget, expense.message);
    expense.finished = expense.message.empty();
    if (first || seconds < expense.seconds) {
        expense.seconds = seconds;
        expense.report = simulation.report();
    }
    expense.bodies = simulation.bodies().size();
    expense.bytes = heap() - before;
    expense.files = tables ? tables->size() : 0;
}

}  // namespace

Expense expense_of(const SceneDescription& scene, const Running& running, const Budget& budget) {
    Expense expense;
    double spent = 0;
    for (std::size_t run = 0; run <= running.runs && expense.message.empty() && spent < budget.seconds;
         ++run) {
        run_once(scene, running, budget, run <= 1, expense);
        spent += expense.seconds;
    }
    return expense;
}

std::string mapped_libraries() {
    std::set<std::string> names;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* data) {
            const std::string name = std::filesystem::path(info->dlpi_name).filename().string();
            if (name.starts_with("lib")) {
                static_cast<std::set<std::string>*>(data)->insert(name);
            }
            return 0;
        },
        &names);
    std::string all;
    for (const std::string& name : names) {
        all.append(all.empty() ? "" : " ").append(name);
    }
    return all;
}

}  // namespace scree
