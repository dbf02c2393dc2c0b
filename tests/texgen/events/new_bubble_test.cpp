// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/new_bubble.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/events/event_subject.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam::texgen {
namespace {

TEST(NewBubble, HasThreeSidesAtAJunctionAndTwoOnAFilm) {
    test::EventSubject subject;
    const auto at_junction =
        nucleate_near(NucleationSite::Junction, {1.0, 1.0}, 0.02, subject.foam);
    ASSERT_TRUE(at_junction.has_value());
    EXPECT_EQ(subject.foam.network.sides(*at_junction), 3);
    const auto on_film = nucleate_near(NucleationSite::Film, {3.0, 3.0}, 0.02, subject.foam);
    ASSERT_TRUE(on_film.has_value());
    EXPECT_EQ(subject.foam.network.sides(*on_film), 2);
    EXPECT_EQ(subject.foam.network.bubble_count(), 18U);
}

TEST(NewBubble, NeedsFoamAround) {
    Foam patch = foam::test::patch_foam(12, 3);
    EXPECT_FALSE(nucleate_near(NucleationSite::Film, {100.0, 0.0}, 0.02, patch).has_value());
    Random random(5);
    EXPECT_TRUE(nucleate_anywhere(NucleationSite::Film, 0.02, random, patch).has_value());
}

// The first area is twice the T2 area, but at most the final area.
TEST(NewBubble, BeginsSmall) {
    EXPECT_DOUBLE_EQ(first_area(0.5, 0.01), 0.02);
    EXPECT_DOUBLE_EQ(first_area(0.015, 0.01), 0.015);
}

TEST(NewBubble, GrowsToItsArea) {
    test::EventSubject subject;
    grow_bubble(subject.foam, id_at<BubbleId>(4), {3, 5}, 1.5, subject.schedules);
    const DrivenSchedule& driven = subject.schedules.at(4);
    EXPECT_EQ(driven.frames, (FrameSpan{3, 5}));
    EXPECT_DOUBLE_EQ(driven.schedule.from, 1.0);
    EXPECT_DOUBLE_EQ(driven.schedule.to, 1.5);
    EXPECT_FALSE(driven.vanishes);
}

}  // namespace
}  // namespace foam::texgen
