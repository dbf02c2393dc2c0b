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

/// Where frames come from: hands out those of these numbers, as simulate_frames does.
using FrameSource = std::function<RunOutcome(
    const std::vector<int>& numbers, NextFrames next_frames, const FrameVisitor&)>;

/// A simulation of a preset from its seed, each time it is asked.
FrameSource simulation_of(const Preset& preset, int threads);

/// Simulates a preset from its seed to the last of these states, and hands out each of them: in
/// increasing order, its effort that since the one before.
RunOutcome simulate_states(const Preset& preset,
                           int threads,
                           const std::vector<int>& states,
                           const FrameVisitor& on_state);

/// Simulates a preset from its seed as far as the frames of these numbers need, and hands out each
/// of them as soon as it can (FrameAssembly).
RunOutcome simulate_frames(const Preset& preset,
                           int threads,
                           const std::vector<int>& numbers,
                           NextFrames next_frames,
                           const FrameVisitor& on_frame);

}  // namespace foam::texgen
