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

/// The simulation of one foam in a FrameStore, whose mutex protects all members. Frames are
/// assembled from the kept states whenever they are drawn, because the camera, which decides how a
/// state is shown, may change without a new simulation.
struct FrameRun {
    Preset preset;
    std::string simulation;             // simulation_hash
    int frames = 0;                     // number of frames that are kept
    std::vector<int> states = {};       // numbers of their states, in increasing order
    std::vector<int> last_states = {};  // of each frame, the largest number of its states
    std::map<int, SimulatedFrame> kept = {};
    std::set<std::string> pages = {};  // that want this run
    RunProgress progress = {};
    std::optional<RunOutcome> outcome = {};
    std::string failure = {};
    bool is_dropped = false;  // true if the simulation is to be stopped

    bool is_finished() const { return outcome || !failure.empty(); }

    // Returns true if all states of a frame are kept. States are kept in increasing order.
    bool has_states(int frame) const;

    // Returns the number of the first frames whose states are all kept.
    int complete_frames() const;

    // Returns the kept states that a frame needs. Precondition: all of them are kept.
    std::map<int, SimulatedFrame> states_for(const Preset& shown,
                                             int frame,
                                             NextFrames next_frames) const;
};

/// Assembles frames from kept states. Precondition: `kept` has all states of the frames.
void assemble(const std::map<int, SimulatedFrame>& kept,
              const Preset& shown,
              const std::vector<int>& numbers,
              NextFrames next_frames,
              const FrameVisitor& visit);

/// Returns the numbers of the states that frames need.
std::vector<int> states_of(const Preset& preset,
                           const std::vector<int>& frames,
                           NextFrames next_frames);

}  // namespace foam::texgen
