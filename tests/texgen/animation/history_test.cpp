// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/history.h"

#include "core/dynamics/nucleation.h"
#include "core/dynamics/shear.h"
#include "core/foam/honeycomb.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TopologyEvent event_at(double time,
                       const Vec2& position,
                       std::vector<BubbleIdentity> bubbles = {}) {
    return {TopologyEventKind::T1, time, position, std::move(bubbles)};
}

TEST(History, EventsBelongToTheFrameThatShowsThemFirst) {
    Foam foam = honeycomb(4, 4);
    History history(foam);
    foam.events = {event_at(0.0, {1.0, 1.0})};  // before frame 1
    history.record_events(foam, 1);
    history.forget_events();
    EXPECT_TRUE(history.record().events.empty());
    EXPECT_TRUE(foam.events.empty());
    foam.events = {event_at(0.5, {2.0, 1.0})};
    history.record_events(foam, 2);
    foam.events = {event_at(1.5, {3.0, 1.0})};
    history.record_events(foam, 3);
    EXPECT_EQ(history.record().events,
              (std::vector<RecordedEvent>{{TopologyEventKind::T1, 2, {2.0, 1.0}},
                                          {TopologyEventKind::T1, 3, {3.0, 1.0}}}));
    history.record_events(foam, 1 + kRecordedFrames);
    EXPECT_EQ(history.record().events.size(), 2U);
    history.record_events(foam, 2 + kRecordedFrames);
    EXPECT_EQ(history.record().events.size(), 1U);
}

// When a cycle of 4 frames starts again, an event in the step to frame 3 becomes an event in the
// step to frame -1.
TEST(History, RenumbersTheFramesOfACycle) {
    Foam foam = honeycomb(4, 4);
    History history(foam);
    foam.events = {event_at(0.5, {2.0, 1.0})};
    history.record_events(foam, 3);
    history.renumber(-4);
    ASSERT_EQ(history.record().events.size(), 1U);
    EXPECT_EQ(history.record().events.front().frame, -1);
}

TEST(History, RecordsBirthsAndChangesOfBubbles) {
    Foam foam = honeycomb(4, 4);
    History history(foam);
    foam.events = {event_at(0.25, {0.0, 0.0}, {3, 5})};
    foam.time = 2.0;
    history.record_events(foam, 1);
    EXPECT_EQ(history.record().births, std::vector<double>(16, 0.0));
    EXPECT_EQ(history.record().changes[5], 0.25);
    EXPECT_EQ(history.record().changes[4], 0.0);
    nucleate_at_junction(foam, JunctionId{0}, 0.01);
    foam.time = 3.0;
    history.record_events(foam, 2);
    ASSERT_EQ(history.record().births.size(), 17U);
    EXPECT_EQ(history.record().births[16], 2.0);
    EXPECT_EQ(history.record().changes[16], 2.0);
    EXPECT_EQ(history.record().births[3], 0.0);
}

// Each shear displaces an event by the strain times its y coordinate. The shear of the domain wraps
// around at a whole width; this wrap must not displace events.
TEST(History, CarriesEventsAlongWithAShear) {
    Foam foam = honeycomb(4, 4);
    History history(foam);
    history.record_events(foam, 1);
    const double top = foam.domain.height;
    foam.events = {event_at(0.0, {1.0, 0.0}), event_at(0.0, {1.0, 0.5 * top})};
    history.record_events(foam, 2);
    for (int frame = 3; frame <= 12; ++frame) {
        shear(foam, 0.1);
        history.record_events(foam, frame);
    }
    EXPECT_NEAR(history.record().events[0].position.x(), 1.0, 1e-12);
    EXPECT_NEAR(history.record().events[1].position.x(), 1.0 + 0.5 * top, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
