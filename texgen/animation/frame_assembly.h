#pragma once

#include "texgen/animation/shown_states.h"
#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <map>
#include <vector>

namespace foam::texgen {

/// The presence of the next frame beside each frame. With it the simulation goes on by one frame
/// beyond the last.
enum class NextFrames { LeftOut, HandedOut };

/// Makes the frames of an animation out of the states of a simulation, and hands out each as soon
/// as its states exist: in increasing order, except in a pingpong, which shows a state twice.
/// States are kept no longer than they are needed.
class FrameAssembly {
  public:
    /// Assembles the frames of these numbers.
    FrameAssembly(const Preset& preset,
                  const std::vector<int>& numbers,
                  NextFrames next_frames,
                  FrameVisitor on_frame);

    /// Returns the states that these frames need, in increasing order; for a patch also the first,
    /// which decides the view of all frames.
    std::vector<int> states() const;

    /// Adds a state; states come in that order. Its effort is that since the state before.
    void add(const SimulatedFrame& state);

  private:
    struct Request {
        int number = 0;
        ShownStates shown;
        std::vector<int> states;  // that it takes, the last one last
    };

    Request request_of(int number, const Preset& preset) const;
    void hand_out(const Request& request);
    DrawnState drawn(int state, int next) const;
    void release(const Request& request);
    FrameEffort effort_since_last(const FrameEffort& total);

    bool hands_out_next_;
    FrameVisitor on_frame_;
    std::vector<Request> requests_;       // in the order in which they are handed out
    std::size_t handed_out_ = 0;          // of them
    std::map<int, int> uses_;             // of a state, by the requests that are left
    std::map<int, SimulatedFrame> kept_;  // with totals as their efforts
    FrameEffort total_;                   // from the seed on
    FrameEffort told_;                    // of it, so far
};

}  // namespace foam::texgen
