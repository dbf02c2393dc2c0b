// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/animation/simulated_frame.h"

#include <mutex>

namespace foam::texgen {

/// Counts the units of a phase of a run, such as frames (Phase), and reports each of them to a
/// callback. Thread-safe; the callback is called by one thread at a time. All functions rethrow the
/// exceptions of the callback.
class ProgressMeter {
  public:
    /// Keeps a reference to the callback, which may be empty. `total` is the number of units.
    ProgressMeter(Phase phase, int total, const ProgressCallback& on_progress);

    /// Begins the phase, if it has not begun: reports that no unit is done.
    void begin();

    /// Counts a unit and reports it.
    void add();

    /// Counts a frame and reports it with the number of its bubbles and the errors of its
    /// equilibrium (RunProgress::area_error and angle_error).
    void add(const SimulatedFrame& shown);

    /// Returns a callback for the simulation (simulate_frames.h) whose frames this meter counts.
    /// Until the phase of the meter begins, the returned callback passes the reports of the
    /// simulation to the callback of the meter. Afterwards, at each report of the simulation, the
    /// returned callback repeats the last report of the meter. The callback of the meter can
    /// therefore stop the run, by throwing, also between two frames. The meter must outlive the
    /// returned callback.
    ProgressCallback for_source();

  private:
    void report();  // precondition: the mutex is locked

    const ProgressCallback& on_progress_;
    std::mutex mutex_;
    bool begun_ = false;
    RunProgress progress_;
};

}  // namespace foam::texgen
