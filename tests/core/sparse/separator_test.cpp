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

// A chain of eight nodes of two rows, except the third, which has one. The border is in its middle.
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

// The third node is in the first layer beside the border.
TEST(Separator, TakesTheLightestNodeOfTheBand) {
    EXPECT_EQ(separated_chain({.band_layers = 1, .band_fraction = 1.0}),
              (std::vector{kLow, kLow, kOutside, kHigh, kHigh, kHigh, kHigh, kHigh}));
}

// Of the two nodes at the border, which are equally light, the cut takes the one in the zone Low.
TEST(Separator, StaysAtTheBorderIfTheBandHasNoLayers) {
    const std::vector expected{kLow, kLow, kLow, kOutside, kHigh, kHigh, kHigh, kHigh};
    EXPECT_EQ(separated_chain({.band_layers = 0, .band_fraction = 1.0}), expected);
    // A layer would make the band hold two of four nodes of the zone.
    EXPECT_EQ(separated_chain({.band_layers = 1, .band_fraction = 0.4}), expected);
}

// A torus whose left half is in the zone Low; in odd rows, both borders are three columns further
// to the right.
std::vector<Zone> toothed_zones(const test::PointSystem& torus) {
    std::vector<Zone> zones;
    for (const SolverNode& node : torus.nodes) {
        const bool is_odd = static_cast<int>(node.position.y()) % 2 != 0;
        const double x = node.position.x() - (is_odd ? 3.0 : 0.0);
        zones.push_back(x > 0.0 && x < 0.5 * torus.domain.width ? kLow : kHigh);
    }
    return zones;
}

// A straight separator takes one node of each of the ten rows. If it must touch both zones, it
// takes two nodes of every other row, where it goes from one tooth to the next.
TEST(Separator, StraightensTheBorderWithinTheBand) {
    const test::PointSystem torus = test::torus_grid(20, 10);
    const NodeGraph graph = coupling(torus.matrix, torus.nodes);
    for (const auto& [layers, size] : {std::pair(0, 30), std::pair(1, 20)}) {
        const std::vector<Zone> zones = separated(graph,
                                                  torus.nodes,
                                                  toothed_zones(torus),
                                                  {.band_layers = layers, .band_fraction = 1.0});
        EXPECT_EQ(std::count(zones.begin(), zones.end(), kOutside), size) << layers << " layers";
        for (std::size_t node = 0; node < zones.size(); ++node) {
            for (const std::uint32_t neighbor : graph.of(node)) {
                EXPECT_FALSE(zones[node] == kLow && zones[neighbor] == kHigh);
            }
        }
    }
}

}  // namespace
}  // namespace foam
