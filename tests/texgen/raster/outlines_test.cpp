#include "texgen/raster/outlines.h"

#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <limits>

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

TEST(Outlines, TileTheTorusExactly) {
    const RasterGrid grid{96, 64, 0, 0};
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Frame frame = test::fitted_frame(test::bent_foam(25, 0.5, seed), 96, 64);
        const CellOutlines cells = outline_cells(frame, grid, 1);
        EXPECT_EQ(cells.outlines.size(), 25U);
        EXPECT_EQ(total_area(cells), 96.0 * 64.0);
    }
}

TEST(Outlines, OfEachBubbleHaveItsArea) {
    const Frame frame = test::fitted_frame(test::bent_foam(25, 0.5, 1), 96, 64);
    const double scale = 96.0 / frame.domain.width;
    const CellOutlines cells = outline_cells(frame, {96, 64, 0, 0}, 1);
    for (const Outline& outline : cells.outlines) {
        const double area = frame.bubbles[outline.bubble].area * scale * scale;
        EXPECT_NEAR(area_in_pixels(cells.chain(outline)), area, 0.02);
    }
}

TEST(Outlines, DoNotDependOnThreads) {
    const Frame frame = test::fitted_frame(test::bent_foam(700, 0.3, 4), 256, 256);
    const CellOutlines one = outline_cells(frame, {256, 256, 0, 0}, 1);
    const CellOutlines three = outline_cells(frame, {256, 256, 0, 0}, 3);
    EXPECT_EQ(one.batches, three.batches);
    EXPECT_GT(one.batches.size(), 1U);
}

TEST(Outlines, KnowTheirRange) {
    const Frame frame = test::fitted_frame(test::bent_foam(30, 0.3, 5), 64, 64);
    const CellOutlines cells = outline_cells(frame, {64, 64, 0, 0}, 1);
    for (const Outline& outline : cells.outlines) {
        constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
        constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
        SubpixelPoint low{kMost, kMost};
        SubpixelPoint high{kLeast, kLeast};
        for (const SubpixelPoint point : cells.chain(outline)) {
            low = {std::min(low.x, point.x), std::min(low.y, point.y)};
            high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        }
        EXPECT_EQ(outline.lowest, low);
        EXPECT_EQ(outline.highest, high);
    }
}

}  // namespace
}  // namespace foam::texgen
