// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"

#include <chrono>
#include <functional>

namespace foam::texgen {

/// The progress of a run after a frame has been simulated, measured or written.
struct RunProgress {
    int frame = 0;             // number of the frame
    int done = 0;              // number of frames done so far, including this frame
    int total = 0;             // number of frames in the run
    int bubbles = 0;           // number of bubbles in this frame
    double area_error = 0.0;   // largest |A / A_target - 1| (E2)
    double angle_error = 0.0;  // largest deviation from 120 degrees (E2), radians
    double seconds = 0.0;      // wall time since the run began
};

/// Receives the progress after each frame, from one thread at a time.
using ProgressCallback = std::function<void(const RunProgress&)>;

/// Counts the frames of a run and reports each to a callback. The time since the run began is
/// measured from the construction of the meter. Not thread-safe.
class ProgressMeter {
  public:
    /// Keeps a reference to the callback, which may be empty. `total` is the number of frames in
    /// the run.
    ProgressMeter(int total, const ProgressCallback& on_progress);

    /// Counts a frame that is done and reports it.
    void add(const SimulatedFrame& shown);

  private:
    const ProgressCallback& on_progress_;
    RunProgress progress_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace foam::texgen
