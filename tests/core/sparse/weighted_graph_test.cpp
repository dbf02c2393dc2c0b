// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/weighted_graph.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace foam {
namespace {

constexpr int kAnyWeight = 1000000;

// Returns the graph of a square with the corners 0, 1, 2 and 3. The side from 1 to 2 has weight 5,
// the other sides weight 1.
WeightedGraph square() {
    return {{1, 2, 3, 4},
            {{1, 1}, {3, 1}, {0, 1}, {2, 5}, {1, 5}, {3, 1}, {0, 1}, {2, 1}},
            {0, 2, 4, 6, 8}};
}

int degree(const WeightedGraph& graph, std::uint32_t node) {
    return static_cast<int>(graph.edges_of(node).size());
}

// Node 0 is merged first, with the first of its neighbors, node 1. Nodes 2 and 3 are left. The two
// edges between the pairs become one edge of weight 5 + 1.
TEST(WeightedGraph, MergesNeighborsAndAddsUpTheirEdges) {
    const CoarseGraph coarse = coarsen(square(), kAnyWeight);
    EXPECT_EQ(coarse.coarse_of, (std::vector<std::uint32_t>{0, 0, 1, 1}));
    EXPECT_EQ(coarse.graph.weights, (std::vector{3, 7}));
    ASSERT_EQ(degree(coarse.graph, 0), 1);
    EXPECT_EQ(coarse.graph.edges_of(0).front().to, 1U);
    EXPECT_EQ(coarse.graph.edges_of(0).front().weight, 6);
    EXPECT_EQ(coarse.graph.edges_of(1).front().weight, 6);
}

// Pairs may weigh at most 5, so that node 0, of weight 4, cannot be merged with node 1 or 3. Node 1
// is then merged with node 2, to which its edge is heaviest.
TEST(WeightedGraph, MergesAcrossTheHeaviestEdgeWithinTheLimit) {
    WeightedGraph graph = square();
    graph.weights[0] = 4;
    const CoarseGraph coarse = coarsen(graph, 5);
    EXPECT_EQ(coarse.coarse_of, (std::vector<std::uint32_t>{0, 1, 1, 2}));
    EXPECT_EQ(coarse.graph.weights, (std::vector{4, 5, 4}));
}

std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const WeightedGraph& graph) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        for (const auto& [to, weight] : graph.edges_of(node)) {
            EXPECT_TRUE(edges.emplace(std::pair(node, to), weight).second) << "parallel edges";
        }
    }
    return edges;
}

TEST(WeightedGraph, KeepsWeightsOverManyRoundsOfMerging) {
    WeightedGraph fine = test::graph_of(test::torus_grid(17, 23));
    for (int round = 0; round < 5; ++round) {
        const CoarseGraph coarse = coarsen(fine, kAnyWeight);
        EXPECT_LT(coarse.graph.size(), 0.7 * fine.size());
        std::vector<int> weights(coarse.graph.size());
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (std::uint32_t node = 0; node < fine.size(); ++node) {
            weights[coarse.coarse_of[node]] += fine.weights[node];
            for (const auto& [to, weight] : fine.edges_of(node)) {
                if (coarse.coarse_of[node] != coarse.coarse_of[to]) {
                    edges[{coarse.coarse_of[node], coarse.coarse_of[to]}] += weight;
                }
            }
        }
        EXPECT_EQ(coarse.graph.weights, weights);
        EXPECT_EQ(edges_of(coarse.graph), edges);
        fine = coarse.graph;
    }
}

TEST(WeightedGraph, KeepsNodesWithoutNeighbors) {
    const CoarseGraph coarse = coarsen({{1, 1, 1}, {}, {0, 0, 0, 0}}, kAnyWeight);
    EXPECT_EQ(coarse.graph.weights, (std::vector{1, 1, 1}));
}

}  // namespace
}  // namespace foam
