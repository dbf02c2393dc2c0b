// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/separator.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace foam {
namespace {

constexpr Zone kLow = Zone::Low;
constexpr Zone kHigh = Zone::High;
constexpr Zone kOutside = Zone::Outside;

std::vector<Zone> separated(const NodeGraph& graph,
                            const std::vector<SolverNode>& nodes,
                            std::vector<Zone> zones,
                            const SeparatorOptions& options) {
    std::vector<std::uint32_t> band(nodes.size(), SeparatorSearch::kNotInBand);
    std::vector<std::uint32_t> part(nodes.size());
    std::iota(part.begin(), part.end(), 0U);
    SeparatorSearch(graph, nodes, options, zones, band).separate(part);
    EXPECT_EQ(band, std::vector(nodes.size(), SeparatorSearch::kNotInBand));
    return zones;
}

// Returns the zones of a chain of eight nodes after `separate`. The third node has one row, each
// other node two rows. The border between the zones is in the middle of the chain.
std::vector<Zone> separated_chain(const SeparatorOptions& options) {
    NodeGraph chain;
    std::vector<SolverNode> nodes;
    chain.begins.push_back(0);
    for (std::uint32_t node = 0; node < 8; ++node) {
        nodes.push_back({Vec2::Zero(), node == 2 ? 1 : 2});
        if (node > 0) {
            chain.neighbors.push_back(node - 1);
        }
        if (node < 7) {
            chain.neighbors.push_back(node + 1);
        }
        chain.begins.push_back(chain.neighbors.size());
    }
    return separated(chain, nodes, {kLow, kLow, kLow, kLow, kHigh, kHigh, kHigh, kHigh}, options);
}

// The third node is one layer away from the border and is therefore in the band.
TEST(Separator, TakesTheLightestNodeOfTheBand) {
    EXPECT_EQ(separated_chain({.band_layers = 1, .band_fraction = 1.0}),
              (std::vector{kLow, kLow, kOutside, kHigh, kHigh, kHigh, kHigh, kHigh}));
}

// The two nodes at the border are equally light. The cut takes the node in the zone Low.
TEST(Separator, StaysAtTheBorderIfTheBandHasNoLayers) {
    const std::vector expected{kLow, kLow, kLow, kOutside, kHigh, kHigh, kHigh, kHigh};
    EXPECT_EQ(separated_chain({.band_layers = 0, .band_fraction = 1.0}), expected);
    // With one layer the band would hold two of the four nodes of a zone, more than the fraction
    // 0.4.
    EXPECT_EQ(separated_chain({.band_layers = 1, .band_fraction = 0.4}), expected);
}

// Returns zones of a torus, whose left half is in the zone Low. In odd rows, both borders are three
// columns further to the right.
std::vector<Zone> toothed_zones(const test::PointSystem& torus) {
    std::vector<Zone> zones;
    for (const SolverNode& node : torus.nodes) {
        const bool is_odd = static_cast<int>(node.position.y()) % 2 != 0;
        const double x = node.position.x() - (is_odd ? 3.0 : 0.0);
        zones.push_back(x > 0.0 && x < 0.5 * torus.domain.width ? kLow : kHigh);
    }
    return zones;
}

// The two borders of the torus need a separator each. A straight separator takes one node of each
// of the ten rows. Without layers, a separator has to follow the border and takes two nodes of
// every other row.
TEST(Separator, StraightensTheBorderWithinTheBand) {
    const test::PointSystem torus = test::torus_grid(20, 10);
    const NodeGraph graph = node_graph(torus.matrix, torus.nodes);
    for (const auto& [layers, size] : {std::pair(0, 30), std::pair(1, 20)}) {
        const std::vector<Zone> zones = separated(graph,
                                                  torus.nodes,
                                                  toothed_zones(torus),
                                                  {.band_layers = layers, .band_fraction = 1.0});
        EXPECT_EQ(std::count(zones.begin(), zones.end(), kOutside), size) << layers << " layers";
        for (std::size_t node = 0; node < zones.size(); ++node) {
            for (const std::uint32_t neighbor : graph.neighbors_of(node)) {
                EXPECT_FALSE(zones[node] == kLow && zones[neighbor] == kHigh);
            }
        }
    }
}

}  // namespace
}  // namespace foam
