// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/node_graph.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

using Neighbors = std::vector<std::uint32_t>;

Neighbors neighbors_of(const NodeGraph& graph, std::size_t node) {
    return {graph.neighbors_of(node).begin(), graph.neighbors_of(node).end()};
}

// The first node has rows 0 and 1, the second row 2, the third rows 3 and 4. Two entries couple the
// first node with the third, and one entry couples the second with the third. The entry within the
// first node is ignored.
TEST(NodeGraph, CouplesNodesThatShareAnEntry) {
    const std::vector<SolverNode> nodes{{Vec2::Zero(), 2}, {Vec2::Zero(), 1}, {Vec2::Zero(), 2}};
    Eigen::SparseMatrix<double> lower(5, 5);
    const std::vector<std::pair<int, int>> entries{
        {0, 0}, {1, 0}, {3, 0}, {1, 1}, {4, 1}, {2, 2}, {3, 2}, {3, 3}, {4, 4}};
    for (const auto& [row, column] : entries) {
        lower.insert(row, column) = 1.0;
    }
    lower.makeCompressed();
    const NodeGraph graph = node_graph(lower, nodes);
    EXPECT_EQ(neighbors_of(graph, 0), (Neighbors{2}));
    EXPECT_EQ(neighbors_of(graph, 1), (Neighbors{2}));
    EXPECT_EQ(neighbors_of(graph, 2), (Neighbors{0, 1}));
}

TEST(NodeGraph, HasNoLoops) {
    Eigen::SparseMatrix<double> diagonal(3, 3);
    diagonal.setIdentity();
    const NodeGraph graph = node_graph(diagonal, std::vector<SolverNode>(3));
    EXPECT_TRUE(graph.neighbors.empty());
    EXPECT_EQ(graph.begins, std::vector<std::size_t>(4, 0));
}

}  // namespace
}  // namespace foam
