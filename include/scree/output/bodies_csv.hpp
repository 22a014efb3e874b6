#pragma once

#include <span>

#include <scree/output/body_record.hpp>
#include <scree/output/csv_file.hpp>

namespace scree {

/// bodies.csv: one row a body and output time.
class BodiesCsv {
  public:
    /// `kept`: as in CsvFile.
    explicit BodiesCsv(const std::filesystem::path& file, std::optional<std::uint64_t> kept = std::nullopt);

    /// All bodies at one time [s], in scene order.
    void write(double time, std::span<const BodyRecord> bodies);

    /// The file itself, to sync and to close.
    [[nodiscard]] AppendedFile& file() { return csv_.file(); }

  private:
    CsvFile csv_;
};

}  // namespace scree
