// SPDX-License-Identifier: Apache-2.0

#include "core/foam/target_areas.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

// Three areas become 1, 10 and 100, which are evenly spaced in the logarithm, in the order of the
// original areas.
TEST(SpreadAreas, KeepsTheOrderAndReachesTheRatio) {
    std::vector<double> areas{5.0, 1.0, 3.0};
    spread_areas(areas, 100.0);
    EXPECT_DOUBLE_EQ(areas[0], 100.0);
    EXPECT_DOUBLE_EQ(areas[1], 1.0);
    EXPECT_DOUBLE_EQ(areas[2], 10.0);
}

TEST(SpreadAreas, GivesEqualAreasInTheirOrder) {
    std::vector<double> areas{2.0, 2.0};
    spread_areas(areas, 9.0);
    EXPECT_DOUBLE_EQ(areas[0], 1.0);
    EXPECT_DOUBLE_EQ(areas[1], 9.0);
}

TEST(SpreadAreas, OfARatioOfOneMakesAllAreasEqual) {
    std::vector<double> areas{4.0, 2.0, 7.0};
    spread_areas(areas, 1.0);
    EXPECT_EQ(areas, (std::vector<double>{1.0, 1.0, 1.0}));
}

TEST(SpreadAreas, LeavesALoneBubbleAtOne) {
    std::vector<double> areas{3.0};
    spread_areas(areas, 50.0);
    EXPECT_EQ(areas, std::vector<double>{1.0});
}

// The sum 1 + 3 = 4 becomes 8, so that every area doubles.
TEST(ScaleToTotal, ScalesAllAreasAlike) {
    std::vector<double> areas{1.0, 3.0};
    scale_to_total(areas, 8.0);
    EXPECT_EQ(areas, (std::vector<double>{2.0, 6.0}));
}

TEST(SetTargetAreas, KeepsTheAreasWithoutAFieldOrARatio) {
    std::vector<double> areas{5.0, 1.0, 3.0};
    set_target_areas(areas, {}, 0.0);
    EXPECT_EQ(areas, (std::vector<double>{5.0, 1.0, 3.0}));
}

TEST(SetTargetAreas, TakesTheAreasOfTheField) {
    std::vector<double> areas{5.0, 1.0, 3.0};
    const std::vector<double> field{2.0, 4.0, 8.0};
    set_target_areas(areas, field, 0.0);
    EXPECT_EQ(areas, field);
}

// Relative to the field, the areas are 2.5, 0.25 and 1: their ranks are last, first and second.
TEST(SetTargetAreas, SpreadsAreasRelativeToTheField) {
    std::vector<double> areas{5.0, 1.0, 8.0};
    const std::vector<double> field{2.0, 4.0, 8.0};
    set_target_areas(areas, field, 100.0);
    EXPECT_DOUBLE_EQ(areas[0], 200.0);
    EXPECT_DOUBLE_EQ(areas[1], 4.0);
    EXPECT_DOUBLE_EQ(areas[2], 80.0);
}

}  // namespace
}  // namespace foam
