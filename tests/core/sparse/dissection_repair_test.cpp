// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dissection_repair.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
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

// Returns the numbers of the nodes of the grid, which are the same with and without the long edges.
std::vector<std::uint32_t> same_numbers() {
    std::vector<std::uint32_t> numbers(grid().nodes.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
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
    repair(dissection, graph, same_numbers());
    EXPECT_EQ(edges_across(dissection, graph), 0);
}

TEST(DissectionRepair, KeepsTheNodesOfAPartInDescendingOrder) {
    Dissection dissection = dissection_of(grid());
    repair(dissection, node_graph_of(grid_with_long_edges()), same_numbers());
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
    repair(after, node_graph_of(grid_with_long_edges()), same_numbers());
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
    repair(after, node_graph_of(grid()), same_numbers());
    EXPECT_EQ(after.order, before.order);
}

// Returns a square grid in the plane. The names of its nodes are their numbers.
test::PointSystem named_grid() {
    test::PointSystem system = test::plane_grid(kSide);
    for (std::size_t node = 0; node < system.nodes.size(); ++node) {
        system.nodes[node].name = node;
    }
    return system;
}

std::vector<std::uint64_t> names_of(const test::PointSystem& system) {
    std::vector<std::uint64_t> names;
    for (const SolverNode& node : system.nodes) {
        names.push_back(node.name);
    }
    return names;
}

// Returns the grid without the given nodes.
test::PointSystem without(const std::vector<std::size_t>& removed) {
    const test::PointSystem all = named_grid();
    test::PointSystem rest{all.domain, {}, {}};
    std::vector<Eigen::Index> new_numbers(all.nodes.size(), -1);
    for (std::size_t node = 0; node < all.nodes.size(); ++node) {
        if (std::ranges::find(removed, node) == removed.end()) {
            new_numbers[node] = std::ssize(rest.nodes);
            rest.nodes.push_back(all.nodes[node]);
        }
    }
    std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
    for (Eigen::Index column = 0; column < all.matrix.cols(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(all.matrix, column); entry; ++entry) {
            const Eigen::Index low = new_numbers[static_cast<std::size_t>(column)];
            const Eigen::Index high = new_numbers[static_cast<std::size_t>(entry.row())];
            if (low >= 0 && high > low) {
                pairs.emplace_back(low, high);
            }
        }
    }
    rest.matrix = test::coupled_matrix(std::ssize(rest.nodes), pairs);
    return rest;
}

TEST(DissectionRepair, AssumesTheSameNodesIfTheirNumberIsTheSame) {
    EXPECT_EQ(earlier_numbers(std::vector<std::uint64_t>{7, 5}, std::vector<SolverNode>(2)),
              (std::vector<std::uint32_t>{0, 1}));
}

TEST(DissectionRepair, FindsEarlierNodesByName) {
    std::vector<SolverNode> nodes(4);
    nodes[0].name = 30;
    nodes[1].name = 99;
    nodes[2].name = 10;
    nodes[3].name = 30 + 16;
    EXPECT_EQ(earlier_numbers(std::vector<std::uint64_t>{10, 20, 30, 30 + 16, 30}, nodes),
              (std::vector<std::uint32_t>{2, kNoNumber, 0, 3}));
}

// Removes a block of nodes, so that some parts become empty.
TEST(DissectionRepair, SeparatesAgainAfterNodesHaveVanished) {
    const test::PointSystem before = named_grid();
    std::vector<std::size_t> removed;
    for (std::size_t row = 10; row < 20; ++row) {
        for (std::size_t column = 15; column < 25; ++column) {
            removed.push_back(row * kSide + column);
        }
    }
    const test::PointSystem after = without(removed);
    const NodeGraph graph = node_graph_of(after);
    Dissection dissection = dissection_of(before);
    repair(dissection, graph, earlier_numbers(names_of(before), after.nodes));
    EXPECT_EQ(dissection.order.size(), before.nodes.size() - 100);
    EXPECT_EQ(edges_across(dissection, graph), 0);
    EXPECT_TRUE(std::ranges::any_of(
        dissection.parts, [](const DissectionPart& part) { return part.begin == part.end; }));
}

TEST(DissectionRepair, SeparatesAgainAfterNodesHaveAppeared) {
    const test::PointSystem before = without({3, 4, 5, 43, 44, 45, 820, 1599});
    const test::PointSystem after = named_grid();
    const NodeGraph graph = node_graph_of(after);
    Dissection dissection = dissection_of(before);
    repair(dissection, graph, earlier_numbers(names_of(before), after.nodes));
    EXPECT_EQ(dissection.order.size(), after.nodes.size());
    EXPECT_EQ(edges_across(dissection, graph), 0);
}

}  // namespace
}  // namespace foam
