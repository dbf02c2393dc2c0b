// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/collapse.h"

#include "tests/texgen/events/event_subject.h"
#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

EventBase collapse_of(const std::vector<BubbleIdentity>& bubbles, const FrameSpan& frames) {
    EventBase event;
    event.kind = "collapse";
    event.bubbles = bubbles;
    event.frames = frames;
    return event;
}

TEST(Collapse, LeadsToTheT2AreaOverAllFrames) {
    test::EventSubject subject;
    const EventBase event = collapse_of({3, 9}, {2, 6});
    EventContext context = subject.context(2);
    advance_collapse(event, {}, context);
    ASSERT_EQ(subject.schedules.size(), 2U);
    for (const BubbleIdentity bubble : {3U, 9U}) {
        const DrivenSchedule& schedule = subject.schedules.at(bubble);
        EXPECT_EQ(schedule.frames, (FrameSpan{2, 6}));
        EXPECT_DOUBLE_EQ(schedule.schedule.from, 1.0);
        EXPECT_DOUBLE_EQ(schedule.schedule.to, 0.01);
        EXPECT_TRUE(schedule.vanishes);
    }
}

// Two bubbles share the frames 2 to 6. The first one collapses in frames 2 and 3, the second one in
// frames 4 to 6.
TEST(Collapse, BubblesInTurnShareTheFrames) {
    test::EventSubject subject;
    const EventBase event = collapse_of({3, 9}, {2, 6});
    for (int frame = 2; frame <= 6; ++frame) {
        EventContext context = subject.context(frame);
        advance_collapse(event, {.order = EventOrder::InTurn}, context);
        EXPECT_EQ(subject.schedules.size(), frame < 4 ? 1U : 2U);
    }
    EXPECT_EQ(subject.schedules.at(3).frames, (FrameSpan{2, 3}));
    EXPECT_EQ(subject.schedules.at(9).frames, (FrameSpan{4, 6}));
}

// The foam has 16 bubbles, all with six sides.
TEST(Collapse, CountsBubblesThatDoNotExist) {
    test::EventSubject subject;
    EventContext context = subject.context(2);
    advance_collapse(collapse_of({3, 99, 98}, {2, 6}), {}, context);
    EXPECT_EQ(context.missing, 2);
    EventBase by_sides = collapse_of({}, {2, 6});
    by_sides.sides = {6};
    by_sides.count = 20;
    advance_collapse(by_sides, {}, context);
    EXPECT_EQ(context.missing, 6);
}

TEST(Collapse, BubblesInTurnNeedAFrameEach) {
    const CollapseOptions in_turn{.order = EventOrder::InTurn};
    EXPECT_EQ(test::checked(collapse_of({1, 2, 3}, {2, 4}), in_turn, check_collapse), "accepted");
    EXPECT_EQ(
        test::checked(collapse_of({1, 2, 3}, {2, 3}), in_turn, check_collapse),
        "order: 3 bubbles that collapse in turn need at least as many frames; the event has 2");
    EXPECT_EQ(
        test::checked(collapse_of({}, {2, 3}), CollapseOptions{}, check_collapse),
        "kind: the event must have one of the keys bubble, at and sides, which choose bubbles");
}

TEST(Collapse, ChoicesHaveTheirWords) {
    test::expect_words(collapse_keys(), "order", {"at-once", "in-turn"});
}

}  // namespace
}  // namespace foam::texgen
