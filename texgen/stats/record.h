#pragma once

#include "core/foam/statistics.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/preset/preset.h"

#include <memory>
#include <string>
#include <vector>

namespace foam::texgen {

/// One frame in numbers. What counts events or time is since the record before it.
struct FrameRecord {
    int frame = 0;  // its number
    double time = 0.0;
    FoamStatistics foam;
    std::vector<SidesGrowth> growth;  // none in the first record
    FrameEffort effort;
};

/// The statistics of a run, and what is needed to read them.
struct RunRecord {
    std::string preset;         // its name
    double film_tension = 1.0;  // T = 2 gamma
    double kappa = 0.0;         // of von Neumann's law (E6)
    std::vector<FrameRecord> frames;

    /// von Neumann's law: dA/dt of a bubble of so many sides.
    double law_rate(int sides) const;
};

/// Takes down the frames of a run as they are handed out.
class Recorder {
  public:
    explicit Recorder(const Preset& preset);

    void record(const std::shared_ptr<const Frame>& frame, const FrameEffort& effort);

    /// `record`, for simulate_frames; borrows the recorder.
    FrameVisitor visitor();

    const RunRecord& run() const { return run_; }

  private:
    RunRecord run_;
    std::shared_ptr<const Frame> before_;
};

}  // namespace foam::texgen
