// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/frame_assembly.h"
#include "texgen/animation/progress.h"
#include "texgen/animation/simulated_frame.h"
#include "texgen/animation/simulation.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The reason why a run ended.
enum class RunStatus {
    Complete,
    NoEquilibrium,  // a step found no equilibrium
    OpenLoop,       // the loop did not close; no frame was passed to the visitor
};

/// The result of a run, whether or not it is complete.
struct RunOutcome {
    RunStatus status = RunStatus::Complete;
    int failed_frame = 0;  // first frame that could not be simulated; 0 if complete
    // Distance between the states at the start and at the end of the last cycle before frame 1
    // (Simulation::closing_error); nullopt if no cycle was run.
    std::optional<double> closing_error;
    // How often a step has relaxed the whole foam (Simulation::relaxations); nullopt if the frames
    // come from a cache.
    std::optional<int> relaxations{};
    // For each event, the number of bubbles that it should have chosen or created, but could not
    // (Timeline::missing_bubbles); empty if the frames come from a cache.
    std::vector<int> missing_bubbles{};
};

/// Returns why a run ended early, as the text of a message; empty if it is complete.
std::string failure_of(const RunOutcome& outcome);

/// A source of frames: calls the visitor for each of the frames with the given numbers, in the
/// order of FrameAssembly, and returns how the run ended. `next_frames` decides whether the visitor
/// also receives the frame after each frame. The progress callback receives the phases from Seeding
/// to States; from a source that reads a cache, only the phase States. The phase States is reported
/// before every state except the first, also after the visitor has received the first frame. A
/// progress callback from ProgressMeter::for_source replaces these later reports by reports of the
/// phase of the ProgressMeter.
using FrameSource = std::function<RunOutcome(const std::vector<int>& numbers,
                                             NextFrames next_frames,
                                             const FrameVisitor&,
                                             const ProgressCallback&)>;

/// Returns a source that simulates a preset. Every call starts a new simulation (simulate_frames).
/// `threads` is the number of threads of the simulation; 0 uses all hardware threads.
FrameSource simulation_of(const Preset& preset, int threads);

/// Keeps the start of a boil (LoopStart) between runs of the program, for example in a cache, so
/// that the search for it runs only once.
struct LoopMemory {
    std::string content;  // the text that `keep` received in an earlier run; empty if there is none
    // Receives the start as text (write_loop_start) after the search has found it. May be empty.
    std::function<void(const std::string&)> keep = {};
};

/// Simulates a preset to the last of the given states and calls `on_state` for each of them. The
/// simulation begins with the start of the loop if it is stored in the program (stored_loop_start)
/// or, for a boil, in `memory`. Otherwise it begins with the seeded foam; for a boil, another
/// simulation first searches for the start. A boil therefore has the same states whether or not its
/// start was known. The FrameEffort of a state covers the steps since the previous state that was
/// passed to `on_state`. For the first such state, it covers all steps since the start of the
/// simulation, but not the search. `on_progress` receives the same reports as from a FrameSource.
/// Throws the exceptions of Simulation and of the callbacks. Precondition: `states` is in
/// increasing order.
RunOutcome simulate_states(const Preset& preset,
                           int threads,
                           const std::vector<int>& states,
                           const FrameVisitor& on_state,
                           const ProgressCallback& on_progress = {},
                           const LoopMemory& memory = {});

/// Simulates a preset, as simulate_states does, until all states that the frames with the given
/// numbers need are computed. Calls `on_frame` for each frame as soon as the states that it needs
/// exist (FrameAssembly). `on_progress` receives the same reports as from a FrameSource.
RunOutcome simulate_frames(const Preset& preset,
                           int threads,
                           const std::vector<int>& numbers,
                           NextFrames next_frames,
                           const FrameVisitor& on_frame,
                           const ProgressCallback& on_progress = {});

}  // namespace foam::texgen
