// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/force.h"

#include "tests/texgen/events/event_subject.h"
#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

EventBase force_at(double x, double y) {
    EventBase event;
    event.kind = "force";
    event.frames = {2, 5};
    event.at = {x, y};
    return event;
}

// A push of (2, -1) over four frames displaces the junctions by a quarter of it in each frame. The
// center of the push moves with them.
TEST(Force, MovesAlongWithItsPush) {
    test::EventSubject subject;
    const Domain& domain = subject.foam.domain;
    for (int frame = 2; frame <= 5; ++frame) {
        subject.change = {};
        EventContext context = subject.context(frame);
        advance_force(force_at(0.5, 0.25), {.radius = 1.5, .push = {2.0, -1.0}}, context);
        ASSERT_EQ(subject.change.pushes.size(), 1U);
        const Displacement& push = subject.change.pushes.front();
        const Vec2 start(0.5 * domain.width, 0.25 * domain.height);
        const Vec2 quarter(0.5, -0.25);
        EXPECT_LT((push.center - (start + (frame - 2) * quarter)).norm(), 1e-12);
        EXPECT_LT((push.by - quarter).norm(), 1e-12);
        EXPECT_EQ(push.radius, 1.5);
    }
}

TEST(Force, FitsTheTorus) {
    const EventSetting torus{.is_patch = false, .t2_area = 0.01, .shorter_side = 4.0};
    const EventSetting patch{.is_patch = true, .t2_area = 0.01, .shorter_side = 4.0};
    const EventBase event = force_at(0.0, 0.0);
    const ForceOptions large{.radius = 2.1};
    EXPECT_EQ(test::checked(event, ForceOptions{.radius = 2.0}, check_force, torus), "accepted");
    EXPECT_EQ(test::checked(event, large, check_force, torus, "radius"),
              "radius: must be at most 2, half of the shorter side of the torus");
    EXPECT_EQ(test::checked(event, large, check_force, torus, "push"),
              "foam: event[1].radius must be at most 2, half of the shorter side of the torus");
    EXPECT_EQ(test::checked(event, large, check_force, patch), "accepted");
}

TEST(Force, NeedsAPosition) {
    EventBase event = force_at(0.0, 0.0);
    event.at.reset();
    EXPECT_EQ(test::checked(event, ForceOptions{}, check_force),
              "kind: the event must have the key 'at', the position of the push");
}

TEST(Force, LimitsHoldOnBothSides) {
    test::expect_limits(force_keys(),
                        {{"radius", "0.09", "0.1", "500", "501"},
                         {"push", "[0, -101]", "[0, -100]", "[100, 0]", "[101, 0]"}});
}

}  // namespace
}  // namespace foam::texgen
