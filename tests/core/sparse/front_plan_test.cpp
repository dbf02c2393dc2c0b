// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_plan.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

// Returns a plan with one front. Its pivots are the rows 1 and 2, its border is the rows 4 and 5.
// The border of another front precedes its border in the list.
FrontPlan plan_with_a_front() {
    FrontPlan plan;
    plan.fronts.push_back({.first_row = 1, .pivots = 2, .border = 2, .border_begin = 1});
    plan.border_rows = {3, 4, 5};
    plan.border_slots = {9, 7, 8};
    return plan;
}

TEST(FrontPlan, NumbersPivotsBeforeTheBorder) {
    const FrontPlan plan = plan_with_a_front();
    std::vector<std::uint32_t> slots(7, 99);
    plan.write_slots(plan.fronts[0], slots);
    EXPECT_EQ(slots, (std::vector<std::uint32_t>{99, 0, 1, 99, 2, 3, 99}));
}

TEST(FrontPlan, GivesTheBorderOfAFront) {
    const FrontPlan plan = plan_with_a_front();
    const std::span<const std::uint32_t> rows = plan.rows_of_border(plan.fronts[0]);
    const std::span<const std::uint32_t> slots = plan.slots_of_border(plan.fronts[0]);
    EXPECT_EQ(std::vector(rows.begin(), rows.end()), (std::vector<std::uint32_t>{4, 5}));
    EXPECT_EQ(std::vector(slots.begin(), slots.end()), (std::vector<std::uint32_t>{7, 8}));
    EXPECT_EQ(plan.fronts[0].rows(), 4U);
    EXPECT_TRUE(plan.fronts[0].is_leaf());
}

TEST(FrontPlan, CountsTheScratchMemoryOfEachThread) {
    FrontPlan plan;
    plan.panels_size = 100;
    plan.workspace_size = 20;
    plan.scratch_size = 3;
    EXPECT_EQ(plan.memory_size(1), 123U);
    EXPECT_EQ(plan.memory_size(4), 132U);
}

}  // namespace
}  // namespace foam
