// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_solve.h"

#include "core/sparse/front_factor.h"
#include "tests/core/sparse/grids.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

std::vector<double> factor_of(const test::PointSystem& system, const FrontPlan& plan) {
    std::vector<double> factor(plan.panels_size);
    std::vector<double> workspace(plan.workspace_size);
    std::vector<double> scratch(plan.scratch_size);
    const std::span<const double> values(system.matrix.valuePtr(), plan.entries.size());
    EXPECT_TRUE(factor_fronts<double>(plan, {values, factor, workspace, scratch}, 1));
    return factor;
}

TEST(FrontSolve, AgreesWithADenseSolver) {
    const test::PointSystem grid = test::torus_grid(15, 20);
    const FrontPlan plan = test::plan_of(grid);
    const Eigen::VectorXd right_hand_side = Eigen::VectorXd::LinSpaced(300, -1.0, 2.0);
    Eigen::VectorXd x = right_hand_side;
    solve_fronts(plan, factor_of(grid, plan).data(), x, 1);
    const Eigen::VectorXd expected = test::reordered(grid, plan).llt().solve(right_hand_side);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
}

// The largest subtrees have more than kMinParallelRows rows, so that they are solved in parallel.
TEST(FrontSolve, HasTheSameBitsOnAnyNumberOfThreads) {
    const test::PointSystem grid = test::torus_grid(90, 80);
    ASSERT_GT(grid.nodes.size(), 2 * kMinParallelRows);
    const FrontPlan plan = test::plan_of(grid);
    const std::vector<double> factor = factor_of(grid, plan);
    const auto solution = [&](std::size_t threads) {
        Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(7200, -1.0, 2.0);
        solve_fronts(plan, factor.data(), x, threads);
        return x;
    };
    const Eigen::VectorXd expected = solution(1);
    for (const std::size_t threads : {2U, 3U, 16U}) {
        EXPECT_TRUE((solution(threads).array() == expected.array()).all()) << threads;
    }
}

}  // namespace
}  // namespace foam
