// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/graph_bisection.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

// Returns the zones of a graph. Expects that no edge connects the zones and that neither zone is
// too heavy.
std::vector<Zone> balanced_zones(const WeightedGraph& graph) {
    const std::vector<Zone> zones = bisect(graph);
    EXPECT_EQ(test::edges_across(graph, zones), 0);
    const int low = test::weight_of(graph, zones, Zone::Low);
    const int high = test::weight_of(graph, zones, Zone::High);
    const int limit = max_zone_weight(low + high + test::weight_of(graph, zones, Zone::Outside));
    EXPECT_LE(low, limit);
    EXPECT_LE(high, limit);
    return zones;
}

int separator_weight(const WeightedGraph& graph) {
    return test::weight_of(graph, balanced_zones(graph), Zone::Outside);
}

// A separator of a square grid of side n needs n points, and a separator of a torus 2 n points. A
// multilevel method guarantees no bound. METIS 5.1 finds separators of these weights; for tori of
// sides 10 and 20 its separators are heavier than ours.
TEST(GraphBisection, CutsGridsByNearlyAsFewPointsAsPossible) {
    for (const int side : {10, 30, 60, 100}) {
        SCOPED_TRACE(side);
        EXPECT_LE(separator_weight(test::graph_of(test::plane_grid(side))), 1.25 * side);
        EXPECT_LE(separator_weight(test::graph_of(test::torus_grid(side, side))), 2.0 * side);
    }
}

TEST(GraphBisection, CutsALongTorusAcross) {
    EXPECT_LE(separator_weight(test::graph_of(test::torus_grid(200, 8))), 16);
}

// Two square grids share one corner, which is the lightest separator.
TEST(GraphBisection, FindsTheOnePointThatJoinsTwoParts) {
    constexpr int kSide = 12;
    constexpr int kPoints = kSide * kSide;
    std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
    for (const int shift : {0, kPoints - 1}) {
        for (int k = 0; k < kPoints; ++k) {
            if (k % kSide + 1 < kSide) {
                pairs.emplace_back(shift + k, shift + k + 1);
            }
            if (k + kSide < kPoints) {
                pairs.emplace_back(shift + k, shift + k + kSide);
            }
        }
    }
    const test::PointSystem system{
        kPlane,
        std::vector<SolverNode>(2 * kPoints - 1, SolverNode{Vec2::Zero(), 1}),
        test::coupled_matrix(2 * kPoints - 1, pairs)};
    const WeightedGraph graph = test::graph_of(system);
    const std::vector<Zone> zones = balanced_zones(graph);
    EXPECT_EQ(test::weight_of(graph, zones, Zone::Outside), 1);
    EXPECT_EQ(zones[kPoints - 1], Zone::Outside);
}

TEST(GraphBisection, NeedsNoSeparatorBetweenComponents) {
    const WeightedGraph graph{std::vector(60, 1), {}, std::vector<std::uint32_t>(61, 0)};
    EXPECT_EQ(separator_weight(graph), 0);
}

TEST(GraphBisection, TakesASingleNode) {
    EXPECT_EQ(bisect({{3}, {}, {0, 0}}).size(), 1U);
}

TEST(GraphBisection, LeavesNoEdgesAcrossTheSeparatorOfACompleteGraph) {
    const WeightedGraph graph = test::graph_of(test::complete_system(30));
    EXPECT_EQ(test::edges_across(graph, bisect(graph)), 0);
}

}  // namespace
}  // namespace foam
