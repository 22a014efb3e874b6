#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include <scree/output/body_record.hpp>
#include <scree/output/shown_scene.hpp>

namespace scree {

/// The bodies at each output time as surfaces for ParaView: frames/frame_000000.vtp and so on, written by
/// VTK's own writer, and frames.pvd, which lists them with their times. Points are in world axes [m], in
/// double precision, with the velocity [m/s] that the body has there; faces have the number of their body in
/// scene order and its angular velocity [rad/s]. Throws OutputError.
class VtkFrames {
  public:
    /// In the folder of a run, for the bodies of a scene.
    VtkFrames(std::filesystem::path folder, ShownScene scene);

    /// All bodies, in scene order, at a time [s], in place of a frame of that number.
    void write(std::size_t number, double time, std::span<const BodyRecord> bodies);
    /// The list of the frames at these times [s], and nothing of later ones.
    void write_list(std::span<const double> times);

  private:
    [[nodiscard]] std::filesystem::path frame(std::size_t number) const;

    std::filesystem::path folder_;
    ShownScene scene_;
};

}  // namespace scree
