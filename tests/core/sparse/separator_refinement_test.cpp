// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/separator_refinement.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>
#include <vector>

namespace foam {
namespace {

constexpr int kSide = 20;
constexpr int kMaxWeight = kSide * kSide / 5 * 3;

// Returns the zones of a square grid in the plane. The separator consists of the middle column and
// of the given number of columns on each side of it. Low is on the left of the separator, High on
// its right.
std::vector<Zone> thick_separator(int columns_beside) {
    std::vector<Zone> zones;
    for (int k = 0; k < kSide * kSide; ++k) {
        const int from_middle = k % kSide - kSide / 2;
        zones.push_back(from_middle < -columns_beside  ? Zone::Low
                        : from_middle > columns_beside ? Zone::High
                                                       : Zone::Outside);
    }
    return zones;
}

// A separator of seven columns shrinks to one column, the lightest separator within the limits.
TEST(SeparatorRefinement, FindsTheLightestSeparatorOfAGrid) {
    const WeightedGraph graph = test::graph_of(test::plane_grid(kSide));
    std::vector<Zone> zones = thick_separator(3);
    SeparatorRefinement refinement(graph, kMaxWeight, zones);
    refinement.run();
    EXPECT_EQ(refinement.cost().first, kSide);
    EXPECT_EQ(test::edges_across(graph, zones), 0);
}

TEST(SeparatorRefinement, CountsTheWeightsOfTheZones) {
    WeightedGraph graph = test::graph_of(test::plane_grid(kSide));
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        graph.weights[node] = 1 + static_cast<int>(node % 3);
    }
    std::vector<Zone> zones = thick_separator(2);
    SeparatorRefinement refinement(graph, kMaxWeight * 2, zones);
    refinement.run();
    const int low = test::weight_of(graph, zones, Zone::Low);
    const int high = test::weight_of(graph, zones, Zone::High);
    EXPECT_EQ(refinement.cost(),
              std::pair(test::weight_of(graph, zones, Zone::Outside), std::abs(low - high)));
}

TEST(SeparatorRefinement, NeverMakesASeparatorHeavier) {
    const WeightedGraph graph = test::graph_of(test::plane_grid(kSide));
    std::vector<Zone> zones = thick_separator(0);
    SeparatorRefinement refinement(graph, kMaxWeight, zones);
    const std::pair<int, int> before = refinement.cost();
    refinement.run();
    EXPECT_LE(refinement.cost(), before);
}

// Any node of a chain can be the separator. It starts at the left end and ends in the middle,
// because zones of equal weight are preferred.
TEST(SeparatorRefinement, PrefersZonesOfEqualWeight) {
    WeightedGraph chain;
    constexpr std::uint32_t kNodes = 41;
    chain.begins.push_back(0);
    for (std::uint32_t node = 0; node < kNodes; ++node) {
        chain.weights.push_back(1);
        if (node > 0) {
            chain.edges.push_back({node - 1, 1});
        }
        if (node + 1 < kNodes) {
            chain.edges.push_back({node + 1, 1});
        }
        chain.begins.push_back(static_cast<std::uint32_t>(chain.edges.size()));
    }
    std::vector<Zone> zones(kNodes, Zone::High);
    zones[0] = Zone::Outside;
    SeparatorRefinement refinement(chain, kNodes, zones);
    refinement.run();
    EXPECT_EQ(refinement.cost(), std::pair(1, 0));
    EXPECT_EQ(zones[kNodes / 2], Zone::Outside);
}

// With a separator of one column, the two zones weigh 380 together. If each may weigh at most 175,
// the separator must be heavier.
TEST(SeparatorRefinement, KeepsZonesWithinTheLimit) {
    const WeightedGraph graph = test::graph_of(test::plane_grid(kSide));
    std::vector<Zone> zones = thick_separator(3);
    constexpr int kLimit = 175;
    SeparatorRefinement(graph, kLimit, zones).run();
    EXPECT_LE(test::weight_of(graph, zones, Zone::Low), kLimit);
    EXPECT_LE(test::weight_of(graph, zones, Zone::High), kLimit);
    EXPECT_EQ(test::edges_across(graph, zones), 0);
}

}  // namespace
}  // namespace foam
