// SPDX-License-Identifier: Apache-2.0

#include "core/foam/honeycomb.h"

#include "core/foam/measure.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace foam {
namespace {

constexpr double kRoot3 = std::numbers::sqrt3;
// Rounding errors of coordinates up to about 10.
constexpr double kRounding = 1e-14;

// A hexagon of side a has the area 3 sqrt(3) a²/2 = 1: a = sqrt(2 / (3 sqrt(3))).
constexpr double kSide = 0.62040323940139973;

TEST(Honeycomb, IsMadeOfHexagonsOfAreaOne) {
    const Foam foam = honeycomb(3, 4);
    ASSERT_TRUE(test::is_valid(foam.network));
    EXPECT_EQ(foam.network.bubble_count(), 12U);
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_EQ(foam.network.sides(bubble), 6);
        EXPECT_NEAR(bubble_area(foam, bubble), 1.0, kRounding);
        EXPECT_NEAR(foam.target_areas[bubble], 1.0, kRounding);
        EXPECT_EQ(foam.pressures[bubble], 0.0);
    }
    for (const FilmId film : foam.network.films()) {
        EXPECT_NEAR(chord(foam, forward_side(film)).norm(), kSide, kRounding);
    }
}

// Hexagons with a corner at the top are sqrt(3) a wide, and their rows are 3a/2 apart.
TEST(Honeycomb, FitsItsTorus) {
    const Domain domain = honeycomb(3, 4).domain;
    EXPECT_NEAR(domain.width, 3.0 * kRoot3 * kSide, kRounding);
    EXPECT_NEAR(domain.height, 4.0 * 1.5 * kSide, kRounding);
    EXPECT_NEAR(domain.area(), 12.0, kRounding);
}

// Each bubble has six films of length a and shares each of them with another bubble. This is a
// length of 3a = sqrt(2 sqrt(3)) per bubble.
TEST(Honeycomb, IsInEquilibriumWithTheLeastEnergy) {
    for (int columns = 1; columns <= 4; ++columns) {
        for (int rows = 2; rows <= 6; rows += 2) {
            const Foam foam = honeycomb(columns, rows);
            const EquilibriumErrors errors = equilibrium_errors(foam);
            EXPECT_LT(errors.area, kRounding);
            EXPECT_LT(errors.angle, kRounding);
            EXPECT_EQ(errors.films_at_limit, 0);
            EXPECT_NEAR(energy(foam) / (columns * rows), std::sqrt(2.0 * kRoot3), kRounding);
        }
    }
}

TEST(Honeycomb, RejectsTornRows) {
    EXPECT_THROW(honeycomb(0, 2), std::invalid_argument);
    EXPECT_THROW(honeycomb(-1, 2), std::invalid_argument);
    EXPECT_THROW(honeycomb(4, 0), std::invalid_argument);
    EXPECT_THROW(honeycomb(4, -2), std::invalid_argument);
    EXPECT_THROW(honeycomb(4, 3), std::invalid_argument);
}

}  // namespace
}  // namespace foam
