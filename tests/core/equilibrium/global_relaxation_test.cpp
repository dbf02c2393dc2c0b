// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/global_relaxation.h"

#include "core/equilibrium/defect_regions.h"
#include "core/equilibrium/residual.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/measure.h"
#include "core/foam/outline.h"
#include "core/foam/patch.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam {
namespace {

ResidualNorms norms_of(const Foam& foam) {
    const Unknowns all = all_unknowns(foam.network);
    return norms(foam, all, residual(foam, all));
}

// On a torus one pass is enough unless many films are at the limit of their half angle.
TEST(GlobalRelaxation, OfATorusIsOnePass) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Foam foam = test::raw_foam(60, seed);
        Foam expected = foam;
        SoftFoam memory(foam);
        const RelaxationSummary summary =
            relax_globally(foam, {.sweeps = 40, .restarts = true}, memory);
        EXPECT_EQ(summary.sweeps, 40);
        const RelaxationSummary alone = relax(expected, {.sweeps = 40});
        EXPECT_EQ(summary.t1, alone.t1);
        EXPECT_TRUE(test::are_same(foam, expected));
    }
}

// After one sweep a raw patch is far from equilibrium. Further passes follow until it is near
// equilibrium, its defects are in a few regions, or the largest number of passes (201 sweeps) is
// reached.
TEST(GlobalRelaxation, RepeatsForAPatchFarFromEquilibrium) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Foam foam = seed_patch(disc_outline(), {.bubbles = 30, .seed = seed});
        SoftFoam memory(foam);
        const RelaxationSummary summary =
            relax_globally(foam, {.sweeps = 1, .further_sweeps = 20}, memory);
        EXPECT_GE(summary.sweeps, 21);
        EXPECT_EQ(summary.sweeps % 20, 1);
        const Unknowns all = all_unknowns(foam.network);
        const ResidualNorms worst = norms_of(foam);
        const bool is_near = worst.force < 0.1 && worst.area < 0.3;
        EXPECT_TRUE(is_near || summary.sweeps == 201 ||
                    !find_defect_regions(foam, all, residual(foam, all), {}).empty());
    }
}

TEST(GlobalRelaxation, ResolvesTangles) {
    Foam foam = test::equilibrated_foam(60, 4);
    const std::vector<HalfEdgeId> loop = foam.network.around(BubbleId{8});
    const JunctionId one = foam.network.tail(loop[0]);
    const JunctionId other = foam.network.tail(loop[2]);
    std::swap(foam.positions[one], foam.positions[other]);
    const auto is_any_tangled = [&] {
        const auto junctions = foam.network.junctions().ids(foam.network.junction_count());
        return std::any_of(junctions.begin(), junctions.end(), [&](JunctionId junction) {
            return is_tangled(foam, junction);
        });
    };
    ASSERT_TRUE(is_any_tangled());
    SoftFoam memory(foam);
    relax_globally(foam, {}, memory);
    EXPECT_FALSE(is_any_tangled());
    EXPECT_LT(norms_of(foam).force, 0.1);
}

}  // namespace
}  // namespace foam
