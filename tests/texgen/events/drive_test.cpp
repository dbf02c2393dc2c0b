// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/drive.h"

#include "tests/texgen/events/event_subject.h"
#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

EventBase drive_of(const FrameSpan& frames) {
    EventBase event;
    event.kind = "drive";
    event.frames = frames;
    return event;
}

// 12 frames with a period of 8 hold one and a half oscillations.
TEST(Drive, FollowsARampAndAnOscillation) {
    test::EventSubject subject;
    EventBase event = drive_of({3, 14});
    event.bubbles = {5};
    const DriveOptions options{.scale = 2.0, .amplitude = 0.25, .period = 8.0, .phase = 0.5};
    EventContext context = subject.context(3);
    advance_drive(event, options, context);
    ASSERT_EQ(subject.schedules.size(), 1U);
    const DrivenSchedule& driven = subject.schedules.at(5);
    EXPECT_EQ(driven.frames, (FrameSpan{3, 14}));
    EXPECT_DOUBLE_EQ(driven.schedule.from, 1.0);
    EXPECT_DOUBLE_EQ(driven.schedule.to, 2.0);
    EXPECT_DOUBLE_EQ(driven.schedule.amplitude, 0.25);
    EXPECT_DOUBLE_EQ(driven.schedule.oscillations, 1.5);
    EXPECT_DOUBLE_EQ(driven.schedule.phase, 0.5);
    EXPECT_FALSE(driven.vanishes);
}

TEST(Drive, BeginsOnceAndDrivesAllBubblesIfNoneIsNamed) {
    test::EventSubject subject;
    EventContext later = subject.context(4);
    advance_drive(drive_of({3, 14}), {}, later);
    EXPECT_TRUE(subject.schedules.empty());
    EventContext first = subject.context(3);
    advance_drive(drive_of({3, 14}), {}, first);
    EXPECT_EQ(subject.schedules.size(), 16U);
    EXPECT_EQ(test::checked(drive_of({3, 14}), DriveOptions{}, check_drive), "accepted");
}

TEST(Drive, RandomPhasesDifferFromBubbleToBubble) {
    test::EventSubject subject;
    EventContext context = subject.context(3);
    advance_drive(drive_of({3, 14}), {.phases = Phases::Random}, context);
    EXPECT_NE(subject.schedules.at(0).schedule.phase, subject.schedules.at(1).schedule.phase);
    for (const auto& [bubble, driven] : subject.schedules) {
        EXPECT_GE(driven.schedule.phase, 0.0);
        EXPECT_LT(driven.schedule.phase, 1.0);
    }
}

TEST(Drive, LimitsHoldOnBothSides) {
    test::expect_limits(drive_keys(),
                        {{"scale", "0.009", "0.01", "100", "101"},
                         {"amplitude", "-0.1", "0", "0.9", "0.91"},
                         {"period", "0.9", "1", "1e5", "1e6"},
                         {"phase", "-1.1", "-1", "1", "1.1"}});
    test::expect_words(drive_keys(), "phases", {"same", "random"});
}

}  // namespace
}  // namespace foam::texgen
