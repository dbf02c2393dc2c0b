// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/cell_arcs.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"
#include "texgen/raster/arcs/monotone_arc.h"
#include "texgen/raster/outline/inset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace foam::texgen {
namespace {

// Returns the area within the arcs of each bubble, in square pixels.
std::map<std::uint32_t, double> areas(const CellArcs& cells) {
    std::map<std::uint32_t, std::vector<MonotoneArc>> chains;
    for (const std::vector<MonotoneArc>& batch : cells.batches) {
        for (const MonotoneArc& arc : batch) {
            chains[arc.sides.left != kFilmSide ? arc.sides.left : arc.sides.right].push_back(arc);
        }
    }
    std::map<std::uint32_t, double> found;
    for (const auto& [bubble, chain] : chains) {
        found[bubble] = 0.5 * twice_area(chain, bubble) / (double{kSubpixel} * kSubpixel);
    }
    return found;
}

TEST(CellArcs, WithoutWidthAreTheFilmsOnce) {
    // 25 bubbles have 75 films. The result contains every film, some of them in two or three
    // pieces.
    const Frame frame = test::fitted_frame(test::bent_foam(25, 0.5, 1), 96, 64);
    const CellArcs cells = cell_arcs(frame, {96, 64, 0, 0}, 0.0, 1);
    ASSERT_EQ(cells.batches.size(), 1U);
    EXPECT_GE(cells.batches[0].size(), 75U);
    EXPECT_LT(cells.batches[0].size(), 150U);
    for (const MonotoneArc& arc : cells.batches[0]) {
        EXPECT_LT(arc.low.y, arc.high.y);
        EXPECT_LT(arc.sides.left, 25U);
        EXPECT_LT(arc.sides.right, 25U);
    }
}

TEST(CellArcs, LeaveAStripOfHalfTheWidthFree) {
    // A polygon of perimeter P with k corners of angle b loses the area P h - k h² cot(b / 2) at
    // the distance h, as long as every side is visible. A hexagon loses P h - 6 h² / sqrt(3). The
    // aspect ratio of the grid is that of the honeycomb to 1e-6: 4 / (2 sqrt(3)) is nearly 1351 /
    // 1170.
    Foam foam = honeycomb(4, 4);
    const Frame frame = test::fitted_frame(foam, 1351, 1170);
    const double scale = 1351.0 / frame.domain.width;
    const CellArcs cells = cell_arcs(frame, {1351, 1170, 0, 0}, 8.0, 1);
    const double side = std::sqrt(2.0 / (3.0 * std::sqrt(3.0))) * scale;  // of a hexagon of area 1
    const double h = 4.0;
    const double expected = scale * scale - 6.0 * side * h + 6.0 * h * h / std::sqrt(3.0);
    const std::map<std::uint32_t, double> found = areas(cells);
    EXPECT_EQ(found.size(), 16U);
    for (const auto& [bubble, area] : found) {
        EXPECT_NEAR(area, expected, 1.0) << bubble;  // of 1e5 square pixels
    }
}

// Returns the area of the inset that InsetTracer finds for a bubble, in square pixels.
double area_left_free(const Frame& frame, double scale, BubbleId bubble, double inset) {
    ArcLoops outline;
    Vec2 at = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        const FilmArc arc{scale * frame.arc(h).chord, frame.arc(h).half_angle};
        outline.sides.push_back({at, pixel_arc(arc)});
        at += arc.chord;
    }
    outline.loop_ends.push_back(outline.sides.size());
    InsetTracer tracer;
    double area = 0.0;
    for (const ArcLoops& loops = tracer.trace(outline, inset);
         const ArcLoops::Side& arc : loops.sides) {
        area += 0.5 * cross(arc.tail, arc.arc.chord) + segment_area(film_arc(arc.arc));
    }
    return area;
}

// Bubbles with few sides are traced several at once. A two-sided bubble is inserted into each of
// the 6 films of one bubble, which then has 18 sides.
TEST(CellArcs, AreTheInsetsOfBubblesWithFewSidesAndMany) {
    Foam foam = honeycomb(4, 4);
    const auto crowded = id_at<BubbleId>(5);
    for (const HalfEdgeId h : foam.network.around(crowded)) {
        test::insert_lens(foam, film_of(h), 0.3);
    }
    ASSERT_EQ(foam.network.sides(crowded), 18);
    const Frame frame = test::fitted_frame(foam, 256, 222);
    const double scale = 256.0 / frame.domain.width;
    const std::map<std::uint32_t, double> found = areas(cell_arcs(frame, {256, 222, 0, 0}, 2.0, 1));
    EXPECT_EQ(found.size(), 22U);
    for (const auto& [index, area] : found) {
        const double expected = area_left_free(frame, scale, id_at<BubbleId>(index), 1.0);
        EXPECT_NEAR(area, expected, 0.2) << index;  // 200 pixels of perimeter, rounded to subpixels
    }
}

TEST(CellArcs, DoNotDependOnThreads) {
    const Frame frame = test::fitted_frame(test::bent_foam(700, 0.3, 4), 256, 256);
    for (const double width : {0.0, 2.0}) {
        const CellArcs one = cell_arcs(frame, {256, 256, 0, 0}, width, 1);
        const CellArcs three = cell_arcs(frame, {256, 256, 0, 0}, width, 3);
        EXPECT_EQ(one.batches, three.batches);
        EXPECT_GT(one.batches.size(), 1U);
    }
}

TEST(CellArcs, AllCloseInEquilibrium) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Frame frame = test::fitted_frame(test::polydisperse_foam(100, seed), 128, 128);
        for (const double width : {0.01, 0.5, 2.0, 5.0, 12.0, 100.0}) {
            EXPECT_EQ(cell_arcs(frame, {128, 128, 0, 0}, width, 1).unclosed_loops, 0)
                << seed << " " << width;
        }
    }
}

TEST(CellArcs, RejectAnInvalidWidth) {
    const Frame frame = test::fitted_frame(honeycomb(2, 2), 8, 8);
    EXPECT_THROW(cell_arcs(frame, {8, 8, 0, 0}, -1.0, 1), std::invalid_argument);
    EXPECT_THROW(cell_arcs(frame, {8, 8, 0, 0}, std::nan(""), 1), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
