// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/chosen_bubbles.h"

#include "tests/texgen/events/event_subject.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

std::vector<BubbleIdentity> identities(const std::vector<ChosenBubble>& chosen) {
    std::vector<BubbleIdentity> all;
    for (const ChosenBubble& one : chosen) {
        all.push_back(one.bubble);
    }
    return all;
}

TEST(ChosenBubbles, AreFoundByIdentityFromAnIndex) {
    test::EventSubject subject;
    EventBase event;
    event.bubbles = {3, 5, 99, 8};  // 99 does not exist
    const EventContext context = subject.context(2);
    EXPECT_EQ(identities(choose_bubbles(event, context, 0, 4)),
              (std::vector<BubbleIdentity>{3, 5, 8}));
    EXPECT_EQ(identities(choose_bubbles(event, context, 1, 1)), (std::vector<BubbleIdentity>{5}));
    EXPECT_DOUBLE_EQ(choose_bubbles(event, context, 0, 1).front().area, 1.0);
}

TEST(ChosenBubbles, AreFoundByTheirNumberOfSides) {
    test::EventSubject subject;
    subject.foam.target_areas[id_at<BubbleId>(6)] = 0.5;
    EventBase event;
    event.sides = {4, 6};  // no hexagon has four sides
    EXPECT_EQ(choose_bubbles(event, subject.context(2), 0, 3).size(), 3U);
    event.sides = {4};
    EXPECT_TRUE(choose_bubbles(event, subject.context(2), 0, 3).empty());
}

// Three hexagons are smaller than the others: in increasing order 6, 9 and 2.
TEST(ChosenBubbles, ANumberOfSidesThatIsListedTwiceChoosesNoBubbleTwice) {
    test::EventSubject subject;
    subject.foam.target_areas[id_at<BubbleId>(6)] = 0.5;
    subject.foam.target_areas[id_at<BubbleId>(9)] = 0.6;
    subject.foam.target_areas[id_at<BubbleId>(2)] = 0.7;
    EventBase event;
    event.sides = {6, 6};
    EXPECT_EQ(identities(choose_bubbles(event, subject.context(2), 0, 3)),
              (std::vector<BubbleIdentity>{6, 9, 2}));
    EXPECT_EQ(choose_bubbles(event, subject.context(2), 0, 99).size(), 16U);
}

TEST(ChosenBubbles, AreAllWithoutACount) {
    test::EventSubject subject;
    EXPECT_EQ(choose_bubbles({}, subject.context(2), 0, 0).size(), 16U);
    subject.foam.lone_bubbles.push_back({40, {0.0, 0.0}, 0.7});
    const auto all = choose_bubbles({}, subject.context(2), 0, 0);
    EXPECT_EQ(all.back().bubble, 40U);
    EXPECT_EQ(all.back().area, 0.7);
}

TEST(ChosenBubbles, AreChosenInOneWay) {
    const auto check = [](const EventCheck& checked, const bool& all) {
        check_choice(checked, all);
    };
    const auto message = [&](const EventBase& event, bool may_choose_all) {
        return test::checked<bool>(event, may_choose_all, check);
    };
    EventBase event;
    EXPECT_EQ(message(event, true), "accepted");
    EXPECT_EQ(
        message(event, false),
        "kind: the event must have one of the keys bubble, at and sides, which choose bubbles");
    event.bubbles = {3};
    EXPECT_EQ(message(event, false), "accepted");
    event.at = {0.0, 0.0};
    EXPECT_EQ(message(event, false), "at: only one of the keys bubble, at and sides may be given");
    event.sides = {5};
    EXPECT_EQ(message(event, false),
              "sides: only one of the keys bubble, at and sides may be given");
}

}  // namespace
}  // namespace foam::texgen
