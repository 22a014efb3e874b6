#include <scree/output/energy_csv.hpp>

namespace scree {

namespace {

std::string header() {
    std::string names = "t";
    for (const auto& [name, entry] : ledger_entries) {
        names += std::string(",") + name;
    }
    return names;
}

}  // namespace

EnergyCsv::EnergyCsv(const std::filesystem::path& file, std::optional<std::uint64_t> kept)
    : csv_(file, header(), kept) {}

void EnergyCsv::write(double time, const EnergyLedger& ledger) {
    csv_.add(time);
    for (const auto& [name, entry] : ledger_entries) {
        csv_.add(ledger.*entry);
    }
    csv_.end_row();
    csv_.flush();
}

}  // namespace scree
