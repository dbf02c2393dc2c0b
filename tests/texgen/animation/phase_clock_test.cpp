// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/phase_clock.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

PhaseClock::Clock::time_point at(double seconds) {
    return PhaseClock::Clock::time_point(std::chrono::duration_cast<PhaseClock::Clock::duration>(
        std::chrono::duration<double>(seconds)));
}

RunProgress frames_done(int done) {
    return {.phase = Phase::Frames, .done = done, .total = 12};
}

// The first frame is reported after a simulation of 100 s that also closes the loop. The following
// frames take 2 s each.
TEST(PhaseClock, TheTimeLeftIgnoresTheSlowFirstFrame) {
    PhaseClock clock;
    clock.add({.phase = Phase::LoopClosing, .done = 0, .total = 4, .cycle = 1}, at(0.0));
    clock.add({.phase = Phase::LoopClosing, .done = 4, .total = 4, .cycle = 1}, at(100.0));
    clock.add(frames_done(1), at(101.0));
    EXPECT_EQ(clock.seconds_left(), std::nullopt);
    clock.add(frames_done(2), at(103.0));
    EXPECT_EQ(clock.seconds_left(), std::nullopt);
    clock.add(frames_done(3), at(105.0));
    EXPECT_NEAR(clock.seconds_left().value(), 2.0 * 9, 1e-6);
    EXPECT_NEAR(clock.seconds_in_phase(), 4.0, 1e-6);
    clock.add(frames_done(12), at(123.0));
    EXPECT_NEAR(clock.seconds_left().value(), 0.0, 1e-6);
}

// Four threads begin to draw at 0 s and finish a frame every 8 s, all at nearly the same time. The
// mean since the first frame would be 0.01 s per frame.
TEST(PhaseClock, FramesThatAreDoneTogetherDoNotShortenTheEstimate) {
    PhaseClock clock;
    clock.add(frames_done(0), at(0.0));
    for (int done = 1; done <= 4; ++done) {
        clock.add(frames_done(done), at(8.0 + 0.01 * done));
    }
    EXPECT_NEAR(clock.seconds_per_unit().value(), 2.01, 1e-6);
    EXPECT_NEAR(clock.seconds_left().value(), 2.01 * 8, 1e-6);
}

TEST(PhaseClock, TheTimeLeftRunsDownWhileNothingIsDone) {
    PhaseClock clock;
    clock.add(frames_done(0), at(0.0));
    clock.add(frames_done(1), at(1.0));
    clock.add(frames_done(2), at(2.0));
    EXPECT_EQ(clock.add(frames_done(2), at(4.5)), PhaseClock::News::Nothing);
    EXPECT_NEAR(clock.seconds_left().value(), 10.0 - 2.5, 1e-6);
    clock.advance(at(7.0));  // without a report
    EXPECT_NEAR(clock.seconds_left().value(), 10.0 - 5.0, 1e-6);
    EXPECT_NEAR(clock.seconds_in_phase(), 7.0, 1e-6);
    clock.add(frames_done(2), at(50.0));
    EXPECT_EQ(clock.seconds_left(), 0.0);
}

TEST(PhaseClock, PreparationsHaveASpeedButNoEnd) {
    PhaseClock clock;
    for (int done = 0; done <= 2; ++done) {
        clock.add({.phase = Phase::WarmUp, .done = done, .total = 9}, at(3.0 * done));
    }
    EXPECT_NEAR(clock.seconds_per_unit().value(), 3.0, 1e-6);
    EXPECT_EQ(clock.seconds_left(), std::nullopt);
}

TEST(PhaseClock, TellsWhatIsNew) {
    PhaseClock clock;
    RunProgress closing{.phase = Phase::LoopClosing, .done = 0, .total = 4, .cycle = 1};
    EXPECT_EQ(clock.add(closing, at(0.0)), PhaseClock::News::NewPhase);
    closing.done = 4;
    EXPECT_EQ(clock.add(closing, at(1.0)), PhaseClock::News::Units);
    closing.cycle = 2;
    closing.done = 0;
    EXPECT_EQ(clock.add(closing, at(1.0)), PhaseClock::News::Units);
    EXPECT_EQ(clock.seconds_in_phase(), 0.0);  // each cycle is measured by itself
    EXPECT_EQ(clock.add(frames_done(0), at(2.0)), PhaseClock::News::NewPhase);
}

}  // namespace
}  // namespace foam::texgen
