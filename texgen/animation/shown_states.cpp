// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/shown_states.h"

#include <algorithm>
#include <cmath>

// Frame n of a loop of N frames shows one state, or two states in a cross-fade:
// - In a pingpong, frame n shows the state n if n <= N/2 + 1, otherwise the state N + 2 - n. N is
//   even. The frames of the loop therefore show the states 1, 2, ..., N/2 + 1, ..., 3, 2.
// - In a flow with a fade of A frames, frame n shows the state A + n. Each of the last A frames
//   fades into the state A + n - N, which is one of the A states before the state of frame 1. In
//   frame N, the last one, the state A has nearly replaced the state A + N. Frame 1, which follows,
//   shows the state A + 1.
// - In all other animations, frame n shows the state n.

namespace foam::texgen {

namespace {

int shown_in_pingpong(int number, int count) {
    const int index = (number - 1) % count;
    return 1 + (2 * index <= count ? index : count - index);
}

ShownStates shown_in_flow(int number, const LoopOptions& loop, int count) {
    const int before = states_before_first_frame(loop, count);
    const int index = (number - 1) % count;
    const int state = before + 1 + index;
    const int fading_in = std::max(state - count, 0);
    return {.state = state,
            .next = state + 1,
            .fading_in = fading_in,
            .next_fading_in = std::max(state + 1 - count, 0),
            .fade_progress = static_cast<double>(fading_in) / (before + 1)};
}

}  // namespace

ShownStates shown_states(int number, const LoopOptions& loop, int count) {
    switch (loop.kind) {
        case LoopKind::PingPong:
            return {.state = shown_in_pingpong(number, count),
                    .next = shown_in_pingpong(number + 1, count)};
        case LoopKind::Flow:
            return shown_in_flow(number, loop, count);
        case LoopKind::None:
        case LoopKind::Breathe:
        case LoopKind::Shear:
        case LoopKind::Boil:
        case LoopKind::Drift:
            break;
    }
    return {.state = number, .next = number + 1};
}

int states_before_first_frame(const LoopOptions& loop, int count) {
    if (!loop.is_cross_faded()) {
        return 0;
    }
    return std::clamp(static_cast<int>(std::lround(loop.fade * count)), 1, count);
}

int frame_of_state(int state, const LoopOptions& loop, int count) {
    return std::max(state - states_before_first_frame(loop, count), 1);
}

double loop_progress(int state, const LoopOptions& loop, int count) {
    const int number = state - states_before_first_frame(loop, count) + count;
    return static_cast<double>((number - 1) % count) / count;
}

}  // namespace foam::texgen
