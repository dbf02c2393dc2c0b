#include "texgen/raster/outlines.h"

#include "core/foam/honeycomb.h"
#include "tests/support/raster_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace foam::texgen {
namespace {

double area_in_pixels(std::span<const SubpixelPoint> chain) {
    double twice = 0.0;
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const SubpixelPoint a = chain[k];
        const SubpixelPoint b = chain[(k + 1) % chain.size()];
        twice += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
    }
    return 0.5 * twice / (static_cast<double>(kSubpixel) * kSubpixel);
}

double total_area(const CellOutlines& cells) {
    double total = 0.0;
    for (const Outline& outline : cells.outlines) {
        total += area_in_pixels(cells.chain(outline));
    }
    return total;
}

TEST(Outlines, WithoutWidthTileTheTorusExactly) {
    const RasterGrid grid{96, 64, 0, 0};
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Frame frame = test::fitted_frame(test::bent_foam(25, 0.5, seed), 96, 64);
        const CellOutlines cells = outline_cells(frame, grid, 0.0, 1);
        EXPECT_EQ(cells.outlines.size(), 25U);
        EXPECT_EQ(total_area(cells), 96.0 * 64.0);
    }
}

TEST(Outlines, OfEachBubbleHaveItsArea) {
    const Frame frame = test::fitted_frame(test::bent_foam(25, 0.5, 1), 96, 64);
    const double scale = 96.0 / frame.torus.width;
    const CellOutlines cells = outline_cells(frame, {96, 64, 0, 0}, 0.0, 1);
    for (const Outline& outline : cells.outlines) {
        const double area = frame.bubbles[outline.bubble].area * scale * scale;
        EXPECT_NEAR(area_in_pixels(cells.chain(outline)), area, 0.02);
    }
}

TEST(Outlines, LeaveAStripOfHalfTheWidthFree) {
    // A cell of area A and perimeter P, its corners k of angle b each, loses P h - k h² cot(b / 2)
    // at distance h while all its films show; a hexagon loses P h - 6 h² / sqrt(3). The grid's
    // aspect is that of the honeycomb to 1e-6, as 4 / (2 sqrt(3)) = 1351 / 1170 nearly: sqrt(3)
    // = 1.7320508.
    Foam foam = honeycomb(4, 4);
    const Frame frame = test::fitted_frame(foam, 1351, 1170);
    const double scale = 1351.0 / frame.torus.width;
    const CellOutlines cells = outline_cells(frame, {1351, 1170, 0, 0}, 8.0, 1);
    ASSERT_EQ(cells.outlines.size(), 16U);
    const double side = std::sqrt(2.0 / (3.0 * std::sqrt(3.0))) * scale;  // of area 1
    const double h = 4.0;
    const double expected = scale * scale - 6.0 * side * h + 6.0 * h * h / std::sqrt(3.0);
    for (const Outline& outline : cells.outlines) {
        EXPECT_NEAR(area_in_pixels(cells.chain(outline)), expected, 1.0);  // of 1e5
    }
}

TEST(Outlines, DoNotDependOnThreads) {
    const Frame frame = test::fitted_frame(test::bent_foam(700, 0.3, 4), 256, 256);
    for (const double width : {0.0, 2.0}) {
        const CellOutlines one = outline_cells(frame, {256, 256, 0, 0}, width, 1);
        const CellOutlines three = outline_cells(frame, {256, 256, 0, 0}, width, 3);
        EXPECT_EQ(one.batches, three.batches);
        EXPECT_GT(one.batches.size(), 1U);
    }
}

TEST(Outlines, KnowTheirRange) {
    const Frame frame = test::fitted_frame(test::bent_foam(30, 0.3, 5), 64, 64);
    const CellOutlines cells = outline_cells(frame, {64, 64, 0, 0}, 1.0, 1);
    for (const Outline& outline : cells.outlines) {
        std::int32_t low = std::numeric_limits<std::int32_t>::max();
        std::int32_t high = std::numeric_limits<std::int32_t>::min();
        for (const SubpixelPoint point : cells.chain(outline)) {
            low = std::min(low, point.y);
            high = std::max(high, point.y);
        }
        EXPECT_EQ(outline.lowest, low);
        EXPECT_EQ(outline.highest, high);
    }
}

TEST(Outlines, AllCloseInEquilibrium) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Frame frame = test::fitted_frame(test::polydisperse_foam(100, seed), 128, 128);
        for (const double width : {0.01, 0.5, 2.0, 5.0, 12.0, 100.0}) {
            EXPECT_EQ(outline_cells(frame, {128, 128, 0, 0}, width, 1).unresolved, 0)
                << seed << " " << width;
        }
    }
}

TEST(Outlines, RefuseAWidthThatIsNone) {
    const Frame frame = test::fitted_frame(honeycomb(2, 2), 8, 8);
    EXPECT_THROW(outline_cells(frame, {8, 8, 0, 0}, -1.0, 1), std::invalid_argument);
    EXPECT_THROW(outline_cells(frame, {8, 8, 0, 0}, std::nan(""), 1), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
