#pragma once

#include <span>

#include <scree/dynamics/contact.hpp>
#include <scree/output/csv_file.hpp>

namespace scree {

/// contacts.csv: one row an output time and pair that touches. The normal and the forces are those on a; ft
/// is the force's part in the contact plane, slip the speed there [m/s].
class ContactsCsv {
  public:
    /// `kept`: as in CsvFile.
    explicit ContactsCsv(const std::filesystem::path& file, std::optional<std::uint64_t> kept = std::nullopt);

    /// The contacts at a time [s] and what each of them did; bodies are named by their numbers.
    void write(double time, std::span<const Contact> contacts, std::span<const ContactResult> results,
               std::span<const std::string> names);

    /// The file itself, to sync and to close.
    [[nodiscard]] AppendedFile& file() { return csv_.file(); }

  private:
    CsvFile csv_;
};

}  // namespace scree
