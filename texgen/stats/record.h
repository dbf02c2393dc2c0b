// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/statistics.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/maps/maze_graph.h"
#include "texgen/preset/preset.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The statistics of one frame. Growth is measured since the preceding record. T1s, T2s and wall
/// time are counted since the preceding record or, in the first record, in all steps that prepare
/// the first frame (FrameEffort).
struct FrameRecord {
    int frame = 0;      // number of the frame
    double time = 0.0;  // foam time
    FoamStatistics foam;
    // Empty in the first record, and if no time has passed since the preceding record.
    std::vector<SidesGrowth> growth;
    FrameEffort effort;                    // T1s, T2s, errors, wall time, events, strain and stress
    std::optional<MazeStatistics> maze{};  // only if a map of the preset shows a maze
    // The shear modulus of the frame (core/dynamics/shear_modulus.h); nullopt if it has none.
    std::optional<double> shear_modulus{};
};

/// The statistics of a run, and the parameters needed to interpret them.
struct RunRecord {
    std::string preset;         // name of the preset
    double film_tension = 1.0;  // T = 2 gamma, where gamma is the surface tension
    double kappa = 0.0;         // diffusion constant (E6 in core/EQUATIONS.md)
    std::vector<FrameRecord> frames;
    std::shared_ptr<const Frame> last_frame{};  // the frame of the last record, or null

    /// Returns the dA/dt of a bubble with the given number of sides by von Neumann's law (E6).
    double law_rate(int sides) const;
};

/// Records the statistics of the frames of a run, which are passed one at a time, in the order in
/// which their source emits them (FrameAssembly).
class Recorder {
  public:
    /// Prepares a recorder. `threads` is the number of threads that measure the shear modulus; 0
    /// uses all hardware threads.
    explicit Recorder(const Preset& preset, int threads = 0);

    /// Appends the record of a frame. Keeps the frame as RunRecord::last_frame; the next call
    /// measures the growth since this frame.
    void record(const std::shared_ptr<const Frame>& frame, const FrameEffort& effort);

    /// Returns a function that calls record() for each frame it receives. The function refers to
    /// this recorder, which must outlive it.
    FrameVisitor visitor();

    const RunRecord& run() const { return run_; }

  private:
    RunRecord run_;
    std::optional<MazeRule> maze_;  // the rule of the maze; nullopt if no map shows a maze
    int threads_;
};

}  // namespace foam::texgen
