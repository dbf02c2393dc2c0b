// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/loop.h"

namespace foam::texgen {

/// The states of the simulation, numbered from 1, that a frame of the animation shows.
struct ShownStates {
    int state = 1;
    int next = 2;        // the state of the next frame
    int rising = 0;      // in a cross-fade, the state that replaces `state`; otherwise 0
    double faded = 0.0;  // fraction of the fade that has passed, from 0 to 1

    /// Returns the state after `rising`.
    int rising_next() const { return rising + 1; }
    bool is_cross_fade() const { return rising > 0; }

    friend bool operator==(const ShownStates&, const ShownStates&) = default;
};

/// Returns the states that frame `number`, counted from 1, shows in a loop of `count` frames. A
/// pingpong shows the states up to its middle and then the same states backwards. In a flow,
/// states_ahead states precede the state of frame 1, and as many frames at the end of the loop fade
/// into them. The state that follows these states is shown by frame 1, which closes the loop.
ShownStates shown_states(int number, const LoopOptions& loop, int count);

/// Returns the number of states before the state of frame 1; 0 except in a flow.
int states_ahead(const LoopOptions& loop, int count);

/// Returns the first frame whose ShownStates::state is the given state, or 1 if the state precedes
/// the state of frame 1.
int frame_of_state(int state, const LoopOptions& loop, int count);

}  // namespace foam::texgen
