// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dissection_repair.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace foam {
namespace {

constexpr int kSide = 40;

test::PointSystem grid() {
    return test::torus_grid(kSide, kSide);
}

// Returns the grid with a few more couplings, between points that are far from each other.
test::PointSystem grid_with_long_edges() {
    test::PointSystem system = grid();
    for (const auto& [low, high] : {std::pair{3, 900}, {17, 1303}, {411, 1599}, {820, 841}}) {
        system.matrix.coeffRef(high, low) = -1.0;
    }
    system.matrix.makeCompressed();
    return system;
}

NodeGraph node_graph_of(const test::PointSystem& system) {
    return node_graph(system.matrix, system.nodes);
}

Dissection dissection_of(const test::PointSystem& system) {
    return dissect(node_graph_of(system), system.nodes, system.domain, {});
}

// Returns the number of edges that join the two subtrees of a part.
int edges_across(const Dissection& dissection, const NodeGraph& graph) {
    std::vector<std::size_t> positions(dissection.order.size());
    for (std::size_t position = 0; position < positions.size(); ++position) {
        positions[dissection.order[position]] = position;
    }
    std::vector<std::size_t> begins;  // per part: the first position of its subtree
    int across = 0;
    for (const DissectionPart& part : dissection.parts) {
        begins.push_back(part.is_leaf() ? part.begin : begins[part.left]);
        if (part.is_leaf()) {
            continue;
        }
        const std::size_t middle = begins[part.right];
        for (std::size_t position = begins.back(); position < middle; ++position) {
            for (const std::uint32_t neighbor : graph.neighbors_of(dissection.order[position])) {
                const std::size_t other = positions[neighbor];
                across += other >= middle && other < part.begin ? 1 : 0;
            }
        }
    }
    return across;
}

TEST(DissectionRepair, SeparatesAgainAfterNewEdges) {
    Dissection dissection = dissection_of(grid());
    const NodeGraph graph = node_graph_of(grid_with_long_edges());
    ASSERT_GT(edges_across(dissection, graph), 0);
    ASSERT_TRUE(repair(dissection, graph));
    EXPECT_EQ(edges_across(dissection, graph), 0);
}

TEST(DissectionRepair, KeepsTheNodesOfAPartInDescendingOrder) {
    Dissection dissection = dissection_of(grid());
    ASSERT_TRUE(repair(dissection, node_graph_of(grid_with_long_edges())));
    for (const DissectionPart& part : dissection.parts) {
        EXPECT_TRUE(
            std::is_sorted(dissection.order.begin() + static_cast<std::ptrdiff_t>(part.begin),
                           dissection.order.begin() + static_cast<std::ptrdiff_t>(part.end),
                           std::greater<>()));
    }
}

TEST(DissectionRepair, KeepsAllNodesAndTheTree) {
    const Dissection before = dissection_of(grid());
    Dissection after = before;
    ASSERT_TRUE(repair(after, node_graph_of(grid_with_long_edges())));
    std::vector<std::uint32_t> nodes = after.order;
    std::sort(nodes.begin(), nodes.end());
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        ASSERT_EQ(nodes[node], node);
    }
    ASSERT_EQ(nodes.size(), before.order.size());
    ASSERT_EQ(after.parts.size(), before.parts.size());
    for (std::size_t k = 0; k < after.parts.size(); ++k) {
        EXPECT_EQ(after.parts[k].left, before.parts[k].left);
        EXPECT_EQ(after.parts[k].right, before.parts[k].right);
    }
}

TEST(DissectionRepair, ChangesNothingWithoutNewEdges) {
    const Dissection before = dissection_of(grid());
    Dissection after = before;
    ASSERT_TRUE(repair(after, node_graph_of(grid())));
    EXPECT_EQ(after.order, before.order);
}

TEST(DissectionRepair, RejectsAnotherNumberOfNodes) {
    const Dissection before = dissection_of(grid());
    Dissection after = before;
    EXPECT_FALSE(repair(after, node_graph_of(test::torus_grid(kSide, kSide + 1))));
    EXPECT_EQ(after.order, before.order);
}

}  // namespace
}  // namespace foam
