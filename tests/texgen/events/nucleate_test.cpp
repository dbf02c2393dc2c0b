// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/nucleate.h"

#include "tests/texgen/events/event_subject.h"
#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

EventBase nucleate_of(int count, const FrameSpan& frames) {
    EventBase event;
    event.kind = "nucleate";
    event.count = count;
    event.frames = frames;
    return event;
}

// Two bubbles in frames 2 to 5 begin in the steps to frames 2 and 4. Each one starts with twice the
// T2 area, which is 0.01, and grows for three frames.
TEST(Nucleate, NewBubblesBeginEvenlyAndGrow) {
    test::EventSubject subject;
    const NucleateOptions options{.area = 0.5, .growth = 3};
    for (int frame = 2; frame <= 5; ++frame) {
        EventContext context = subject.context(frame);
        advance_nucleate(nucleate_of(2, {2, 5}), options, context);
        EXPECT_EQ(subject.foam.network.bubble_count(), frame < 4 ? 17U : 18U);
    }
    ASSERT_EQ(subject.schedules.size(), 2U);
    const DrivenSchedule& first = subject.schedules.at(16);
    EXPECT_EQ(first.frames, (FrameSpan{2, 4}));
    EXPECT_NEAR(first.schedule.from, 0.02, 1e-12);
    EXPECT_DOUBLE_EQ(first.schedule.to, 0.5);
    EXPECT_EQ(subject.schedules.at(17).frames, (FrameSpan{4, 6}));
}

TEST(Nucleate, ANewBubbleIsLargerThanTheT2Area) {
    const EventBase event = nucleate_of(1, {2, 2});
    const EventSetting setting{.is_patch = false, .t2_area = 0.2, .shorter_side = 4.0};
    EXPECT_EQ(test::checked(event, NucleateOptions{.area = 0.3}, check_nucleate, setting),
              "accepted");
    EXPECT_EQ(test::checked(event, NucleateOptions{.area = 0.1}, check_nucleate, setting, "area"),
              "area: must be above dynamics.t2_area = 0.2");
    EXPECT_EQ(test::checked(event, NucleateOptions{.area = 0.1}, check_nucleate, setting, "growth"),
              "foam: event[1].area = 0.1 must be above dynamics.t2_area = 0.2");
}

TEST(Nucleate, OnlyOneBubbleBeginsAtAPosition) {
    EventBase event = nucleate_of(2, {2, 3});
    event.at = {0.5, 0.5};
    EXPECT_EQ(test::checked(event, NucleateOptions{}, check_nucleate),
              "count: must be 1 if the event has a position (the key 'at')");
}

TEST(Nucleate, LimitsHoldOnBothSides) {
    test::expect_limits(
        nucleate_keys(),
        {{"area", "0.0001", "0.0002", "100", "101"}, {"growth", "0", "1", "100000", "100001"}});
    test::expect_words(nucleate_keys(), "on", {"junction", "film"});
}

}  // namespace
}  // namespace foam::texgen
