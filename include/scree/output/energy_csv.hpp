#pragma once

#include <array>
#include <utility>

#include <scree/dynamics/energy.hpp>
#include <scree/output/csv_file.hpp>

namespace scree {

/// The entries of the ledger [J] and their names in files, in order.
inline constexpr std::array<std::pair<const char*, double EnergyLedger::*>, 15> ledger_entries = {{
    {"kinetic", &EnergyLedger::kinetic},
    {"gravity", &EnergyLedger::gravity},
    {"normal_elastic", &EnergyLedger::normal_elastic},
    {"tangential_elastic", &EnergyLedger::tangential_elastic},
    {"torsional_elastic", &EnergyLedger::torsional_elastic},
    {"rolling_elastic", &EnergyLedger::rolling_elastic},
    {"cohesive", &EnergyLedger::cohesive},
    {"lost_normal_damping", &EnergyLedger::lost_normal_damping},
    {"lost_tangential_damping", &EnergyLedger::lost_tangential_damping},
    {"lost_friction", &EnergyLedger::lost_friction},
    {"lost_torsion", &EnergyLedger::lost_torsion},
    {"lost_rolling", &EnergyLedger::lost_rolling},
    {"lost_cohesion", &EnergyLedger::lost_cohesion},
    {"work_applied", &EnergyLedger::work_applied},
    {"residual", &EnergyLedger::residual},
}};

/// energy.csv: one row an output time.
class EnergyCsv {
  public:
    /// `kept`: as in CsvFile.
    explicit EnergyCsv(const std::filesystem::path& file, std::optional<std::uint64_t> kept = std::nullopt);

    /// The ledger as it stands at a time [s].
    void write(double time, const EnergyLedger& ledger);

    /// The file itself, to sync and to close.
    [[nodiscard]] AppendedFile& file() { return csv_.file(); }

  private:
    CsvFile csv_;
};

}  // namespace scree
