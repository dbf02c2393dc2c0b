// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"

#include <chrono>
#include <optional>
#include <vector>

namespace foam::texgen {

/// Measures how fast the present phase of a run advances, and estimates when it ends. Earlier
/// phases do not influence the estimate. A unit is what the phase counts (Phase), such as a frame.
class PhaseClock {
  public:
    using Clock = std::chrono::steady_clock;

    /// The news in a report, compared with the report before it: nothing, further units (or another
    /// cycle) of the same phase, or a new phase.
    enum class News { Nothing, Units, NewPhase };

    /// Takes a report that was made at the given time. Precondition: times do not decrease.
    News add(const RunProgress& progress, Clock::time_point now);

    /// Moves on to the given time without a report. Precondition: times do not decrease.
    void advance(Clock::time_point now) { now_ = now; }

    /// Returns the wall time, in seconds, from the first report of the present phase to the latest
    /// time. Here and in the functions below, in contrast to News, each cycle of a loop counts as a
    /// phase of its own.
    double seconds_in_phase() const;

    /// Returns the seconds per unit of the present phase. Let report A be the first report of the
    /// phase, and report B the next report with further units. The result is the larger of two
    /// means: over all units since A, and over all units since B. The first mean is too small if a
    /// unit began before A, as the first frame of a simulation does. The second mean is too small
    /// if several threads finish their first units at the same time. Returns nullopt until a report
    /// with further units has followed B.
    std::optional<double> seconds_per_unit() const;

    /// Returns the estimated time until the phase ends, in seconds. Returns nullopt if
    /// seconds_per_unit() does, and for the phases that prepare the first frame. These phases are
    /// short compared with the frames, or repeat for an unknown number of cycles.
    std::optional<double> seconds_left() const;

  private:
    // The time of a report, and the number of units that were done.
    struct Mark {
        Clock::time_point time;
        int done = 0;
    };

    std::optional<RunProgress> latest_;
    Clock::time_point now_{};  // time of the latest report or of the latest call of advance
    // The marks of the present phase: report A, report B and the latest report with further units
    // (see seconds_per_unit).
    std::vector<Mark> marks_;
};

/// Returns true for the phases that precede Phase::Ranges: they prepare the first frame.
bool is_preparation(Phase phase);

}  // namespace foam::texgen
