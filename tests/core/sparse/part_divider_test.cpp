// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/part_divider.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace foam {
namespace {

struct Division {
    std::vector<Zone> zones;
    ZoneBoxes boxes;
    int separator = 0;  // rows
};

Division divide_all(const test::PointSystem& system, const DissectionOptions& options = {}) {
    const NodeGraph graph = node_graph(system.matrix, system.nodes);
    DivisionMemory memory(system.nodes.size());
    PartDivider divider(graph, system.nodes, system.domain, options, memory);
    std::vector<std::uint32_t> part(system.nodes.size());
    std::iota(part.begin(), part.end(), 0U);
    const auto rows = static_cast<int>(part.size());
    const ZoneBoxes boxes = divider.divide(part, rows, divider.box_of_all());
    const WeightedGraph weighted = test::graph_of(system);
    EXPECT_EQ(test::edges_across(weighted, memory.zones), 0);
    return {memory.zones, boxes, test::weight_of(weighted, memory.zones, Zone::Outside)};
}

TEST(PartDivider, TrustsPositionsThatProposeALightSeparator) {
    const Division division = divide_all(test::torus_grid(40, 30));
    EXPECT_EQ(division.separator, 2 * 30);
    ASSERT_TRUE(division.boxes.low && division.boxes.high);
    const PartBox& low = *division.boxes.low;
    const PartBox& high = *division.boxes.high;
    EXPECT_EQ(Vec2(low.high - low.low), Vec2(20.0, 30.0));
    EXPECT_EQ(low.high.x(), high.low.x());
    EXPECT_EQ(Vec2(high.high - high.low), Vec2(20.0, 30.0));
}

// If scattered points were divided by position, half of all couplings would cross the cut.
TEST(PartDivider, DividesByTheGraphIfPositionsMislead) {
    test::PointSystem system = test::torus_grid(40, 30);
    test::scatter(system);
    const Division division = divide_all(system);
    EXPECT_LE(division.separator, 1.1 * 2 * 30);
    EXPECT_FALSE(division.boxes.low || division.boxes.high);
}

TEST(PartDivider, DividesByTheGraphIfThereIsNoBox) {
    const test::PointSystem system = test::plane_grid(20);
    const NodeGraph graph = node_graph(system.matrix, system.nodes);
    DivisionMemory memory(system.nodes.size());
    std::vector<std::uint32_t> part(system.nodes.size());
    std::iota(part.begin(), part.end(), 0U);
    PartDivider divider(graph, system.nodes, system.domain, {}, memory);
    EXPECT_FALSE(divider.divide(part, 400, std::nullopt).low);
    EXPECT_LE(test::weight_of(test::graph_of(system), memory.zones, Zone::Outside), 25);
}

// Every other coupling between the columns 9 and 10, and between the columns 29 and 30, is missing.
TEST(PartDivider, UsesTheLightestPositionOnATorus) {
    constexpr Eigen::Index kWidth = 40;
    test::PointSystem system = test::torus_grid(kWidth, 30);
    system.matrix.prune([](Eigen::Index row, Eigen::Index column, double /*value*/) {
        const bool is_horizontal = row == column + 1;
        const bool is_weak = column % kWidth == 9 || column % kWidth == 29;
        return !is_horizontal || !is_weak || row / kWidth % 2 == 0;
    });
    EXPECT_EQ(divide_all(system, {.min_refined_rows = 100000}).separator, 2 * 15);
}

// In every other group of four rows, points are shifted to the right, so that the cut at the median
// is toothed.
TEST(PartDivider, RefinesSeparators) {
    test::PointSystem system = test::plane_grid(50);
    for (SolverNode& node : system.nodes) {
        const bool is_shifted = static_cast<int>(node.position.y()) % 8 < 4;
        node.position.x() += is_shifted ? 8.0 : 0.0;
    }
    const int rough = divide_all(system, {.min_refined_rows = 100000}).separator;
    const int refined = divide_all(system, {.min_refined_rows = 1}).separator;
    EXPECT_GT(rough, 60);
    EXPECT_LE(refined, 55);
}

// Returns a graph of nodes with the given edges.
NodeGraph graph_with_edges(std::size_t nodes,
                           const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges) {
    std::vector<std::vector<std::uint32_t>> neighbors(nodes);
    for (const auto& [a, b] : edges) {
        neighbors[a].push_back(b);
        neighbors[b].push_back(a);
    }
    NodeGraph graph{{}, {0}};
    for (std::vector<std::uint32_t>& list : neighbors) {
        std::sort(list.begin(), list.end());
        graph.neighbors.insert(graph.neighbors.end(), list.begin(), list.end());
        graph.begins.push_back(graph.neighbors.size());
    }
    return graph;
}

// Refinement moves the separator along a chain of seven nodes, whose last node is too far from the
// first separator to be a node of its own in the refined graph. The low zone is a star; the high
// zone consists of a heavier star and the chain; the first separator is the node between them.
TEST(PartDivider, MovesTheNodesFarFromTheSeparatorWithTheZones) {
    constexpr std::uint32_t kLeaves = 27;
    constexpr std::uint32_t kHeavyLeaves = 20;
    constexpr std::uint32_t kChain = 7;
    std::vector<SolverNode> nodes;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    const auto add = [&nodes](double x, int rows) {
        nodes.push_back({Vec2(x, 0.0), rows});
        return static_cast<std::uint32_t>(nodes.size() - 1);
    };
    const std::uint32_t low_center = add(0.0, 6);
    for (std::uint32_t leaf = 0; leaf < kLeaves; ++leaf) {
        edges.emplace_back(low_center, add(0.0, 1));
    }
    const std::uint32_t between = add(1.0, 5);
    edges.emplace_back(low_center, between);
    const std::uint32_t high_center = add(2.0, 2);
    edges.emplace_back(between, high_center);
    for (std::uint32_t leaf = 0; leaf < kHeavyLeaves; ++leaf) {
        edges.emplace_back(high_center, add(2.0, 2));
    }
    std::uint32_t end_of_chain = between;
    for (std::uint32_t link = 0; link < kChain; ++link) {
        const std::uint32_t next = add(2.0, 1);
        edges.emplace_back(end_of_chain, next);
        end_of_chain = next;
    }
    const NodeGraph graph = graph_with_edges(nodes.size(), edges);
    DivisionMemory memory(nodes.size());
    const DissectionOptions options{.min_refined_rows = 1};
    PartDivider divider(graph, nodes, {0.0, 0.0}, options, memory);
    std::vector<std::uint32_t> part(nodes.size());
    std::iota(part.begin(), part.end(), 0U);
    divider.divide(part, 87, PartBox{Vec2(0.0, 0.0), Vec2(2.0, 0.0)});
    EXPECT_EQ(memory.zones[high_center], Zone::Outside);
    EXPECT_EQ(memory.zones[end_of_chain], Zone::Low);
    for (const auto& [a, b] : edges) {
        EXPECT_TRUE(memory.zones[a] == Zone::Outside || memory.zones[b] == Zone::Outside ||
                    memory.zones[a] == memory.zones[b])
            << a << ", " << b;
    }
}

}  // namespace
}  // namespace foam
