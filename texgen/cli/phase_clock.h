// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"

#include <chrono>
#include <optional>
#include <vector>

namespace foam::texgen {

/// Measures how fast the present phase of a run advances, and estimates when it ends. Earlier
/// phases do not influence the estimate.
class PhaseClock {
  public:
    using Clock = std::chrono::steady_clock;

    /// The news that a report brings: nothing new, new units (or a new cycle) of the phase, or a
    /// new phase.
    enum class News { Nothing, Units, NewPhase };

    /// Takes a report that was made at the given time. Precondition: times do not decrease.
    News add(const RunProgress& progress, Clock::time_point now);

    /// Returns the wall time from the first report of the phase to the last one. A cycle of a loop
    /// counts as a phase of its own.
    double seconds_in_phase() const;

    /// Returns the seconds per unit of the present phase. It is the larger of two means: over all
    /// units since the first report of the phase, and over all units since the next report of new
    /// units. The first mean is too small if a unit began before the first report, as the first
    /// frame of a simulation does. The second mean is too small if several threads finish their
    /// first units at the same time. Returns nullopt until two reports of new units have followed
    /// the first report.
    std::optional<double> seconds_per_unit() const;

    /// Returns the estimated time until the phase ends, in seconds. Returns nullopt before
    /// seconds_per_unit() is known, and for the phases that prepare the first frame: these are
    /// short compared with the frames, or repeat for an unknown number of cycles.
    std::optional<double> seconds_left() const;

  private:
    struct Mark {
        Clock::time_point time;
        int done = 0;
    };

    std::optional<RunProgress> latest_;
    Clock::time_point now_{};
    // The first report of the phase, the next report of new units, and the last one.
    std::vector<Mark> marks_;
};

/// Returns true for the phases before Ranges, which prepare the first frame.
bool is_preparation(Phase phase);

}  // namespace foam::texgen
