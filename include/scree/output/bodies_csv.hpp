#pragma once

#include <span>

#include <scree/output/body_record.hpp>
#include <scree/output/csv_file.hpp>

namespace scree {

/// bodies.csv: one row a body and output time.
class BodiesCsv {
  public:
    explicit BodiesCsv(const std::filesystem::path& file);

    /// All bodies at one time [s], in scene order.
    void write(double time, std::span<const BodyRecord> bodies);

  private:
    CsvFile csv_;
};

}  // namespace scree
