// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/local_solve.h"

#include "core/equilibrium/residual.h"
#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foam {
namespace {

constexpr BubbleId kBubble{66};

// Returns a honeycomb of twelve columns and rows in which the target area of one bubble is half of
// its area.
Foam with_a_defect() {
    Foam foam = honeycomb(12, 12);
    foam.target_areas[kBubble] = 0.5;
    return foam;
}

std::vector<BubbleId> with_neighbors(const Network& network, BubbleId bubble) {
    std::vector<BubbleId> region{bubble};
    for (const HalfEdgeId h : network.around(bubble)) {
        region.push_back(network.right(h));
    }
    std::sort(region.begin(), region.end());
    return region;
}

ResidualNorms norms_of(const Foam& foam, const Unknowns& unknowns) {
    return norms(foam, unknowns, residual(foam, unknowns));
}

// Expects that the positions and pressures that are not unknowns of the part are unchanged, to the
// last bit.
void expect_held_outside(const Foam& foam, const Foam& before, const Unknowns& part) {
    for (const JunctionId junction : foam.network.junctions()) {
        if (part.position_row(junction) < 0) {
            EXPECT_EQ(foam.positions[junction], before.positions[junction]);
        }
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (part.pressure_row(bubble) < 0) {
            EXPECT_EQ(foam.pressures[bubble], before.pressures[bubble]);
        }
    }
}

TEST(LocalSolve, LeavesAFoamInEquilibriumAsItIs) {
    Foam foam = test::equilibrated_foam(60, 2);
    const Foam before = foam;
    RegionBuffers buffers(foam);
    const LocalSummary summary = solve_defect_regions(foam, {}, {}, buffers);
    EXPECT_EQ(summary.regions, 0U);
    EXPECT_EQ(summary.t1, 0);
    EXPECT_TRUE(test::are_same(foam, before));
}

// The region consists of the bubble and its six neighbors; everything else is held fixed. At the
// end, forces and area errors in the region are below 1e-3.
TEST(LocalSolve, BringsARegionToEquilibriumWithAllElseHeld) {
    Foam foam = with_a_defect();
    const Foam before = foam;
    const Unknowns part = unknowns_around(foam.network, with_neighbors(foam.network, kBubble));
    ASSERT_GE(norms_of(foam, part).area, 0.3);
    RegionBuffers buffers(foam);
    const LocalSummary summary = solve_defect_regions(foam, {}, {.threads = 1}, buffers);
    EXPECT_EQ(summary.regions, 1U);
    EXPECT_EQ(summary.t1, 0);
    const ResidualNorms after = norms_of(foam, part);
    EXPECT_LT(after.area, 1e-3);
    EXPECT_LT(after.force, 1e-3);
    expect_held_outside(foam, before, part);
}

// A defect is among the worst if its error is at least a fifth of the largest error. It must also
// be above the thresholds of DefectOptions, 0.3 for areas. The regions include three rings of
// neighbors, or fewer, if they would contain more than 30 % of the bubbles.
TEST(LocalSolve, WorstRegionsAreThoseOfTheLargestErrors) {
    Foam foam = with_a_defect();                   // an area of 1 instead of 0.5: an error of 1
    foam.target_areas[BubbleId{0}] = 0.8;          // an error of 0.25, above a fifth of 1, ...
    EXPECT_EQ(worst_regions(foam, 1).size(), 1U);  // ... but below 0.3
    foam.target_areas[BubbleId{0}] = 0.75;         // an error of a third
    std::vector<DefectRegion> regions = worst_regions(foam, 1);
    ASSERT_EQ(regions.size(), 2U);  // 2 x 37 of 144 bubbles are more than 30 %, ...
    for (const DefectRegion& region : regions) {
        EXPECT_EQ(region.size(), 19U);  // ... hence two rings: 1 + 6 + 12
    }
    foam.target_areas[kBubble] = 0.1;  // an error of 9, so that a third is below a fifth of it
    regions = worst_regions(foam, 1);
    ASSERT_EQ(regions.size(), 1U);
    EXPECT_EQ(regions.front().size(), 37U);  // with three rings: 1 + 6 + 12 + 18
}

// Returns 144 bubbles, of which `count` * `count` have an area error of 1. These are far from each
// other.
Foam with_defects(std::uint32_t count) {
    Foam foam = honeycomb(12, 12);
    for (std::uint32_t row = 0; row < count; ++row) {
        for (std::uint32_t column = 0; column < count; ++column) {
            foam.target_areas[BubbleId{12 / count * (12 * row + column)}] = 0.5;
        }
    }
    return foam;
}

TEST(LocalSolve, WorstRegionsHaveAtLeastOneRing) {
    const std::vector<DefectRegion> regions = worst_regions(with_defects(2), 1);
    ASSERT_EQ(regions.size(), 4U);  // with two rings, 4 x 19 of 144 bubbles would be more than 30 %
    for (const DefectRegion& region : regions) {
        EXPECT_EQ(region.size(), 7U);
    }
    EXPECT_TRUE(worst_regions(with_defects(3), 1).empty());  // 9 x 7 bubbles are more than 30 %
}

TEST(LocalSolve, RelaxesRegionsWithAllElseHeld) {
    Foam foam = with_a_defect();
    const Foam before = foam;
    const std::vector<DefectRegion> regions = worst_regions(foam, 1);
    ASSERT_EQ(regions.size(), 1U);
    const Unknowns part = unknowns_around(foam.network, regions.front());
    const double squares = norms_of(foam, part).squares;
    RegionBuffers buffers(foam);
    EXPECT_EQ(relax_regions(foam, regions, {.relaxation_sweeps = 30}, buffers), 0);
    EXPECT_LT(norms_of(foam, part).squares, squares);
    expect_held_outside(foam, before, part);
}

}  // namespace
}  // namespace foam
