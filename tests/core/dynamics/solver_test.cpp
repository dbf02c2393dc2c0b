// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/solver.h"

#include "core/foam/measure.h"
#include "core/reference/equilibrate_by_sweeps.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

TEST(Solver, IsTheSelectedOne) {
    const EquilibriumOptions options{.tolerance = 1e-3};
    const Foam start = test::raw_foam(30, 2);
    Foam newton = start;
    Foam sequential = start;
    Foam colored = start;
    EXPECT_TRUE(equilibrate(newton, options).converged());
    EXPECT_TRUE(equilibrate_by_sweeps(sequential, SweepOrder::Sequential, options).converged());
    EXPECT_TRUE(equilibrate_by_sweeps(colored, SweepOrder::Colored, options).converged());
    Foam foam = start;
    EXPECT_TRUE(equilibrate_with(Solver::Newton, foam, options).converged());
    EXPECT_TRUE(test::are_same(foam, newton));
    foam = start;
    EXPECT_TRUE(equilibrate_with(Solver::GaussSeidel, foam, options).converged());
    EXPECT_TRUE(test::are_same(foam, sequential));
    foam = start;
    EXPECT_TRUE(equilibrate_with(Solver::ColoredGaussSeidel, foam, options).converged());
    EXPECT_TRUE(test::are_same(foam, colored));
    EXPECT_FALSE(test::are_same(sequential, newton));
    EXPECT_FALSE(test::are_same(sequential, colored));
}

}  // namespace
}  // namespace foam
