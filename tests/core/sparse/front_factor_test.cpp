// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_factor.h"

#include "core/sparse/front_workspace.h"
#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

struct Factored {
    std::vector<double> factor;
    bool succeeded = false;
};

// Factors a matrix in memory that is filled with a number which must be overwritten.
Factored factored(const test::PointSystem& system, const FrontPlan& plan, std::size_t threads) {
    Factored result{std::vector<double>(plan.panels_size, 1e9)};
    std::vector<double> workspace(plan.workspace_size, 1e9);
    std::vector<double> scratch(threads * plan.scratch_size, 1e9);
    const std::span<const double> values(system.matrix.valuePtr(), plan.entries.size());
    result.succeeded =
        factor_fronts<double>(plan, {values, result.factor, workspace, scratch}, threads);
    return result;
}

// Each panel has D on its diagonal and L below it.
TEST(FrontFactor, MultipliesToTheMatrix) {
    const test::PointSystem grid = test::torus_grid(15, 20);
    const FrontPlan plan = test::plan_of(grid);
    const Factored result = factored(grid, plan, 1);
    ASSERT_TRUE(result.succeeded);
    Eigen::MatrixXd L = Eigen::MatrixXd::Identity(300, 300);
    Eigen::VectorXd D(300);
    for (const Front& front : plan.fronts) {
        const std::vector<std::size_t> rows = test::rows_of(plan, front);
        for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
            const double* column = &result.factor[front.panel_begin + pivot * front.rows()];
            const auto at = static_cast<Eigen::Index>(rows[pivot]);
            D[at] = column[pivot];
            for (std::size_t slot = pivot + 1; slot < front.rows(); ++slot) {
                L(static_cast<Eigen::Index>(rows[slot]), at) = column[slot];
            }
        }
    }
    const Eigen::MatrixXd product = L * D.asDiagonal() * L.transpose();
    const Eigen::MatrixXd matrix = test::reordered(grid, plan);
    EXPECT_LT((product - matrix).cwiseAbs().maxCoeff(), 1e-14 * matrix.maxCoeff());
}

// Returns D and L without the undefined numbers above the diagonals.
std::vector<double> lower_part(const FrontPlan& plan, const std::vector<double>& factor) {
    std::vector<double> numbers;
    for (const Front& front : plan.fronts) {
        for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
            const double* column = &factor[front.panel_begin + pivot * front.rows()];
            numbers.insert(numbers.end(), column + pivot, column + front.rows());
        }
    }
    return numbers;
}

TEST(FrontFactor, HasTheSameBitsOnAnyNumberOfThreads) {
    const test::PointSystem grid = test::torus_grid(30, 20);
    const FrontPlan plan = test::plan_of(grid);
    const std::vector<double> expected = lower_part(plan, factored(grid, plan, 1).factor);
    for (const int threads : {2, 3, kMaxWorkers}) {
        const Factored result = factored(grid, plan, static_cast<std::size_t>(threads));
        EXPECT_TRUE(result.succeeded);
        EXPECT_EQ(lower_part(plan, result.factor), expected) << threads << " threads";
    }
}

// All elements of the matrix are 1. After the elimination of the first row, the next pivot is 0.
TEST(FrontFactor, ReportsAZeroPivot) {
    test::PointSystem complete = test::complete_system(60);
    complete.matrix.coeffs().setOnes();
    EXPECT_FALSE(factored(complete, test::plan_of(complete), 1).succeeded);
}

}  // namespace
}  // namespace foam
