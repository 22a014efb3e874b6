#pragma once

#include <memory>

#include <scree/output/output_folder.hpp>
#include <scree/output/shown_scene.hpp>
#include <scree/scenes/simulation.hpp>

namespace scree {

class VtkFrames;

/// A run's frames for ParaView. A scene that asks for them is refused when it is read by a build that has
/// none.
class FrameWriter {
  public:
    FrameWriter(const Simulation& simulation, const OutputFolder& folder, const ShownScene& shown);
    ~FrameWriter();

    /// Of the present output time.
    void write();
    /// Of all up to it.
    void write_list();

  private:
    const Simulation& simulation_;
    std::unique_ptr<VtkFrames> frames_;
};

}  // namespace scree
