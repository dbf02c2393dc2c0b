// SPDX-License-Identifier: Apache-2.0

#include "core/foam/statistics.h"

#include "core/dynamics/step.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/foam/t1_rule.h"
#include "core/network/t2.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Statistics, AHoneycombHasItsKnownValues) {
    const FoamStatistics all = statistics(snapshot(honeycomb(4, 6), 1));
    EXPECT_EQ(all.bubbles, 24);
    EXPECT_NEAR(all.mean_area, 1.0, 1e-14);
    EXPECT_NEAR(all.energy, 24.0 * std::sqrt(2.0 * std::sqrt(3.0)), 1e-12);
    EXPECT_EQ(all.mean_sides, 6.0);
    EXPECT_EQ(all.second_moment, 0.0);
    ASSERT_EQ(all.by_sides.size(), 1U);
    EXPECT_EQ(all.by_sides[0].sides, 6);
    EXPECT_EQ(all.by_sides[0].bubbles, 24);
    EXPECT_NEAR(all.by_sides[0].mean_area, 1.0, 1e-14);
    EXPECT_EQ(all.by_sides[0].mean_pressure, 0.0);
    EXPECT_EQ(all.by_sides[0].mean_inflow, 0.0);
}

// Bubble 5 has 3 sides; bubbles 10, 4 and 2 have 5 sides; bubbles 6, 9 and 1 have 8 sides; the
// other nine have 6 sides: mu_2 = (1 * 9 + 3 * 1 + 3 * 4) / 16 = 1.5.
TEST(Statistics, SecondMomentFollowsFromTheNumbersOfSides) {
    const FoamStatistics all = statistics(snapshot(test::honeycomb_around(3), 1));
    EXPECT_EQ(all.mean_sides, 6.0);
    EXPECT_EQ(all.second_moment, 1.5);
    ASSERT_EQ(all.by_sides.size(), 4U);
    const std::vector<std::pair<int, int>> expected{{3, 1}, {5, 3}, {6, 9}, {8, 3}};
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(all.by_sides[k].sides, expected[k].first);
        EXPECT_EQ(all.by_sides[k].bubbles, expected[k].second);
    }
}

TEST(Statistics, MeansAreOfTheBubblesOfThatManySides) {
    Frame frame = snapshot(test::honeycomb_around(3), 1);
    frame.bubbles[BubbleId{10}] = {10, 0.5, 1.0, 0.1};
    frame.bubbles[BubbleId{4}] = {4, 1.0, 1.0, 0.2};
    frame.bubbles[BubbleId{2}] = {2, 3.0, 1.0, 0.6};
    const SidesStatistics five = statistics(frame).by_sides[1];
    EXPECT_EQ(five.sides, 5);
    EXPECT_NEAR(five.mean_area, 1.5, 1e-15);
    EXPECT_NEAR(five.mean_pressure, 0.3, 1e-15);
}

TEST(Statistics, EnergyIsThatOfTheFoam) {
    Foam foam = test::equilibrated_foam(60, 2);
    EXPECT_NEAR(statistics(snapshot(foam, 1)).energy, energy(foam), 1e-10);
}

// The angles of a bubble of n sides are 120 degrees, so that its films turn by 2 pi - n pi/3 in
// all. A film of curvature c and length l turns by c l and has a pressure difference of T c. The
// inflow is therefore T (pi/3) (n - 6), which is von Neumann's law for T = 2 gamma and kappa = 1.
TEST(Statistics, InflowThroughTheFilmsIsVonNeumanns) {
    for (const double tension : {1.0, 4.0}) {
        Foam foam = test::raw_foam(300, 5);
        foam.film_tension = tension;
        ASSERT_TRUE(equilibrate(foam, {}).converged());
        for (const SidesStatistics& part : statistics(snapshot(foam, 1)).by_sides) {
            EXPECT_NEAR(part.mean_inflow, tension * kPi / 3.0 * (part.sides - 6), 1e-7 * tension)
                << part.sides << " sides";
        }
    }
}

