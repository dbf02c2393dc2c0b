// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/halving.h"

#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace foam {
namespace {

constexpr Zone kLow = Zone::Low;
constexpr Zone kHigh = Zone::High;

// Halves all points of a system along x, and returns their zones.
std::vector<Zone> halves_of(const test::PointSystem& system, const PartBox& box) {
    std::vector<std::uint32_t> part(system.nodes.size());
    std::iota(part.begin(), part.end(), 0U);
    std::vector<Zone> zones(part.size(), Zone::Outside);
    halve_at_median(part, system.nodes, periods_of(system.domain), box, 0, zones);
    return zones;
}

test::PointSystem points_in_plane(const std::vector<double>& coordinates) {
    test::PointSystem system{kPlane, {}, {}};
    for (const double x : coordinates) {
        system.nodes.push_back({Vec2(x, 0.0), 1});
    }
    return system;
}

TEST(HalveAtMedian, PutsTheLowerCoordinatesIntoLow) {
    const test::PointSystem system = points_in_plane({3.0, -1.0, 7.0, 2.0});
    const PartBox box{Vec2(-1.0, 0.0), Vec2(7.0, 0.0)};
    EXPECT_EQ(halves_of(system, box), (std::vector{kHigh, kLow, kHigh, kLow}));
}

TEST(HalveAtMedian, ReturnsTheCoordinateOfTheBorder) {
    const test::PointSystem system = points_in_plane({3.0, -1.0, 7.0, 2.0});
    const std::vector<std::uint32_t> part{0, 1, 2, 3};
    std::vector<Zone> zones(4, Zone::Outside);
    const PartBox box{Vec2(-1.0, 0.0), Vec2(7.0, 0.0)};
    EXPECT_EQ(halve_at_median(part, system.nodes, periods_of(kPlane), box, 0, zones), 3.0);
}

TEST(HalveAtMedian, DividesEqualCoordinatesByIndex) {
    const test::PointSystem system = points_in_plane({5.0, 5.0, 5.0, 5.0});
    EXPECT_EQ(halves_of(system, {}), (std::vector{kLow, kLow, kHigh, kHigh}));
}

TEST(HalveAtMedian, ReplacesACoordinateThatIsNotFiniteByTheMiddle) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const test::PointSystem system = points_in_plane({-1.0, nan, -2.0, 3.0});
    const PartBox box{Vec2(-2.0, 0.0), Vec2(3.0, 0.0)};
    EXPECT_EQ(halves_of(system, box), (std::vector{kLow, kHigh, kLow, kHigh}));
}

// The box is around the border of the torus, from 3 to 7 on a torus of width 4.
TEST(HalveAtMedian, WrapsCoordinatesAroundTheTorus) {
    test::PointSystem system = points_in_plane({0.5, 1.5, 2.9, 3.5});
    system.domain = {4.0, 4.0};
    const PartBox box{Vec2(3.0, 0.0), Vec2(7.0, 4.0)};
    EXPECT_EQ(halves_of(system, box), (std::vector{kLow, kHigh, kHigh, kLow}));
}

// A grid on the torus whose points are moved at random along x and have one or two rows.
struct RandomGrid {
    explicit RandomGrid(int width) : system(test::torus_grid(width, 9)) {
        graph = node_graph(system.matrix, system.nodes);
        part.resize(system.nodes.size());
        std::iota(part.begin(), part.end(), 0U);
        std::mt19937 bits(1);
        for (SolverNode& node : system.nodes) {
            node.position.x() += static_cast<double>(bits()) / 4294967296.0 - 0.5;
            node.rows = 1 + static_cast<int>(bits() % 2);
        }
    }

    // Halves the part at the lightest position, and sets `zones`.
    LowRange halve() {
        zones.assign(system.nodes.size(), Zone::Outside);
        return halve_at_lightest_position(part, system.nodes, graph, system.domain.width, 0, zones);
    }

    // Sets `zones` for a position at which Low begins with the given point in the order along x.
    void halve_from(std::size_t first) {
        std::vector<std::uint32_t> sorted = part;
        std::ranges::sort(sorted, {}, [this](std::uint32_t node) {
            const double x = system.nodes[node].position.x();
            return x - system.domain.width * std::floor(x / system.domain.width);
        });
        zones.assign(system.nodes.size(), Zone::Outside);
        for (std::size_t k = 0; k < sorted.size(); ++k) {
            const std::uint32_t node = sorted[(first + k) % sorted.size()];
            zones[node] = k < sorted.size() / 2 ? Zone::Low : Zone::High;
        }
    }

