// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/boiling.h"

#include "core/dynamics/collapse.h"
#include "core/foam/corners.h"
#include "core/foam/locate.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace foam {
namespace {

constexpr int kSteps = 48;

TEST(Boiling, BubblesAreFarApartAndTheirBirthsSpreadOverTheCycle) {
    const Foam foam = test::equilibrated_foam(200, 1);
    Random random(1);
    const std::vector<BoilingBubble> boiling =
        choose_boiling_bubbles(foam, 0.12, 2.5, kSteps, random);
    ASSERT_EQ(boiling.size(), 24U);
    double nearest = std::numeric_limits<double>::infinity();
    for (const BoilingBubble& one : boiling) {
        for (const BoilingBubble& other : boiling) {
            if (one.identity != other.identity) {
                nearest = std::min(
                    nearest,
                    foam.domain.nearest_copy(one.last_position - other.last_position).norm());
            }
        }
    }
    EXPECT_GT(nearest, 1.8);  // the mean bubble has a diameter of 1.13
    for (int quarter = 0; quarter < 4; ++quarter) {
        EXPECT_EQ(std::ranges::count_if(boiling,
                                        [&](const BoilingBubble& bubble) {
                                            return bubble.birth / (kSteps / 4) == quarter;
                                        }),
                  6);
    }
}

TEST(Boiling, AreaRisesAreMultiplesOfTheTargetAreas) {
    const Foam foam = test::equilibrated_foam(30, 1);
    Random random(1);
    for (const BoilingBubble& bubble : choose_boiling_bubbles(foam, 0.2, 0.75, kSteps, random)) {
        const double area = foam.target_areas[find_bubble(foam, bubble.identity).value()];
        EXPECT_DOUBLE_EQ(bubble.area_rise, 0.75 * area);
    }
}

TEST(Boiling, AtLeastOneBubbleBoils) {
    Random random(1);
    const Foam foam = test::equilibrated_foam(20, 1);
    EXPECT_EQ(choose_boiling_bubbles(foam, 0.001, 2.5, kSteps, random).size(), 1U);
}

TEST(Boiling, LoneBubblesDoNotBoil) {
    Random random(1);
    Foam foam = test::double_bubble(1.0, 1.0);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{0}, counts));
    compact(foam);
    ASSERT_EQ(foam.lone_bubbles.size(), 1U);
    EXPECT_TRUE(choose_boiling_bubbles(foam, 0.5, 2.5, kSteps, random).empty());
    EXPECT_FALSE(give_birth(foam, {.identity = 0}, 0.02));
}

// The life takes 43 of 48 steps, so that the bubble is absent at 6 positions, where an area would
// be needed at the ages 0 and 43 to 47.
TEST(Boiling, TheAreaRisesAndFallsAndTheBubbleIsAbsentForATenth) {
    const BoilingBubble bubble{.birth = 40, .area_rise = 2.0};
    int absent = 0;
    double largest = 0.0;
    for (int position = 0; position < kSteps; ++position) {
        const auto area = area_at(bubble, position, kSteps, 0.02);
        absent += area ? 0 : 1;
        largest = std::max(largest, area.value_or(0.0));
    }
    EXPECT_EQ(absent, 6);
    EXPECT_NEAR(largest, 2.02, 0.01);
    EXPECT_FALSE(area_at(bubble, 40, kSteps, 0.02));
    EXPECT_NEAR(*area_at(bubble, 41, kSteps, 0.02), 0.02 + 2.0 * 0.00533, 1e-4);
    EXPECT_EQ(area_at(bubble, 41 + 3 * kSteps, kSteps, 0.02), area_at(bubble, 41, kSteps, 0.02));
}

// The birth undoes the T2, although another junction is nearer to the recorded position.
TEST(Boiling, IsBornWhereTheSameBubblesMeet) {
    Foam foam = test::equilibrated_foam(40, 1);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{7}, counts));
    compact(foam);
    BoilingBubble bubble{.identity = 7};
    record_end(bubble, foam.events.back(), {0.1, -0.2});
    EXPECT_EQ(bubble.last_position, Vec2(foam.events.back().position + Vec2(0.1, -0.2)));
    EXPECT_EQ(bubble.neighbors->size(), 3U);
    EXPECT_TRUE(bubble.neighbors_changed);
    bubble.last_position += Vec2(2.0, 2.0);
    ASSERT_TRUE(give_birth(foam, bubble, 0.02));
    const TopologyEvent& birth = foam.events.back();
    EXPECT_EQ(std::set<BubbleIdentity>(birth.bubbles.begin() + 1, birth.bubbles.end()),
              bubble.neighbors);
    record_end(bubble, foam.events[foam.events.size() - 2], {0.0, 0.0});
    EXPECT_FALSE(bubble.neighbors_changed);
}

// A lone bubble vanishes between no bubbles.
TEST(Boiling, NeighborsAreTheSameAfterTwoVanishingsAsALoneBubble) {
    const TopologyEvent end{TopologyEventKind::T2, 1.0, {0.0, 0.0}, {7}};
    BoilingBubble bubble{.identity = 7};
    record_end(bubble, end, {0.0, 0.0});
    EXPECT_TRUE(bubble.neighbors_changed);
    record_end(bubble, end, {0.0, 0.0});
    EXPECT_FALSE(bubble.neighbors_changed);
}

TEST(Boiling, IsBornAtTheNearestJunctionIfItsNeighborsHaveParted) {
    Foam foam = test::equilibrated_foam(40, 1);
    const JunctionId junction{11};
    const BoilingBubble bubble{.identity = foam.next_identity++,
                               .last_position = foam.positions[junction] + Vec2(0.01, 0.0),
                               .neighbors = std::set<BubbleIdentity>{0, 1, 39}};
    ASSERT_TRUE(give_birth(foam, bubble, 0.02));
    const std::optional<BubbleId> born = find_bubble(foam, bubble.identity);
    ASSERT_TRUE(born);
    const Vec2 away = mean_corner(foam, *born) - bubble.last_position;
    EXPECT_LT(foam.domain.nearest_copy(away).norm(), 0.1);
}

}  // namespace
}  // namespace foam
