// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_entries.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foam {
namespace {

// Follows every entry to its row and column in the order of elimination, and compares it with the
// reordered matrix.
TEST(FrontEntries, AssignEveryEntryToItsFront) {
    const test::PointSystem grid = test::torus_grid(12, 11);
    const FrontPlan plan = test::plan_of(grid);
    const Eigen::MatrixXd matrix = test::reordered(grid, plan);
    std::vector<int> times_found(plan.entries.size(), 0);
    for (const Front& front : plan.fronts) {
        const std::vector<std::size_t> rows = test::rows_of(plan, front);
        for (std::size_t k = front.entries_begin; k < front.entries_end; ++k) {
            const auto& [source, target] = plan.entries[k];
            ASSERT_LT(target, front.pivots * front.rows());
            const auto row = static_cast<Eigen::Index>(rows[target % front.rows()]);
            const auto column = static_cast<Eigen::Index>(rows[target / front.rows()]);
            EXPECT_GE(row, column);
            EXPECT_EQ(matrix(row, column), grid.matrix.valuePtr()[source]);
            ++times_found[source];
        }
    }
    EXPECT_EQ(times_found, std::vector<int>(static_cast<std::size_t>(grid.matrix.nonZeros()), 1));
}

}  // namespace
}  // namespace foam
