// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/frame_assembly.h"
#include "texgen/animation/simulated_frame.h"
#include "texgen/animation/simulation.h"

#include <functional>
#include <optional>
#include <vector>

namespace foam::texgen {

enum class RunStatus {
    Complete,
    NoEquilibrium,
    OpenLoop,  // the loop did not close; no frame was handed out
};

/// How a run ended.
struct RunOutcome {
    RunStatus status = RunStatus::Complete;
    int failed_frame = 0;                 // the frame at which the run failed; 0 if complete
    std::optional<double> closing_error;  // only for a loop (Simulation::closing_error)
};

/// A source of frames. Calls the visitor for each of the frames with the given numbers, in the same
/// order as simulate_frames.
using FrameSource = std::function<RunOutcome(
    const std::vector<int>& numbers, NextFrames next_frames, const FrameVisitor&)>;

/// Returns a source that simulates a preset. Every call starts again from the seed. `threads` is
/// the number of threads of the simulation, 0 for all hardware threads.
FrameSource simulation_of(const Preset& preset, int threads);

/// Simulates a preset from its seed to the last of the given states and calls `on_state` for each
/// of them. The FrameEffort of a state covers the steps since the given state before it.
/// Precondition: `states` is in increasing order.
RunOutcome simulate_states(const Preset& preset,
                           int threads,
                           const std::vector<int>& states,
                           const FrameVisitor& on_state);

/// Simulates a preset from its seed as far as the frames with the given numbers need. Calls
/// `on_frame` for each frame as soon as the states that it shows exist (FrameAssembly).
RunOutcome simulate_frames(const Preset& preset,
                           int threads,
                           const std::vector<int>& numbers,
                           NextFrames next_frames,
                           const FrameVisitor& on_frame);

}  // namespace foam::texgen
