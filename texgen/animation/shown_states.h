#pragma once

#include "texgen/preset/loop.h"

namespace foam::texgen {

/// What a frame of the animation shows of the simulation, whose states are numbered from 1.
struct ShownStates {
    int state = 1;
    int next = 2;        // where it goes, as the frame after it shows
    int rising = 0;      // of a cross-fade, what takes the place of `state`; otherwise 0
    double faded = 0.0;  // the part of the fade that has passed, from 0 to 1

    /// Where `rising` goes.
    int rising_next() const { return rising + 1; }
    bool is_cross_fade() const { return rising > 0; }

    friend bool operator==(const ShownStates&, const ShownStates&) = default;
};

/// Of frame `number`, from 1, of a loop of `count` frames. A pingpong comes back from the middle.
/// A flow has states ahead of the one that frame 1 shows, as many as frames fade: a period before
/// the last ones, these rise in them, so that the state after the last of them is that of frame 1.
ShownStates shown_states(int number, const LoopOptions& loop, int count);

/// How many states of a flow come before the one of frame 1; of all else none.
int states_ahead(const LoopOptions& loop, int count);

/// The first frame that shows a state in full, or would.
int frame_of_state(int state, const LoopOptions& loop, int count);

}  // namespace foam::texgen
