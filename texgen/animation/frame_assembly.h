// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/shown_states.h"
#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <map>
#include <vector>

namespace foam::texgen {

/// Selects whether each frame is handed out together with the frame after it. If so, the simulation
/// continues to the state after the last frame.
enum class NextFrames { LeftOut, HandedOut };

/// Assembles the frames of an animation from the states of a simulation. Hands out each frame as
/// soon as all states that it needs exist. The order is increasing, except in a pingpong, which
/// shows states twice. States are released when no further frame needs them.
class FrameAssembly {
  public:
    /// Assembles the frames with the given numbers. Calls `on_frame` for each of them.
    FrameAssembly(const Preset& preset,
                  const std::vector<int>& numbers,
                  NextFrames next_frames,
                  FrameVisitor on_frame);

    /// Returns the numbers of the states that these frames need, in increasing order. For a patch
    /// they include state 1, which decides the view of all frames.
    std::vector<int> states() const;

    /// Adds a state and hands out the frames that are complete with it. Preconditions: states are
    /// added in the order of `states`; the effort of each counts from the state added before it.
    void add(const SimulatedFrame& state);

  private:
    struct Request {
        int number = 0;
        ShownStates shown;
        std::vector<int> states;  // states that the frame needs, in increasing order
    };

    Request request_of(int number, const Preset& preset) const;
    void hand_out(const Request& request);
    DrawnState drawn(int state, int next) const;
    void release(const Request& request);
    FrameEffort effort_since_last(const FrameEffort& total);

    bool hands_out_next_;
    FrameVisitor on_frame_;
    std::vector<Request> requests_;       // in the order in which they are handed out
    std::size_t handed_out_ = 0;          // number of requests handed out so far
    std::map<int, int> uses_;             // state number to number of open requests that need it
    std::map<int, SimulatedFrame> kept_;  // by state number; efforts are totals since the seed
    FrameEffort total_;                   // effort from the seed to the last added state
    FrameEffort reported_;                // part of `total_` that handed-out frames have reported
};

}  // namespace foam::texgen
