// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/monotone_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr ArcSides kSides{3, 5, 1, -2};

TEST(MonotoneArc, RisesFromItsLowerEnd) {
    const PixelArc arc = pixel_arc({{1.0, -2.0}, 0.1});
    std::vector<MonotoneArc> to;
    append_arc(arc, {0, 2048}, {1024, 0}, kSides, to);
    const MonotoneArc expected{{1024, 0}, {0, 2048}, -arc.sine, {5, 3, -2, 1}};
    EXPECT_EQ(to, std::vector<MonotoneArc>{expected});
}

TEST(MonotoneArc, IsLeftOutIfItIsLevel) {
    std::vector<MonotoneArc> to;
    append_arc(pixel_arc({{3.0, 0.0}, 0.0}), {0, 7}, {3072, 7}, kSides, to);
    append_piece({5, 7}, {9, 7}, 0.0, kSides, to);
    EXPECT_TRUE(to.empty());
}

// The arc is half a circle of radius 1 with a vertical chord. Its first piece goes right and its
// second piece left; both rise.
TEST(MonotoneArc, IsCutWhereTheArcGoesBack) {
    std::vector<MonotoneArc> to;
    append_arc(pixel_arc({{0.0, 2.0}, 0.5 * kPi}), {0, 0}, {0, 2048}, kSides, to);
    ASSERT_EQ(to.size(), 2U);
    EXPECT_EQ(to[0].low, (SubpixelPoint{0, 0}));
    EXPECT_EQ(to[0].high, (SubpixelPoint{1024, 1024}));
    EXPECT_EQ(to[1].low, to[0].high);
    EXPECT_EQ(to[1].high, (SubpixelPoint{0, 2048}));
    for (const MonotoneArc& piece : to) {
        EXPECT_NEAR(piece.sine, std::sqrt(0.5), 1e-12);
        EXPECT_EQ(piece.sides, kSides);
    }
}

// The arcs bound half a disc of radius 1, whose area is pi / 2. For a quarter of a circle, the
// power series of the area between chord and arc has a relative error of 2.5e-3.
TEST(MonotoneArc, ChainHasTheAreaOnItsLeft) {
    std::vector<MonotoneArc> chain;
    append_arc(pixel_arc({{0.0, 2.0}, 0.5 * kPi}), {0, 0}, {0, 2048}, {9}, chain);
    append_arc(pixel_arc({{0.0, -2.0}, 0.0}), {0, 2048}, {0, 0}, {9}, chain);
    const double area = 0.5 * twice_area(chain, 9) / (1024.0 * 1024.0);
    EXPECT_NEAR(area, 0.5 * kPi, 2e-3);
    std::vector<MonotoneArc> clockwise;
    append_arc(pixel_arc({{0.0, 2.0}, 0.0}), {0, 0}, {0, 2048}, {9}, clockwise);
    append_arc(pixel_arc({{0.0, -2.0}, -0.5 * kPi}), {0, 2048}, {0, 0}, {9}, clockwise);
    EXPECT_NEAR(0.5 * twice_area(clockwise, 9) / (1024.0 * 1024.0), -0.5 * kPi, 2e-3);
}

// A maker for make_arcs. For item k it appends k arcs and counts one unresolved boundary.
struct CountingMaker {
    void operator()(std::size_t k, ArcBatch& batch) const {
        batch.arcs.resize(batch.arcs.size() + k);
        ++batch.unclosed_loops;
    }
};

TEST(MonotoneArc, BatchesAreMadeByTasks) {
    const CellArcs cells = make_arcs(
        {4, 6}, 5, 2, [] { return CountingMaker{}; }, 2);
    ASSERT_EQ(cells.batches.size(), 3U);
    EXPECT_EQ(cells.batches[0].size(), 1U);
    EXPECT_EQ(cells.batches[1].size(), 5U);
    EXPECT_EQ(cells.batches[2].size(), 4U);
    EXPECT_EQ(cells.unclosed_loops, 5);
    EXPECT_EQ(cells.grid.height, 6);
}

}  // namespace
}  // namespace foam::texgen
