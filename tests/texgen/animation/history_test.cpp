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

// With a smoothing of 3 frames, an average moves by a quarter of its distance from the present
// value per frame. A new bubble starts with its first values. The bubbles have the mean area 1, so
// that the average of a pressure p is the average of p / (1 + p).
TEST(History, AveragesFollowTheFoamWithALag) {
    Foam foam = honeycomb(4, 4);
    History history(foam, 3.0);
    foam.pressures[BubbleId{2}] = 1.0;
    history.average_values(foam);
    EXPECT_NEAR(history.record().averages.bubbles[2].pressure, 0.5, 1e-12);
    foam.pressures[BubbleId{2}] = 9.0;
    history.average_values(foam);
    EXPECT_NEAR(history.record().averages.bubbles[2].pressure, 0.6, 1e-12);
    history.average_values(foam);
    EXPECT_NEAR(history.record().averages.bubbles[2].pressure, 0.675, 1e-12);
    nucleate_at_junction(foam, JunctionId{0}, 0.01);
    history.average_values(foam);
    ASSERT_EQ(history.record().averages.bubbles.size(), 17U);
    EXPECT_EQ(history.record().averages.bubbles[16].sides, 3.0);
}

// A boiling bubble has the same identity in each life.
TEST(History, ANewLifeHasItsOwnBirthAndAverages) {
    Foam foam = honeycomb(4, 4);
    History history(foam, 3.0);
    foam.pressures[BubbleId{2}] = 1.0;
    history.average_values(foam);
    foam.events = {{TopologyEventKind::Birth, 4.5, {0.0, 0.0}, {2, 1, 3}}};
    foam.pressures[BubbleId{2}] = 9.0;
    history.record_events(foam, 2);
    history.average_values(foam);
    EXPECT_EQ(history.record().births[2], 4.5);
    EXPECT_EQ(history.record().births[1], 0.0);
    EXPECT_NEAR(history.record().averages.bubbles[2].pressure, 0.9, 1e-12);
}

// The averages of a bubble that was born in the cycle do not depend on those before the cycle.
TEST(History, ClosedAveragesOfANewLifeStay) {
    Foam foam = honeycomb(4, 4);
    History history(foam, 3.0);
    history.record_events(foam, 1);
    foam.pressures[BubbleId{2}] = 40.0;
    history.average_values(foam);
    const FoamRecord start = history.record();
    foam.events = {{TopologyEventKind::Birth, 0.5, {0.0, 0.0}, {2}}};
    foam.pressures[BubbleId{2}] = 1.0;
    history.record_events(foam, 2);
    history.average_values(foam);
    history.close_averages(start, 1);
    EXPECT_NEAR(history.record().averages.bubbles[2].pressure, 0.5, 1e-12);
}

TEST(History, WithoutSmoothingThereAreNoAverages) {
    const Foam foam = honeycomb(4, 4);
    History history(foam);
    history.average_values(foam);
    EXPECT_TRUE(history.record().averages.bubbles.empty());
}

// One cycle from any start, closed, gives the averages that a second cycle reproduces.
TEST(History, ClosedAveragesRepeatAfterOneCycle) {
    Foam foam = honeycomb(4, 4);
    History history(foam, 5.0);
    history.record_events(foam, 1);
    foam.pressures[BubbleId{2}] = 40.0;  // a transient that must be forgotten
    history.average_values(foam);
    const auto run_cycle = [&] {
        for (const double pressure : {1.0, 4.0, 2.0, -3.0}) {
            foam.pressures[BubbleId{2}] = pressure;
            history.average_values(foam);
        }
        return history.record().averages.bubbles[2].pressure;
    };
    const FoamRecord start = history.record();
    run_cycle();
    history.close_averages(start, 4);
    const double closed = history.record().averages.bubbles[2].pressure;
    EXPECT_NEAR(run_cycle(), closed, 1e-12);
    EXPECT_LT(closed, 0.8);
    EXPECT_GT(closed, -0.75);
}

// Each shear displaces an event by the strain times its y coordinate. The shear of the domain wraps
// around at a whole width; this wrap must not displace events. Steps of more than half of the width
// occur in tall tori.
TEST(History, CarriesEventsAlongWithAShear) {
    Foam foam = honeycomb(4, 4);
    History history(foam);
    history.record_events(foam, 1);
    const double top = foam.domain.height;
    const double whole_width = foam.domain.width / top;
    double strain = 0.0;
    foam.events = {event_at(0.0, {1.0, 0.0}), event_at(0.0, {1.0, 0.5 * top})};
    history.record_events(foam, 2);
    for (int frame = 3; frame <= 12; ++frame) {
        const double step = (frame % 2 == 0 ? 0.1 : 0.94) * whole_width;
        shear(foam, step);
        strain += step;
        history.record_events(foam, frame, strain);
    }
    EXPECT_NEAR(history.record().events[0].position.x(), 1.0, 1e-12);
    EXPECT_NEAR(history.record().events[1].position.x(), 1.0 + 0.5 * top * strain, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
