#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include <scree/mesh/saved_state.hpp>

namespace scree {

/// All that a run needs to go on from where it was, in whatever folder it lies.
struct Checkpoint {
    static constexpr const char* file_name = "checkpoint.cbor";  ///< in a run's folder

    std::string scene;                           ///< its text
    std::string scene_file;                      ///< where that was read, for the meshes beside it
    std::map<std::string, SavedState> shapes;    ///< the geometry by which it was run
    std::map<std::string, std::uint64_t> files;  ///< sizes [bytes] of the run's growing files
    double wall = 0;                             ///< time [s] that the run has taken
    double writing = 0;                          ///< of that
    SavedState state;                            ///< of the simulation
};

/// Bytes that are no checkpoint. The message says what was found and what was expected.
class CheckpointError : public std::runtime_error {
  public:
    /// "found FOUND, expected EXPECTED".
    CheckpointError(const std::string& found, const std::string& expected)
        : std::runtime_error("found " + found + ", expected " + expected) {}
};

/// A line with the format's number, the size of what follows and its checksum (XXH3, 64 bits), then CBOR,
/// which keeps doubles exactly.
std::string checkpoint_bytes(const Checkpoint& checkpoint);
/// Any CBOR with such a line before it.
std::string sealed_checkpoint(std::string_view cbor);
/// Throws CheckpointError for all bytes that are not those of a checkpoint of this version of scree.
Checkpoint parse_checkpoint(std::string_view bytes);

/// Reads a file. Throws OutputError.
Checkpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace scree
