// SPDX-License-Identifier: Apache-2.0

#include "core/reference/equilibrate_by_sweeps.h"

#include "core/foam/t1_rule.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace foam {
namespace {

using test::equilibrated_foam;
using test::is_valid;

TEST(EquilibrateBySweeps, EquilibratesRawDiagrams) {
    for (const SweepOrder order : {SweepOrder::Sequential, SweepOrder::Colored}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            Foam foam = test::raw_foam(50, seed);
            const EquilibriumSummary summary =
                equilibrate_by_sweeps(foam, order, {.tolerance = 1e-4});
            EXPECT_TRUE(summary.converged()) << "seed " << seed;
            EXPECT_EQ(summary.sweeps, EquilibriumOptions{}.relaxation_sweeps);
            EXPECT_GT(summary.iterations, 10);
            EXPECT_LT(summary.area_error, 1e-4);
            EXPECT_LT(summary.angle_error, 1e-4);
            EXPECT_TRUE(is_valid(foam.network));
        }
    }
}

// Films that are shorter than their T1 distance in equilibrium flip after Gauss-Seidel, as they do
// after Newton's method.
TEST(EquilibrateBySweeps, LeavesNoPendingT1) {
    const TopologyThresholds thresholds{.t1_distance = 0.2};
    int t1 = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Foam foam = equilibrated_foam(30, seed);
        const EquilibriumSummary summary = equilibrate_by_sweeps(
            foam,
            SweepOrder::Sequential,
            {.thresholds = thresholds, .tolerance = 1e-3, .relaxes_first = false});
        EXPECT_TRUE(summary.converged());
        EXPECT_TRUE(short_films(foam, thresholds).empty());
        t1 += summary.t1;
    }
    EXPECT_GT(t1, 0);
}

}  // namespace
}  // namespace foam
