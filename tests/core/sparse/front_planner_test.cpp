// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_planner.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foam {
namespace {

TEST(FrontPlanner, EliminatesEveryRowOnce) {
    const FrontPlan plan = test::plan_of(test::torus_grid(15, 20));
    std::vector<std::uint32_t> positions = plan.position_of_row;
    std::sort(positions.begin(), positions.end());
    for (std::uint32_t k = 0; k < positions.size(); ++k) {
        EXPECT_EQ(positions[k], k);
    }
    std::size_t row = 0;
    for (const Front& front : plan.fronts) {
        EXPECT_EQ(front.first_row, row);
        row += front.pivots;
    }
    EXPECT_EQ(row, 300U);
}

// The update matrix of a front is added to its parent, so its border must be among the parent's
// rows.
TEST(FrontPlanner, BordersAreRowsOfTheParent) {
    const FrontPlan plan = test::plan_of(test::torus_grid(15, 20));
    std::size_t checked = 0;
    for (const Front& front : plan.fronts) {
        if (front.is_leaf()) {
            continue;
        }
        const std::vector<std::size_t> parent_rows = test::rows_of(plan, front);
        for (const Front* child : {&plan.fronts[front.left], &plan.fronts[front.right]}) {
            const auto rows = plan.rows_of_border(*child);
            const auto slots = plan.slots_of_border(*child);
            EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
            for (std::size_t k = 0; k < rows.size(); ++k, ++checked) {
                ASSERT_LT(slots[k], parent_rows.size());
                EXPECT_EQ(parent_rows[slots[k]], rows[k]);
            }
        }
    }
    EXPECT_GT(checked, 300U);
}

// Returns the rows of the entries in a column, from the diagonal down.
std::vector<std::size_t> rows_of_column(const Eigen::MatrixXd& matrix, std::size_t column) {
    std::vector<std::size_t> rows;
    for (auto row = static_cast<Eigen::Index>(column); row < matrix.rows(); ++row) {
        if (matrix(row, static_cast<Eigen::Index>(column)) != 0.0) {
            rows.push_back(static_cast<std::size_t>(row));
        }
    }
    return rows;
}

TEST(FrontPlanner, FrontsHoldAllRowsOfTheirColumns) {
    const test::PointSystem grid = test::torus_grid(15, 20);
    const FrontPlan plan = test::plan_of(grid);
    const Eigen::MatrixXd matrix = test::reordered(grid, plan);
    for (const Front& front : plan.fronts) {
        const std::vector<std::size_t> held = test::rows_of(plan, front);
        for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
            const std::vector<std::size_t> rows = rows_of_column(matrix, front.first_row + pivot);
            const auto first = held.begin() + static_cast<std::ptrdiff_t>(pivot);
            EXPECT_TRUE(std::includes(first, held.end(), rows.begin(), rows.end()));
        }
    }
}

// 60 rows that are all coupled to each other form one front of 60 * 60 numbers.
TEST(FrontPlanner, RejectsAPlanAboveTheLimit) {
    const test::PointSystem complete = test::complete_system(60);
    const auto plan = [&](std::size_t limit) {
        return test::plan_within(complete.matrix, complete.nodes, complete.domain, limit);
    };
    EXPECT_FALSE(plan(3599).has_value());
    ASSERT_TRUE(plan(3600).has_value());
    EXPECT_EQ(plan(3600)->panels_size, 3600U);
    EXPECT_EQ(plan(3600)->workspace_size, 0U);
}

// The factor alone is within the limit, but not together with the update matrices of fronts.
TEST(FrontPlanner, CountsTheWorkspaceTowardsTheLimit) {
    const test::PointSystem grid = test::torus_grid(15, 20);
    const FrontPlan unlimited = test::plan_of(grid);
    const std::size_t size = unlimited.panels_size + unlimited.workspace_size;
    ASSERT_GT(unlimited.workspace_size, 0U);
    EXPECT_TRUE(test::plan_within(grid.matrix, grid.nodes, grid.domain, size).has_value());
    EXPECT_FALSE(test::plan_within(grid.matrix, grid.nodes, grid.domain, size - 1).has_value());
}

// The points are coupled as in an ordinary grid, but have random positions. If the plan were based
// on positions alone, the first fronts would hold half of all points, and the plan fifty times as
// many numbers.
TEST(FrontPlanner, ScatteredPositionsCostLittleMemory) {
    test::PointSystem grid = test::torus_grid(60, 60);
    const std::size_t ordinary = test::plan_of(grid).panels_size;
    test::scatter(grid);
    EXPECT_LT(static_cast<double>(test::plan_of(grid).panels_size),
              1.2 * static_cast<double>(ordinary));
}

}  // namespace
}  // namespace foam
