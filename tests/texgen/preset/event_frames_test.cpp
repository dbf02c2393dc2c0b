// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/event_frames.h"

#include "texgen/events/all_events.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

FrameSpan span_of(double from, double to, const FramesOptions& frames) {
    Event event;
    event.time = {from, to};
    return frames_of(event, frames).value();
}

// Returns options with which frame k shows the foam time 0.1 (k - 1).
FramesOptions tenths() {
    FramesOptions frames;
    frames.time_step = 0.1;
    return frames;
}

TEST(EventFrames, AreThoseThatTheEventNames) {
    Event event;
    event.frames = {3, 7};
    EXPECT_EQ(frames_of(event, tenths()), (FrameSpan{3, 7}));
}

TEST(EventFrames, AnInstantHasTheFirstFrameThatIsNotBeforeIt) {
    EXPECT_EQ(span_of(0.0, 0.0, tenths()), (FrameSpan{2, 2}));
    EXPECT_EQ(span_of(0.3, 0.3, tenths()), (FrameSpan{4, 4}));
    EXPECT_EQ(span_of(0.31, 0.31, tenths()), (FrameSpan{5, 5}));
}

// 0.1 has no exact binary representation, so the sum of three steps is not exactly 0.3.
TEST(EventFrames, OfATimeSpanAreTheFramesThatItTouches) {
    EXPECT_EQ(span_of(0.0, 0.3, tenths()), (FrameSpan{2, 4}));
    EXPECT_EQ(span_of(0.3, 0.5, tenths()), (FrameSpan{5, 6}));
    EXPECT_EQ(span_of(0.32, 0.38, tenths()), (FrameSpan{5, 5}));
    EXPECT_EQ(span_of(0.32, 0.41, tenths()), (FrameSpan{5, 6}));
}

TEST(EventFrames, CountFromTheWarmUpAndGrowWithTheSteps) {
    FramesOptions frames;  // frame 1 shows 10, then 11, 13, 17, 25
    frames.warm_up = 10.0;
    frames.step_growth = 2.0;
    EXPECT_EQ(span_of(5.0, 5.0, frames), (FrameSpan{2, 2}));
    EXPECT_EQ(span_of(11.0, 17.0, frames), (FrameSpan{3, 4}));
    EXPECT_EQ(span_of(18.0, 18.0, frames), (FrameSpan{5, 5}));
}

TEST(EventFrames, AreEmptyIfTheTimeIsNeverReached) {
    FramesOptions frames;
    frames.step_growth = 0.5;  // the time stays below 2
    Event event;
    event.time = {3.0, 4.0};
    EXPECT_FALSE(frames_of(event, frames).has_value());
    event.time = {1.0, 2.5};
    EXPECT_FALSE(frames_of(event, frames).has_value());
}

}  // namespace
}  // namespace foam::texgen
