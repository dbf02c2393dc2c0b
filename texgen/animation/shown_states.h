// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/loop.h"

namespace foam::texgen {

/// The states of the simulation, numbered from 1, that a frame of the animation shows.
struct ShownStates {
    int state = 1;
    int next = 2;       // the state that follows `state` in the animation, for maps that need it
    int fading_in = 0;  // the state into which `state` fades; 0 without a cross-fade
    // The state into which `next` fades; 0 if `next` does not fade. In the last frame of a flow,
    // this is the state of frame 1, which has then completely replaced `next`.
    int next_fading_in = 0;
    double fade_progress = 0.0;  // fraction of the fade that has passed, from 0 to 1

    bool is_cross_fade() const { return fading_in > 0; }

    friend bool operator==(const ShownStates&, const ShownStates&) = default;
};

/// Returns the states that frame `number`, counted from 1, shows in a loop of `count` frames. A
/// pingpong shows the states up to its middle and then the same states backwards. In a flow, the
/// simulation computes states_before_first_frame states before the state of frame 1. The same
/// number of frames at the end of the loop fade into these states. Frame 1 shows the state that
/// follows these states, which closes the loop.
ShownStates shown_states(int number, const LoopOptions& loop, int count);

/// Returns the number of states that the simulation computes before the state of frame 1. The
/// number is 0 except in a flow.
int states_before_first_frame(const LoopOptions& loop, int count);

/// Returns the first frame whose ShownStates::state is the given state, or 1 if the state precedes
/// the state of frame 1.
int frame_of_state(int state, const LoopOptions& loop, int count);

/// Returns the fraction of a loop of `count` frames that precedes a state: at least 0 and below 1.
/// It is 0 for the state of frame 1, and repeats after `count` states.
double loop_progress(int state, const LoopOptions& loop, int count);

}  // namespace foam::texgen
