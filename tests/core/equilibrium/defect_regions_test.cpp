// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/defect_regions.h"

#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <vector>

namespace foam {
namespace {

// A foam whose residual is set by the test.
struct Case {
    explicit Case(Foam the_foam)
        : foam(std::move(the_foam)),
          unknowns(all_unknowns(foam.network)),
          residual(Eigen::VectorXd::Zero(unknowns.size())) {}

    void set_area_error(BubbleId bubble, double error) {
        residual[unknowns.pressure_row(bubble)] = error * foam.target_areas[bubble];
    }
    void set_force(JunctionId junction, const Vec2& force) {
        residual.segment<2>(unknowns.position_row(junction)) = force;
    }
    std::vector<DefectRegion> regions(const DefectOptions& options = {}) const {
        return find_defect_regions(foam, unknowns, residual, options);
    }

    Foam foam;
    Unknowns unknowns;
    Eigen::VectorXd residual;
};

// Returns the given bubbles and all bubbles that share a film with one of them, without the ghost.
DefectRegion with_neighbors(const Network& network, const std::vector<BubbleId>& bubbles) {
    std::set<BubbleId> region(bubbles.begin(), bubbles.end());
    for (const BubbleId bubble : bubbles) {
        for (const HalfEdgeId h : network.around(bubble)) {
            region.insert(network.right(h));
        }
    }
    region.erase(network.ghost());
    return {region.begin(), region.end()};
}

TEST(DefectRegions, NeedErrorsAboveTheThresholds) {
    Case c(honeycomb(8, 8));
    EXPECT_TRUE(c.regions().empty());
    c.set_area_error(BubbleId{20}, -0.29);
    c.set_force(JunctionId{30}, Vec2(0.06, 0.07));  // magnitude 0.092, below the threshold 0.1
    EXPECT_TRUE(c.regions().empty());
}

TEST(DefectRegions, ContainABubbleAndItsNeighbors) {
    for (const double error : {0.31, -0.31, std::numeric_limits<double>::quiet_NaN()}) {
        Case c(honeycomb(8, 8));
        c.set_area_error(BubbleId{27}, error);
        const std::vector<DefectRegion> regions = c.regions();
        ASSERT_EQ(regions.size(), 1U) << error;
        EXPECT_EQ(regions.front().size(), 7U);
        EXPECT_EQ(regions.front(), with_neighbors(c.foam.network, {BubbleId{27}}));
    }
}

// Area errors are relative to the target area, forces are in film tensions.
TEST(DefectRegions, MeasureDefectsWithoutUnits) {
    Case c(honeycomb(8, 8));
    c.foam.target_areas[BubbleId{27}] = 4.0;
    c.residual[c.unknowns.pressure_row(BubbleId{27})] = 1.19;
    c.foam.film_tension = 3.0;
    c.set_force(JunctionId{5}, Vec2(0.29, 0.0));
    EXPECT_TRUE(c.regions().empty());
    c.residual[c.unknowns.pressure_row(BubbleId{27})] = 1.21;
    EXPECT_EQ(c.regions().size(), 1U);
    c.residual[c.unknowns.pressure_row(BubbleId{27})] = 0.0;
    c.set_force(JunctionId{5}, Vec2(0.31, 0.0));
    EXPECT_EQ(c.regions().size(), 1U);
}

// The three hexagons around a junction have nine neighbors.
TEST(DefectRegions, ContainTheBubblesOfAJunctionAndTheirRings) {
    Case c(honeycomb(12, 12));
    const JunctionId junction{100};
    c.set_force(junction, Vec2(0.0, 0.11));
    const Network& network = c.foam.network;
    std::vector<BubbleId> bubbles;
    for (const HalfEdgeId h : network.leaving(junction)) {
        bubbles.push_back(network.left(h));
    }
    std::sort(bubbles.begin(), bubbles.end());
    EXPECT_EQ(c.regions({.rings = 0}), (std::vector<DefectRegion>{bubbles}));
    const DefectRegion one_ring = with_neighbors(network, bubbles);
    EXPECT_EQ(one_ring.size(), 12U);
    EXPECT_EQ(c.regions({.rings = 1}), (std::vector<DefectRegion>{one_ring}));
    EXPECT_EQ(c.regions({.rings = 2}),
              (std::vector<DefectRegion>{with_neighbors(network, one_ring)}));
}

// In a honeycomb of twelve columns, bubbles 40 and 42 have a common neighbor, 41. Bubbles 40 and 46
// are six columns apart.
TEST(DefectRegions, AreJoinedWhereTheyTouch) {
    Case c(honeycomb(12, 12));
    c.set_area_error(BubbleId{46}, 0.5);
    c.set_area_error(BubbleId{40}, 0.5);
    const Network& network = c.foam.network;
    EXPECT_EQ(c.regions(),
              (std::vector<DefectRegion>{with_neighbors(network, {BubbleId{40}}),
                                         with_neighbors(network, {BubbleId{46}})}));
    c.set_area_error(BubbleId{46}, 0.0);
    c.set_area_error(BubbleId{42}, 0.5);
    EXPECT_EQ(c.regions(),
              (std::vector<DefectRegion>{with_neighbors(network, {BubbleId{40}, BubbleId{42}})}));
}

// The region is a bubble and its six neighbors: 29 % of 24 bubbles, but 44 % of 16 bubbles. The
// limit is 30 %.
TEST(DefectRegions, AreDroppedIfTheyCoverTooMuchOfTheFoam) {
    Case many(honeycomb(6, 4));
    many.set_area_error(BubbleId{9}, 0.5);
    EXPECT_EQ(many.regions().size(), 1U);
    Case few(honeycomb(4, 4));
    few.set_area_error(BubbleId{9}, 0.5);
    EXPECT_TRUE(few.regions().empty());
    EXPECT_EQ(few.regions({.largest_fraction = 0.44}).size(), 1U);
}

// A petal of the flower (patches.h) touches the middle bubble, two petals, and the ghost.
TEST(DefectRegions, NeverHoldTheGhost) {
    Case c(test::flower(1.0));
    c.set_area_error(BubbleId{1}, 0.5);
    const std::vector<DefectRegion> regions = c.regions({.largest_fraction = 1.0});
    ASSERT_EQ(regions.size(), 1U);
    EXPECT_EQ(regions.front(), with_neighbors(c.foam.network, {BubbleId{1}}));
    EXPECT_EQ(regions.front().size(), 4U);
}

}  // namespace
}  // namespace foam
