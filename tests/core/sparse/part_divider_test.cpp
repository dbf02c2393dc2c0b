// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/part_divider.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <numeric>
#include <optional>
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
    EXPECT_EQ(division.boxes.low->low, Vec2(0.0, 0.0));
    EXPECT_EQ(division.boxes.low->high.x(), division.boxes.high->low.x());
    EXPECT_EQ(division.boxes.high->high, Vec2(40.0, 30.0));
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

}  // namespace
}  // namespace foam