// Each bubble is counted in exactly one group. On a torus the mean number of sides is 6 (Euler).
RC_GTEST_PROP(StatisticsProperty, CountsAndMeansAddUp, ()) {
    const int bubbles = *rc::gen::inRange(2, 60);
    const Foam foam = test::raw_foam(bubbles, *rc::gen::inRange<std::uint64_t>(0, 1000));
    const FoamStatistics all = statistics(snapshot(foam, 1));
    int count = 0;
    int sides_above_six = 0;
    double area = 0.0;
    for (const SidesStatistics& part : all.by_sides) {
        count += part.bubbles;
        sides_above_six += part.bubbles * (part.sides - 6);
        area += part.bubbles * part.mean_area;
    }
    RC_ASSERT(count == bubbles);
    RC_ASSERT(all.bubbles == bubbles);
    RC_ASSERT(sides_above_six == 0);
    RC_ASSERT(all.mean_sides == 6.0);
    RC_ASSERT(std::abs(area / foam.domain.area() - 1.0) < 1e-12);
}

// The growth rate (2 pi/3) gamma kappa (n - 6) is (pi/300) (n - 6) for T = 1 and the default kappa
// of 0.01.
TEST(Growth, MeasuredBetweenEventsIsVonNeumanns) {
    Foam foam = test::equilibrated_foam(200, 1);
    int measured = 0;
    for (int number = 1; number <= 10; ++number) {
        const Frame before = snapshot(foam, number);
        ASSERT_TRUE(step(foam, 2.0, {}).equilibrium.converged());
        for (const SidesGrowth& part : growth_by_sides(before, snapshot(foam, number + 1))) {
            EXPECT_NEAR(part.mean_rate, kPi / 300.0 * (part.sides - 6), 1e-8) << part.sides;
            measured += part.bubbles;
        }
    }
    EXPECT_GT(measured, 1000);
    EXPECT_LT(foam.network.bubble_count(), 195U);  // bubbles vanished meanwhile
}

// All areas grow by 0.5 in a time of 2. The four bubbles around the flipped film do not count.
TEST(Growth, LeavesOutBubblesThatHadAT1) {
    Foam foam = honeycomb(4, 4);
    const Frame before = snapshot(foam, 1);
    flip_film(foam, FilmId{7});
    foam.time += 2.0;
    Frame after = snapshot(foam, 2);
    for (const BubbleId bubble : after.network.bubbles()) {
        after.bubbles[bubble].area = before.bubbles[bubble].area + 0.5;
    }
    const std::vector<SidesGrowth> growth = growth_by_sides(before, after);
    ASSERT_EQ(growth.size(), 1U);
    EXPECT_EQ(growth[0].sides, 6);
    EXPECT_EQ(growth[0].bubbles, 12);
    EXPECT_NEAR(growth[0].mean_rate, 0.25, 1e-15);
}

// Bubble 5 vanishes. Its neighbors 6, 9 and 1, which lose a side, do not count.
TEST(Growth, LeavesOutBubblesNextToAT2) {
    Foam foam = test::honeycomb_around(3);
    const Frame before = snapshot(foam, 1);
    vanish(foam.network, BubbleId{5});
    foam.time += 1.0;
    const std::vector<SidesGrowth> growth = growth_by_sides(before, snapshot(foam, 2));
    ASSERT_EQ(growth.size(), 2U);
    EXPECT_EQ(growth[0].sides, 5);
    EXPECT_EQ(growth[0].bubbles, 3);
    EXPECT_EQ(growth[1].sides, 6);
    EXPECT_EQ(growth[1].bubbles, 9);
}

TEST(Growth, NeedsTime) {
    const Frame frame = snapshot(honeycomb(4, 4), 1);
    EXPECT_TRUE(growth_by_sides(frame, frame).empty());
}

}  // namespace
}  // namespace foam
