// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/flattened.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Flattened, StraightArcsHaveOnePart) {
    EXPECT_EQ(part_count({{0.0, 0.0}, {5.0, 0.0}, 0.0}, 0.01), 1U);
    EXPECT_EQ(part_count({{5.0, 0.0}, {5.0, 0.0}, 1.0}, 0.01), 1U);
}

// A circle of the radius 10 as n chords: the distance of a chord from the circle is
// 10 (1 - cos(pi / n)), which must be at most the tolerance, and close to it.
TEST(Flattened, PartsKeepTheTolerance) {
    const std::array<Chain, 1> chains{circle({1.0, 2.0}, 10.0)};
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        const std::vector<Ring> rings = flattened(chains, tolerance);
        ASSERT_EQ(rings.size(), 1U);
        const double height = 10.0 * (1.0 - std::cos(kPi / static_cast<double>(rings[0].size())));
        EXPECT_LE(height, tolerance);
        EXPECT_GT(height, 0.5 * tolerance);
        for (const Vec2& corner : rings[0]) {
            EXPECT_NEAR((corner - Vec2(1.0, 2.0)).norm(), 10.0, 1e-12);
        }
    }
}

// A part turns by at most half a radian, however large the tolerance is.
TEST(Flattened, SmallCirclesStayRound) {
    const std::array<Chain, 1> chains{circle({0.0, 0.0}, 0.1)};
    EXPECT_EQ(flattened(chains, 10.0)[0].size(), 14U);
}

}  // namespace
}  // namespace foam::texgen
