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
    OpenLoop,  // no frame was handed out
};

/// How a run ended.
struct RunOutcome {
    RunStatus status = RunStatus::Complete;
    int failed_frame = 0;                 // whose foam found no equilibrium, or whose loop is open
    std::optional<double> closing_error;  // of a loop (Simulation::closing_error)
};

/// A source of frames: hands out those of the given numbers, as simulate_frames does.
using FrameSource = std::function<RunOutcome(
    const std::vector<int>& numbers, NextFrames next_frames, const FrameVisitor&)>;

/// Returns a source that simulates a preset from its seed at every call.
FrameSource simulation_of(const Preset& preset, int threads);

/// Simulates a preset from its seed to the last of these states, and hands them out in increasing
/// order, each with the effort since the one before.
RunOutcome simulate_states(const Preset& preset,
                           int threads,
                           const std::vector<int>& states,
                           const FrameVisitor& on_state);

/// Simulates a preset from its seed as far as the frames of these numbers need, and hands out each
/// frame as soon as its states exist (FrameAssembly).
RunOutcome simulate_frames(const Preset& preset,
                           int threads,
                           const std::vector<int>& numbers,
                           NextFrames next_frames,
                           const FrameVisitor& on_frame);

}  // namespace foam::texgen
