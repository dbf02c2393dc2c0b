// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/current.h"
#include "texgen/animation/fade_order.h"
#include "texgen/animation/shown_states.h"
#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace foam::texgen {

/// Selects whether the visitor receives each frame together with the frame after it. With
/// NextFrames::Included, the simulation also computes the state that follows the last frame, unless
/// it has already computed this state.
enum class NextFrames { Omitted, Included };

/// Assembles the frames of an animation from the states of a simulation. Emits each frame, that is,
/// passes it to the visitor, as soon as all states that it needs exist. The frames are usually
/// emitted in increasing order. In a pingpong (LOOPS.md), the second half shows states of the first
/// half, so that its frames are emitted among the frames of the first half. In a pingpong or a
/// flow, a frame after the first period is emitted together with the frame of the first period that
/// shows the same state. States are released when no further frame needs them. If `loop.current` is
/// above 0, frames show the foam as this current displaces it (current.h).
class FrameAssembly {
  public:
    /// Prepares the frames with the given numbers. `on_frame` is called for each of them.
    FrameAssembly(const Preset& preset,
                  const std::vector<int>& numbers,
                  NextFrames next_frames,
                  FrameVisitor on_frame);

    /// Returns the numbers of the states that the frames need, in increasing order. The state of
    /// frame 1 is always included, because some maps show colors of frame 1. This state also
    /// determines the view of all frames of a patch.
    std::vector<int> states() const;

    /// Adds a state and emits the frames that are complete with it. Precondition: states are added
    /// in the order of states(), and the effort of each state covers the steps since the preceding
    /// state that the simulation passed on or stored. The effort consists of T1s, T2s, computing
    /// time and events. For the first state, it covers all steps since the start of the simulation.
    void add(const SimulatedFrame& state);

    /// Adds the effort of a state that no frame needs; the next frame reports it. No frame reports
    /// efforts that are not added. Precondition: this function and add() are called in the order of
    /// the numbers of the states.
    void add_effort(const FrameEffort& effort);

  private:
    struct Request {
        int number = 0;
        ShownStates shown;
        std::vector<int> states;  // states that the frame needs, in increasing order
    };

    SimulatedFrame prepared(const SimulatedFrame& state) const;
    void keep(const SimulatedFrame& state);
    std::shared_ptr<const FrameOne> frame_one_of(const SimulatedFrame& state) const;
    Request request_of(int number, const Preset& preset) const;
    void emit(const Request& request);
    void add_cross_fade(const Request& request, SimulatedFrame& frame) const;
    void move_next(const ShownStates& shown, SimulatedFrame& frame) const;
    DrawnState drawn(int state, int next) const;
    void release(const Request& request);
    FrameEffort effort_since_last(const FrameEffort& total, std::size_t event_count);

    bool includes_next_;
    LoopOptions loop_;
    int count_;                               // number of frames of the loop
    int first_state_;                         // the state that frame 1 shows
    std::shared_ptr<const FrameOne> first_;   // frame 1, after its state was added
    std::shared_ptr<const Current> current_;  // null if there is none
    std::optional<FadeOrder> fade_order_;
    FrameVisitor on_frame_;
    std::vector<Request> requests_;  // in the order in which their frames are emitted
    std::size_t emitted_ = 0;        // number of requests whose frames were emitted
    std::map<int, int> uses_;        // by state: number of requests, not yet emitted, that need it
    // The kept states, by number. Their efforts are totals since the start of the simulation and
    // contain no lists of events.
    std::map<int, SimulatedFrame> kept_;
    // By kept state: the number of events from the start of the simulation to this state.
    std::map<int, std::size_t> event_counts_;
    FrameEffort total_;     // effort from the start of the simulation to the last added state
    FrameEffort reported_;  // part of `total_` that emitted frames have reported
    std::size_t event_count_ = 0;            // number of events up to the last added state
    std::vector<TopologyEvent> unreported_;  // events that no emitted frame has reported yet
};

/// Returns the numbers of the states that frames need, in increasing order.
std::vector<int> states_of(const Preset& preset,
                           const std::vector<int>& frames,
                           NextFrames next_frames);

}  // namespace foam::texgen
