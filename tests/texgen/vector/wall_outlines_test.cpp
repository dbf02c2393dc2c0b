// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/wall_outlines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;

double area_of(const std::vector<Chain>& chains) {
    double area = 0.0;
    for (const Chain& chain : chains) {
        EXPECT_TRUE(chain.is_closed);
        EXPECT_NEAR((chain.head() - chain.tail).norm(), 0.0, 1e-9);
        area += signed_area(chain);
    }
    return area;
}

// A wall with round ends: a rectangle and two half disks.
TEST(WallOutlines, AStraightWallHasRoundEnds) {
    const std::vector<NetArc> line = {{{{1.0, 1.0}, {4.0, 5.0}, 0.0}, 0, 1}};
    const auto outlines = wall_outlines(line, 0.8);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_NEAR(area_of(outlines), 5.0 * 0.8 + kPi * 0.16, 1e-7);
}

// The outline of a circle is a ring between the radii 2 - 0.25 and 2 + 0.25.
TEST(WallOutlines, ACircleIsARing) {
    const std::vector<DrawnArc> arcs = arcs_of(circle({3.0, 3.0}, 2.0));
    const std::vector<NetArc> lines = {{arcs[0], 0, 1}, {arcs[1], 1, 0}};
    const auto outlines = wall_outlines(lines, 0.5);
    ASSERT_EQ(outlines.size(), 2U);
    EXPECT_NEAR(area_of(outlines), 2.0 * kPi * 2.0 * 0.5, 1e-7);
}

// Three walls of length L and half width h that meet at 120 degrees. Each wall is cut off along
// lines through the junction: it has the area 2 h L - h² / sqrt(3), because the cut removes two
// triangles with the legs h and h / sqrt(3).
TEST(WallOutlines, ThreeWallsAtAJunctionAreOneOutline) {
    std::vector<NetArc> lines;
    for (const int k : {0, 1, 2}) {
        const Vec2 head = 3.0 * unit_vector(2.0 * kPi / 3.0 * k + 0.2);
        lines.push_back({{{0.0, 0.0}, head, 0.0}, 0, static_cast<std::uint64_t>(k) + 1});
    }
    const double h = 0.4;
    const auto outlines = wall_outlines(lines, 2.0 * h);
    ASSERT_EQ(outlines.size(), 1U);
    const double wall = 2.0 * h * 3.0 - h * h / std::sqrt(3.0);
    EXPECT_NEAR(area_of(outlines), 3.0 * (wall + 0.5 * kPi * h * h), 1e-7);
}

// Walls that are closer than their width grow together: two parallel walls are one stadium with a
// height of gap + width, without a hole.
TEST(WallOutlines, NearWallsAreJoined) {
    const std::vector<NetArc> lines = {{{{0.0, 0.0}, {5.0, 0.0}, 0.0}, 0, 1},
                                       {{{0.0, 0.5}, {5.0, 0.5}, 0.0}, 2, 3}};
    const auto outlines = wall_outlines(lines, 1.0);
    ASSERT_EQ(outlines.size(), 1U);
    // At each end, two half disks of radius 0.5 whose centers are 0.5 apart: their union is a disk
    // of which half is outside, plus the lens-shaped rest: the area of two disks minus their lens.
    const double lens = 2.0 * 0.25 * std::acos(0.5) - 0.5 * 0.5 * std::sqrt(4.0 * 0.25 - 0.25);
    EXPECT_NEAR(area_of(outlines), 5.0 * 1.5 + (2.0 * kPi * 0.25 - lens), 1e-7);
}

// The tolerances do not depend on the size of the drawing: a wall of 5 by 0.5 micrometers.
TEST(WallOutlines, SmallDrawingsAreAsExact) {
    const std::vector<NetArc> lines = {{{{0.0, 0.0}, {5e-3, 0.0}, 0.0}, 0, 1}};
    const double area = 5e-3 * 5e-4 + kPi * 2.5e-4 * 2.5e-4;
    EXPECT_NEAR(area_of(wall_outlines(lines, 5e-4)) / area, 1.0, 1e-6);
}

TEST(WallOutlines, NoLinesHaveNoOutlines) {
    EXPECT_TRUE(wall_outlines({}, 1.0).empty());
}

}  // namespace
}  // namespace foam::texgen
