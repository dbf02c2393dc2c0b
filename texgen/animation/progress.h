// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <optional>

namespace foam::texgen {

/// The phases of a long run, in the order in which they occur. Each phase counts its progress in a
/// unit of its own. The phases before Ranges prepare the first frame. If frame 1 shows the raw
/// diagram (FirstFrame::Diagram), however, Equilibrium and WarmUp occur between frames 1 and 2.
/// Between Ranges and Frames, the phase States occurs again if the frames are read from a cache.
/// When a simulation is stored in a cache, States and Ranges follow Frames, because the stored
/// states are read again to fit the ranges.
enum class Phase {
    Seeding,      // places the bubbles of the first foam; counts nothing
    Equilibrium,  // brings the first foam to equilibrium; counts nothing
    WarmUp,       // simulates the time FramesOptions::warm_up; counts steps
    LoopClosing,  // repeats the cycle of a loop until it closes; counts the steps of each cycle
    States,       // simulates or reads the states that the next phase needs; counts states
    Ranges,       // fits the automatic ranges of maps; counts frames
    Frames,       // simulates, draws or measures the frames of the run; counts frames
    Files,        // verifies files; counts files
    Sheets,       // joins frames into sheets; counts each frame once per map
    Previews,     // makes previews or draws variations; counts pictures and files
};

/// The progress of a run in its present phase.
struct RunProgress {
    Phase phase = Phase::Frames;
    int done = 0;   // number of units of the phase that are done
    int total = 0;  // number of units of the phase; 0 if unknown
    // LoopClosing: the closing error of the latest cycle that is complete
    // (Simulation::closing_error). It may be infinite, and is nullopt until the first cycle is
    // complete.
    std::optional<double> measure = {};
    int cycle = 0;  // LoopClosing: number of the cycle, from 1
    // LoopClosing: about how many cycles the loop will take to close (usual_cycles in
    // simulation_options.h), but not more than LoopOptions::cycles; 0 if unknown.
    int usual_cycles = 0;
    int frame = 0;             // number of the frame that was done last; 0 if there is none
    int bubbles = 0;           // number of bubbles of the foam; 0 if unknown
    double area_error = 0.0;   // of `frame`: largest |A / A_target - 1| (E2)
    double angle_error = 0.0;  // of `frame`: largest deviation from 120 degrees (E2), radians

    /// Returns true if all units of the phase are done.
    bool finished() const { return total > 0 && done >= total; }
};

/// Receives the progress of a run: at the beginning of each phase and after each of its units. In
/// the phases WarmUp and States, the last unit is not reported; in States, the beginning is not
/// reported either. The callback is called by one thread at a time, but not always by the same
/// thread. It may throw to stop the run. An empty callback is allowed wherever a callback is an
/// argument.
using ProgressCallback = std::function<void(const RunProgress&)>;

}  // namespace foam::texgen
