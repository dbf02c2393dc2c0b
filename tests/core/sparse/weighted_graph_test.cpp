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

// Nodes 0, 1, 2 and 3 around a square, whose side from 1 to 2 has weight 5 and the others 1.
WeightedGraph square() {
    return {{1, 2, 3, 4},
            {{1, 1}, {3, 1}, {0, 1}, {2, 5}, {1, 5}, {3, 1}, {0, 1}, {2, 1}},
            {0, 2, 4, 6, 8}};
}

int degree(const WeightedGraph& graph, std::uint32_t node) {
    return static_cast<int>(graph.of(node).size());
}

// Node 0 comes first and takes node 1, the first of its neighbors; 2 and 3 are left. The two sides
// between the pairs become one edge of weight 5 + 1.
TEST(WeightedGraph, MergesNeighborsAndAddsUpTheirEdges) {
    const CoarseGraph coarse = coarsen(square(), kAnyWeight);
    EXPECT_EQ(coarse.coarse_of, (std::vector<std::uint32_t>{0, 0, 1, 1}));
    EXPECT_EQ(coarse.graph.weights, (std::vector{3, 7}));
    ASSERT_EQ(degree(coarse.graph, 0), 1);
    EXPECT_EQ(coarse.graph.of(0).front().to, 1U);
    EXPECT_EQ(coarse.graph.of(0).front().weight, 6);
    EXPECT_EQ(coarse.graph.of(1).front().weight, 6);
}

// Node 0 would take 1 or 3, but is too heavy with either if pairs may weigh 5: 1 and 3 are then
// free, 1 takes 2, with which it shares the heavier edge.
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
        for (const auto& [to, weight] : graph.of(node)) {
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
            for (const auto& [to, weight] : fine.of(node)) {
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
