// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"

#include <optional>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the name of a phase in the lines of JSON (progress_json), such as "warm_up".
std::string_view name_of(Phase phase);

/// Returns the progress of a phase in its own unit, for example "warm-up 40 of 60" or "frame 3 of
/// 48". In the phase LoopClosing, an example is "closing the loop: cycle 3 of about 30 (12/48),
/// error 1e-04". Of the 48 steps of cycle 3, 12 are done. The closing error of cycle 2 is 1e-04.
std::string phase_text(const RunProgress& progress);

/// The times of the present phase, in seconds.
struct PhaseTimes {
    double passed = 0.0;              // since the phase began
    std::optional<double> left = {};  // until the phase ends, if it is known
};

/// Returns the text of the progress bar, without a newline. Example:
/// "[######------------------] frame 12 of 48  583 bubbles  0:14 left".
/// If the time left is not known, the text may show the time since the phase began. It does so if
/// this time is at least one second, RunProgress::done is 0, and the phase is not LoopClosing:
/// "[------------------------] finding the first equilibrium  0:12 so far".
std::string progress_bar(const RunProgress& progress, const PhaseTimes& times);

/// Returns the line that reports a frame (in the phase Frames) or the progress of any other phase.
/// The line ends with the wall time since the run began, in seconds. Example:
/// "frame 12: 583 bubbles, area error 1.2e-14, angle error 3.1e-15, 4.21 s" (errors as in
/// RunProgress).
std::string progress_line(const RunProgress& progress, double seconds);

/// Returns the progress as a JSON object in one line, without a newline. texgen/cli/PROGRESS.md
/// describes its members. `seconds` is the wall time since the run began.
std::string progress_json(const RunProgress& progress,
                          double seconds,
                          const std::optional<double>& seconds_left);

/// Returns a duration for users, rounded up: "5 minutes" or "2.5 hours".
std::string long_duration(double seconds);

}  // namespace foam::texgen
