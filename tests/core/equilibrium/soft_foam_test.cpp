// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/soft_foam.h"

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

constexpr double kStiffness = 10.0;
constexpr double kRounding = 1e-13;
constexpr BubbleId kBubble{5};
constexpr double kPi = std::numbers::pi;

// Returns a honeycomb of area 1 per bubble and pressure 0, in which one bubble has the given target
// area.
Foam with_target(double target) {
    Foam foam = honeycomb(4, 4);
    foam.target_areas[kBubble] = target;
    return foam;
}

// The pressure rises by B (1 - A / A_target) / sqrt(A_target) with B = 10 T.
TEST(SoftFoam, PressureRisesWithTheMissingArea) {
    Foam foam = with_target(4.0);
    foam.pressures[kBubble] = 0.5;
    for (const HalfEdgeId h : foam.network.around(kBubble)) {
        foam.pressures[foam.network.right(h)] = 0.5;  // films stay straight
    }
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(kBubble);
    EXPECT_NEAR(soft.pressure(kBubble), 0.5 + 10.0 * (1.0 - 0.25) / 2.0, kRounding);
    EXPECT_DOUBLE_EQ(soft.slope(kBubble), 10.0 / (4.0 * 2.0));
}

TEST(SoftFoam, PressureScalesWithTheFilmTension) {
    Foam foam = with_target(4.0);
    foam.film_tension = 3.0;
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(kBubble);
    EXPECT_NEAR(soft.pressure(kBubble), 3.0 * 3.75, 3.0 * kRounding);
}

TEST(SoftFoam, GainsOfAreaLowerThePressure) {
    Foam foam = with_target(1.0);
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(kBubble);
    EXPECT_NEAR(soft.pressure(kBubble), 0.0, kRounding);
    soft.add_area(kBubble, 0.125);
    EXPECT_NEAR(soft.pressure(kBubble), -1.25, kRounding);
    soft.load(kBubble);  // it is loaded already
    EXPECT_NEAR(soft.pressure(kBubble), -1.25, kRounding);
}

// The pressure at the target becomes 3.75, to which the same lack of area adds 3.75 again.
TEST(SoftFoam, UpdateMultiplierRaisesThePressureAtTheTarget) {
    Foam foam = with_target(4.0);
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(kBubble);
    soft.update_multiplier(kBubble);
    EXPECT_NEAR(soft.pressure(kBubble), 7.5, kRounding);
    soft.add_area(kBubble, 3.0);
    EXPECT_NEAR(soft.pressure(kBubble), 3.75, kRounding);
}

TEST(SoftFoam, BeginRemovesAllBubbles) {
    Foam foam = with_target(4.0);
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(kBubble);
    soft.begin(2.0 * kStiffness);
    EXPECT_EQ(soft.pressure(kBubble), 0.0);
    EXPECT_EQ(soft.slope(kBubble), 0.0);
    soft.load(kBubble);
    EXPECT_NEAR(soft.pressure(kBubble), 7.5, kRounding);
}

TEST(SoftFoam, TheGhostHasNoPressureAndNoSlope) {
    Foam foam = test::flower(1.0);
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(foam.network.ghost());
    EXPECT_EQ(soft.pressure(foam.network.ghost()), 0.0);
    EXPECT_EQ(soft.slope(foam.network.ghost()), 0.0);
}

