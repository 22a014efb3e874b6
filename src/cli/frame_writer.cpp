#include "frame_writer.hpp"

#include "summary_of.hpp"

#ifdef SCREE_HAS_VTK

#include <scree/vtk/frames.hpp>

namespace scree {

FrameWriter::FrameWriter(const Simulation& simulation, const OutputFolder& folder, const ShownScene& shown)
    : simulation_(simulation), frames_(std::make_unique<VtkFrames>(folder.path(), shown)) {}

FrameWriter::~FrameWriter() = default;

void FrameWriter::write() {
    frames_->write(static_cast<std::size_t>(simulation_.tick()), simulation_.time(),
                   body_records(simulation_));
}

void FrameWriter::write_list() {
    std::vector<double> times;
    for (std::int64_t tick = 0; tick <= simulation_.tick(); ++tick) {
        times.push_back(simulation_.times().at(tick));
    }
    frames_->write_list(times);
}

}  // namespace scree

#else

namespace scree {

class VtkFrames {};

FrameWriter::FrameWriter(const Simulation& simulation, const OutputFolder& /*folder*/,
                         const ShownScene& /*shown*/)
    : simulation_(simulation) {}

FrameWriter::~FrameWriter() = default;

void FrameWriter::write() {}

void FrameWriter::write_list() {}

}  // namespace scree

#endif
