// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/border.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

constexpr double kWidth = 10.0;
constexpr double kHeight = 4.0;

Chain line(const Vec2& tail, const Vec2& head) {
    return {tail, {{head, 0.0}}, false};
}

double area_of(const std::vector<Chain>& chains) {
    double area = 0.0;
    for (const Chain& chain : chains) {
        EXPECT_TRUE(chain.is_closed);
        EXPECT_EQ(chain.head(), chain.tail);
        area += signed_area(chain);
    }
    return area;
}

// The region to the left of an upward line at x = 6 is 6 wide; to the left of a downward line it is
// the rest.
TEST(Border, ALineHasTheRegionOnItsLeft) {
    const auto left = closed_along_border({line({6.0, 0.0}, {6.0, 4.0})}, kWidth, kHeight);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_DOUBLE_EQ(area_of(left), 24.0);
    const auto right = closed_along_border({line({6.0, 4.0}, {6.0, 0.0})}, kWidth, kHeight);
    EXPECT_DOUBLE_EQ(area_of(right), 16.0);
}

TEST(Border, AStripBetweenTwoLinesIsOneRegion) {
    const auto strip = closed_along_border(
        {line({6.0, 0.0}, {6.0, 4.0}), line({2.0, 4.0}, {2.0, 0.0})}, kWidth, kHeight);
    ASSERT_EQ(strip.size(), 1U);
    EXPECT_DOUBLE_EQ(area_of(strip), 16.0);
}

TEST(Border, AStripHasTwoRegionsOutside) {
    const auto rest = closed_along_border(
        {line({6.0, 4.0}, {6.0, 0.0}), line({2.0, 0.0}, {2.0, 4.0})}, kWidth, kHeight);
    ASSERT_EQ(rest.size(), 2U);
    EXPECT_DOUBLE_EQ(area_of(rest), 24.0);
}

// A line from the bottom to the left cuts off a corner: a triangle with sides 2 and 3.
TEST(Border, ACornerIsPassed) {
    const auto corner = closed_along_border({line({2.0, 0.0}, {0.0, 3.0})}, kWidth, kHeight);
    EXPECT_DOUBLE_EQ(area_of(corner), 3.0);
    const auto rest = closed_along_border({line({0.0, 3.0}, {2.0, 0.0})}, kWidth, kHeight);
    EXPECT_DOUBLE_EQ(area_of(rest), 37.0);
}

TEST(Border, ClosedChainsStay) {
    const auto chains = closed_along_border({circle({5.0, 2.0}, 1.0)}, kWidth, kHeight);
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_NEAR(signed_area(chains[0]), 3.14159265358979, 1e-13);
}

// A chain ends where another one begins, up to rounding: both are one region, without a turn along
// the border.
TEST(Border, ChainsThatTouchTheBorderInAPointAreOneRegion) {
    const double x = 0.1 + 0.2;  // slightly above 0.3
    const auto region = closed_along_border(
        {line({8.0, 0.0}, {0.3, 4.0}), line({x, 4.0}, {2.0, 0.0})}, kWidth, kHeight);
    ASSERT_EQ(region.size(), 1U);
    EXPECT_NEAR(area_of(region), 12.0, 1e-12);  // a triangle of base 6 and height 4
}

}  // namespace
}  // namespace foam::texgen
