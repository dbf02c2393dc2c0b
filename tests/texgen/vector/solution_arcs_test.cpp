// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/solution_arcs.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam::texgen {
namespace {

const Page kPage{10.0, 10.0, 1.0, 1.0, Vec2(0.0, 0.0), kPlane};

// Stations on a circle of radius 1, with its tangents: both arcs are parts of the circle.
TEST(SolutionArcs, ACircleStaysACircle) {
    const std::vector<Station> stations = {{{1.0, 0.0}, {0.0, 1.0}}, {{0.0, 1.0}, {-1.0, 0.0}}};
    const std::vector<DrawnArc> arcs = smooth_arcs(stations, kPage);
    ASSERT_EQ(arcs.size(), 2U);
    EXPECT_NEAR(arcs[0].head.norm(), 1.0, 1e-15);
    for (const DrawnArc& arc : arcs) {
        EXPECT_NEAR(arc.half_angle, std::numbers::pi / 8.0, 1e-15);
    }
}

TEST(SolutionArcs, AStraightLineStaysStraight) {
    const std::vector<Station> stations = {{{0.0, 0.0}, {1.0, 0.0}}, {{4.0, 0.0}, {1.0, 0.0}}};
    const std::vector<DrawnArc> arcs = smooth_arcs(stations, kPage);
    EXPECT_EQ(arcs[0].half_angle, 0.0);
    EXPECT_EQ(arcs[0].head, Vec2(2.0, 0.0));
}

// An S between parallel directions: both arcs meet in the middle with the same tangent.
TEST(SolutionArcs, ArcsMeetSmoothly) {
    const std::vector<Station> stations = {{{0.0, 0.0}, {1.0, 0.0}}, {{2.0, 1.0}, {1.0, 0.0}}};
    const std::vector<DrawnArc> arcs = smooth_arcs(stations, kPage);
    EXPECT_NEAR((arcs[0].head - Vec2(1.0, 0.5)).norm(), 0.0, 1e-15);
    EXPECT_NEAR(
        (tangent_at_head(arcs[0].arc()) - tangent_at_tail(arcs[1].arc())).norm(), 0.0, 1e-14);
    EXPECT_NEAR((tangent_at_tail(arcs[0].arc()) - Vec2(1.0, 0.0)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((tangent_at_head(arcs[1].arc()) - Vec2(1.0, 0.0)).norm(), 0.0, 1e-14);
}

}  // namespace
}  // namespace foam::texgen