    // Returns the number of rows of the separator between the two halves in `zones`.
    int separator_rows() {
        separate_halves(part, system.nodes, graph, zones);
        int rows = 0;
        for (const std::uint32_t node : part) {
            rows += zones[node] == Zone::Outside ? system.nodes[node].rows : 0;
        }
        return rows;
    }

    // Returns the number of rows of the separators at all positions.
    std::vector<int> rows_at_all_positions() {
        std::vector<int> rows;
        for (std::size_t first = 0; first < part.size(); ++first) {
            halve_from(first);
            rows.push_back(separator_rows());
        }
        return rows;
    }

    test::PointSystem system;
    NodeGraph graph;
    std::vector<std::uint32_t> part;
    std::vector<Zone> zones;
};

TEST(HalveAtLightestPosition, FindsTheLightestSeparatorOfAllPositions) {
    for (const int width : {11, 12}) {
        RandomGrid grid(width);
        const std::vector<int> all = grid.rows_at_all_positions();
        grid.halve();
        EXPECT_EQ(grid.separator_rows(), std::ranges::min(all)) << width;
        EXPECT_LT(std::ranges::min(all), std::ranges::max(all)) << width;
    }
}

// Only two rows of the grid belong to the part.
TEST(HalveAtLightestPosition, IgnoresNeighborsOutsideOfThePart) {
    RandomGrid grid(12);
    grid.part.resize(24);
    const std::vector<int> all = grid.rows_at_all_positions();
    grid.halve();
    EXPECT_EQ(grid.separator_rows(), std::ranges::min(all));
    EXPECT_LT(std::ranges::min(all), std::ranges::max(all));
}

TEST(HalveAtLightestPosition, ReturnsTheCoordinatesOfBothBorders) {
    RandomGrid grid(12);
    const LowRange low = grid.halve();
    EXPECT_GE(low.begin, 0.0);
    EXPECT_LT(low.begin, 12.0);
    const double length = low.end - low.begin;
    for (const std::uint32_t node : grid.part) {
        const double x = grid.system.nodes[node].position.x() - low.begin;
        const double from_begin = x - 12.0 * std::floor(x / 12.0);
        EXPECT_EQ(from_begin < length, grid.zones[node] == Zone::Low) << node;
    }
}

// The box around Low and High is of no use if there are so few points, but nothing may fail.
TEST(HalveAtLightestPosition, HalvesPartsOfOneOrTwoPoints) {
    for (const std::size_t points : {std::size_t{1}, std::size_t{2}}) {
        RandomGrid grid(12);
        grid.part.resize(points);
        grid.halve();
        EXPECT_EQ(std::ranges::count(grid.zones, Zone::Low), std::ssize(grid.part) / 2);
    }
}

TEST(HalveAtLightestPosition, AcceptsCoordinatesThatAreEqualOrNotFinite) {
    RandomGrid grid(12);
    for (const std::uint32_t node : grid.part) {
        Vec2& position = grid.system.nodes[node].position;
        position.x() = node % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e17;
    }
    const LowRange low = grid.halve();
    EXPECT_TRUE(std::isfinite(low.begin) && std::isfinite(low.end));
    EXPECT_EQ(std::ranges::count(grid.zones, Zone::Low), std::ssize(grid.part) / 2);
}

TEST(SeparateHalves, TakesTheRimWithFewerRows) {
    test::PointSystem system = test::plane_grid(4);
    const NodeGraph graph = node_graph(system.matrix, system.nodes);
    for (std::size_t node = 0; node < system.nodes.size(); ++node) {
        system.nodes[node].rows = node % 4 == 2 ? 2 : 1;  // the column on the right of the cut
    }
    std::vector<std::uint32_t> part(16);
    std::iota(part.begin(), part.end(), 0U);
    std::vector<Zone> zones = halves_of(system, {Vec2(0.0, 0.0), Vec2(3.0, 3.0)});
    separate_halves(part, system.nodes, graph, zones);
    for (std::size_t node = 0; node < zones.size(); ++node) {
        const Zone expected = node % 4 == 0 ? kLow : node % 4 == 1 ? Zone::Outside : kHigh;
        EXPECT_EQ(zones[node], expected) << node;
    }
}

}  // namespace
}  // namespace foam
