#pragma once

#include "texgen/animation/shown_states.h"
#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <map>
#include <vector>

namespace foam::texgen {

/// Whether frames come with those after them, for which the simulation goes on by one frame beyond
/// the last.
enum class NextFrames { LeftOut, HandedOut };

/// Makes the frames of an animation out of the states of a simulation, and hands out each as soon
/// as it can: in increasing order, but in a pingpong, where a state is shown on both ways, in the
/// order in which the simulation comes by. States are kept no longer than they are needed.
class FrameAssembly {
  public:
    /// Of the frames of these numbers.
    FrameAssembly(const Preset& preset,
                  const std::vector<int>& numbers,
                  NextFrames next_frames,
                  FrameVisitor on_frame);

    /// The states that these frames take, in increasing order; of a patch the first as well, which
    /// decides what all of them see.
    std::vector<int> states() const;

    /// Takes one of them in; they come in that order. Its effort is that since the state before.
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
