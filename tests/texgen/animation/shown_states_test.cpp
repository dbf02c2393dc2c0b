// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/shown_states.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(ShownStates, MostAnimationsShowTheStatesInOrder) {
    const LoopOptions loop{.kind = LoopKind::Breathe};
    EXPECT_EQ(shown_states(7, loop, 4), (ShownStates{.state = 7, .next = 8}));
    EXPECT_EQ(states_before_first_frame(loop, 4), 0);
    EXPECT_EQ(frame_of_state(7, loop, 4), 7);
}

// The six frames of the loop show the states 1 2 3 4 3 2.
TEST(ShownStates, APingpongReversesAtItsMiddle) {
    const LoopOptions loop{.kind = LoopKind::PingPong};
    EXPECT_EQ(shown_states(4, loop, 6), (ShownStates{.state = 4, .next = 3}));
    EXPECT_EQ(shown_states(6, loop, 6), (ShownStates{.state = 2, .next = 1}));
    EXPECT_EQ(shown_states(7, loop, 6), (ShownStates{.state = 1, .next = 2}));
}

// The last three of eight frames fade. The frames show states 4 to 11. The last three also show
// states 1 to 3, which precede state 4, so that frame 1 follows.
TEST(ShownStates, AFlowFadesIntoTheStatesAheadOfItsFirst) {
    const LoopOptions loop{.kind = LoopKind::Flow, .fade = 0.375};
    EXPECT_EQ(states_before_first_frame(loop, 8), 3);
    EXPECT_EQ(shown_states(1, loop, 8), (ShownStates{.state = 4, .next = 5}));
    EXPECT_EQ(shown_states(4, loop, 8), (ShownStates{.state = 7, .next = 8}));
    EXPECT_EQ(shown_states(5, loop, 8), (ShownStates{.state = 8, .next = 9, .next_fading_in = 1}));
    for (int k = 1; k <= 3; ++k) {
        const ShownStates shown = shown_states(5 + k, loop, 8);
        EXPECT_EQ(shown.state, 8 + k);
        EXPECT_EQ(shown.next, 9 + k);
        EXPECT_EQ(shown.fading_in, k);
        EXPECT_EQ(shown.next_fading_in, k + 1);
    }
    EXPECT_EQ(shown_states(9, loop, 8), shown_states(1, loop, 8));
    EXPECT_EQ(shown_states(8, loop, 8).next_fading_in, shown_states(9, loop, 8).state);
    EXPECT_EQ(frame_of_state(11, loop, 8), 8);
    EXPECT_EQ(frame_of_state(2, loop, 8), 1);
}

// The fractions 0 and 1 belong to the frames before and after the fade.
TEST(ShownStates, AFadeGoesOnEvenly) {
    const LoopOptions loop{.kind = LoopKind::Flow, .fade = 0.375};
    EXPECT_DOUBLE_EQ(shown_states(6, loop, 8).fade_progress, 0.25);
    EXPECT_DOUBLE_EQ(shown_states(7, loop, 8).fade_progress, 0.5);
    EXPECT_DOUBLE_EQ(shown_states(8, loop, 8).fade_progress, 0.75);
}

TEST(ShownStates, AllFramesOfAFlowMayFade) {
    const LoopOptions loop{.kind = LoopKind::Flow, .fade = 1.0};
    EXPECT_EQ(shown_states(1, loop, 4).fading_in, 1);
    EXPECT_EQ(shown_states(4, loop, 4).fading_in, 4);
    EXPECT_EQ(shown_states(4, loop, 4).next_fading_in, shown_states(5, loop, 4).state);
    // However short the fade, a frame has it.
    EXPECT_EQ(states_before_first_frame({.kind = LoopKind::Flow, .fade = 0.01}, 4), 1);
    EXPECT_EQ(shown_states(1, {.kind = LoopKind::Flow, .fade = 0.01}, 1).fading_in, 1);
}

}  // namespace
}  // namespace foam::texgen