// The segment of a half circle over the chord c has the area pi c²/8.
TEST(SoftFoam, SetArcMovesTheSegmentFromRightToLeft) {
    Foam foam = with_target(1.0);
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    const HalfEdgeId h = foam.network.first(kBubble);
    const FilmId film = film_of(h);
    const BubbleId left = foam.network.left(forward_side(film));
    const BubbleId right = foam.network.right(forward_side(film));
    soft.load(left);
    soft.load(right);
    const double squared = chord(foam, h).squaredNorm();
    soft.set_arc(film, 0.5 * kPi, squared, squared);
    const double segment = kPi * squared / 8.0;
    EXPECT_NEAR(soft.pressure(left), -kStiffness * segment, kRounding);
    EXPECT_NEAR(soft.pressure(right), kStiffness * segment, kRounding);
    EXPECT_NEAR(soft.arc(film).sine, 1.0, kRounding);
    EXPECT_NEAR(soft.arc(film).cosine, 0.0, kRounding);
    EXPECT_NEAR(soft.segment_of(forward_side(film)), 0.5 * kPi, kRounding);
    EXPECT_NEAR(soft.segment_of(twin(forward_side(film))), -0.5 * kPi, kRounding);
    // On half of the chord the same half circle has a quarter of the segment.
    soft.set_arc(film, 0.5 * kPi, squared, 0.25 * squared);
    EXPECT_NEAR(soft.pressure(left), -kStiffness * 0.25 * segment, kRounding);
}

TEST(SoftFoam, SetArcOfAnOuterFilmIsThatOfTheFoam) {
    Foam foam = test::flower(1.0);
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(BubbleId{1});
    for (const HalfEdgeId h : foam.network.around(BubbleId{1})) {
        const FilmId film = film_of(h);
        const double before = foam.half_angles[film];
        const double squared = chord(foam, h).squaredNorm();
        soft.set_arc(film, 0.3, squared, squared);
        EXPECT_EQ(foam.half_angles[film], foam.network.is_outer(film) ? 0.3 : before);
        EXPECT_EQ(soft.arc(film).half_angle, 0.3);
    }
}

// With equal pressures inner films are straight. The area of a bubble is then the area of its
// polygon plus the segments of its outer films.
TEST(SoftFoam, BulgeFillsABubbleToItsTarget) {
    for (const double target : {0.5, 2.0, 7.0}) {
        Foam foam = test::flower(target);
        bulge_outer_films(foam, BubbleId{1});
        EXPECT_NEAR(bubble_area(foam, BubbleId{1}), target, 1e-10 * target);
    }
    Foam two = test::double_bubble(2.0, 1.0);
    bulge_outer_films(two, BubbleId{0});
    bulge_outer_films(two, BubbleId{1});
    EXPECT_NEAR(bubble_area(two, BubbleId{0}), 2.0, 1e-10);
    EXPECT_NEAR(bubble_area(two, BubbleId{1}), 1.0, 1e-10);
}

TEST(SoftFoam, RenewMeasuresABubbleWhoseOuterFilmsHaveChanged) {
    Foam foam = test::flower(1.0);
    SoftFoam soft(foam);
    soft.begin(kStiffness);
    soft.load(BubbleId{1});
    for (const HalfEdgeId h : foam.network.around(BubbleId{1})) {
        set_half_angle(foam, h, 0.4);  // has an effect on its outer film only
    }
    soft.renew(BubbleId{1}, false);
    const double lacking = 1.0 - bubble_area(foam, BubbleId{1});
    EXPECT_NEAR(soft.pressure(BubbleId{1}), kStiffness * lacking, 1e-12);
}

// A bubble with less than half of its target area counts as empty. Its outer film is then bent
// until the bubble has its target area.
TEST(SoftFoam, RenewFillsABubbleThatMayBeEmpty) {
    for (const double target : {4.0, 1.0}) {
        Foam foam = test::flower(target);  // its outer bubbles have polygons of area 0.95
        for (const HalfEdgeId h : foam.network.around(BubbleId{1})) {
            set_half_angle(foam, h, 0.0);
        }
        SoftFoam soft(foam);
        soft.begin(kStiffness);
        soft.load(BubbleId{1});
        soft.renew(BubbleId{1}, true);
        const double area = bubble_area(foam, BubbleId{1});
        EXPECT_NEAR(area, target == 4.0 ? 4.0 : polygon_area(foam, BubbleId{1}), 1e-9);
        EXPECT_LT(polygon_area(foam, BubbleId{1}), 1.0);
    }
}

}  // namespace
}  // namespace foam
