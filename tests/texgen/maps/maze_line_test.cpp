// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/maze_line.h"

#include "tests/support/sample_foams.h"
#include "texgen/maps/maze_graph.h"
#include "texgen/raster/distance/region.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace foam::texgen {
namespace {

constexpr double kScale = 50.0;  // pixels per foam unit

// Returns the end of a piece in foam units.
Vec2 head_of(const PlacedArc& piece) {
    return piece.tail + piece.arc.chord / kScale;
}

TEST(MazeLine, IsOneLineWithoutSharpTurns) {
    const Frame frame = snapshot(test::polydisperse_foam(60, 3), 1);
    const std::vector<PlacedArc> line = solution_line(frame, find_maze(frame, {}).solution, kScale);
    ASSERT_FALSE(line.empty());
    for (std::size_t k = 1; k < line.size(); ++k) {
        EXPECT_LT((head_of(line[k - 1]) - line[k].tail).norm(), 1e-12);
        const Vec2 before = line[k - 1].arc.chord.normalized();
        const Vec2 after = line[k].arc.chord.normalized();
        EXPECT_GT(before.dot(after), 0.5) << "piece " << k;
    }
}

TEST(MazeLine, CrossesFilmsInTheirMiddle) {
    const Frame frame = snapshot(test::patch_foam(50, 2), 1);
    const std::vector<HalfEdgeId> way = find_maze(frame, {}).solution;
    const std::vector<PlacedArc> line = solution_line(frame, way, kScale);
    const std::size_t pieces = line.size() / (way.size() - 1);
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        const Vec2 crossing = line[pieces * k].tail;
        const Vec2 tail = frame.positions[frame.network.tail(way[k])];
        const Vec2 middle = tail + halves(pixel_arc(frame.arc(way[k])))[0].chord;
        EXPECT_LT((crossing - middle).norm(), 1e-9);
    }
}

TEST(MazeLine, WithoutAWayIsEmpty) {
    const Frame frame = snapshot(test::single_bubble(), 1);
    EXPECT_TRUE(solution_line(frame, {}, kScale).empty());
}

}  // namespace
}  // namespace foam::texgen
