// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/frame_assembly.h"
#include "texgen/animation/progress.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/preset/preset.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace foam::texgen {

/// The simulation of one foam in a FrameStore. A frame of the animation shows one or two states of
/// the simulation (shown_states.h). States are kept, and frames are assembled from them whenever
/// they are drawn, because the camera, which decides how a state is shown, may change without a new
/// simulation. The mutex of the store protects the members that change, from `kept` on; once the
/// simulation has finished, `kept` and `outcome` are constant.
struct FrameRun {
    Preset preset;
    std::string simulation;             // simulation_hash(preset)
    int frames = 0;                     // states of frames 1 to this number will be kept
    std::vector<int> states = {};       // ascending numbers of the states that these frames need
    std::vector<int> last_states = {};  // for each frame, the last state that it needs
    std::map<int, SimulatedFrame> kept = {};  // the states computed so far, by their numbers
    std::set<std::string> pages = {};         // random words of the pages that want this run
    RunProgress progress = {};
    std::optional<RunOutcome> outcome = {};  // nullopt before the end, and after an exception
    std::string failure = {};                // the reason of a failure, otherwise empty
    // The reason why the store forgets this run, which also stops its simulation; otherwise empty.
    std::string drop_reason = {};

    bool is_finished() const { return outcome || !failure.empty(); }
    bool is_dropped() const { return !drop_reason.empty(); }

    // Returns true if all states of a frame are kept. States are kept in increasing order.
    bool has_states(int frame) const;

    // Returns the largest number n for which all states of frames 1 to n are kept.
    int complete_frames() const;

    // Returns the kept states that a frame needs. Precondition: all of them are kept.
    std::map<int, SimulatedFrame> states_for(const Preset& drawn_preset,
                                             int frame,
                                             NextFrames next_frames) const;
};

/// Assembles the frames with the given numbers from kept states, and passes them to `visit`. The
/// camera and the loop are those of `drawn_preset`. Precondition: `kept` has all states of the
/// frames.
void assemble(const std::map<int, SimulatedFrame>& kept,
              const Preset& drawn_preset,
              const std::vector<int>& numbers,
              NextFrames next_frames,
              const FrameVisitor& visit);

}  // namespace foam::texgen
