#pragma once

#include <functional>
#include <optional>
#include <span>

#include <scree/mesh/pose.hpp>
#include <scree/output/appended_file.hpp>

namespace scree {

/// The poses of some bodies at many times and how many contacts there were, on disk, as a replay needs them:
/// in single precision.
class PoseSpool {
  public:
    static constexpr const char* file_name = "replay.poses";  ///< in a run's folder

    /// `kept`: goes on with one that is there, after that many bytes. Throws OutputError, as all that writes
    /// or reads does.
    PoseSpool(const std::filesystem::path& file, std::size_t bodies,
              std::optional<std::uint64_t> kept = std::nullopt);

    /// At a time [s], not before the last one.
    void add(double time, std::size_t contacts, std::span<const Pose> poses);

    /// How many times were added.
    [[nodiscard]] std::size_t frames() const { return file_.size() / frame_bytes(); }
    /// Gets one frame: its time [s], how many contacts there were, and the poses.
    using Take = std::function<void(double time, double contacts, std::span<const Pose> poses)>;
    /// Hands over every `stride`-th frame and the last one, read from the disk one by one.
    void read(std::size_t stride, const Take& take) const;

    /// The file itself, to sync and to close.
    [[nodiscard]] AppendedFile& file() { return file_; }

  private:
    [[nodiscard]] std::size_t frame_bytes() const;

    AppendedFile file_;
    std::size_t bodies_;
    std::string bytes_;  ///< of one frame
};

}  // namespace scree
