// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/arc_bands.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 100;

MonotoneArc arc_in_rows(std::int32_t x, std::int32_t first, std::int32_t last) {
    return {{x * kSubpixel, first * kSubpixel}, {x * kSubpixel, last * kSubpixel}, 0.0, {}};
}

CellArcs cells_of(const std::vector<MonotoneArc>& arcs, const RasterGrid& grid) {
    CellArcs cells;
    cells.grid = grid;
    cells.batches = {arcs};
    return cells;
}

TEST(ArcBands, HaveRowsInPowersOfTwo) {
    const ArcBands bands(cells_of({}, {kWidth, kHeight}), 20, 1);
    EXPECT_EQ(bands.count(), 4);
    EXPECT_EQ(bands.first_row(3), 96);
    EXPECT_EQ(bands.row_count(2), 32);
    EXPECT_EQ(bands.row_count(3), 4);
}

TEST(ArcBands, HoldTheArcsThatReachIntoThem) {
    const ArcBands bands(
        cells_of({arc_in_rows(5, 3, 40), arc_in_rows(5, 32, 64)}, {kWidth, kHeight}), 32, 1);
    EXPECT_EQ(bands.entries(0).size(), 1U);
    EXPECT_EQ(bands.entries(1).size(), 2U);
    EXPECT_EQ(bands.entries(2).size(), 0U);  // the second arc ends at the lower border of this band
}

TEST(ArcBands, SortArcsByTilesFromLeftToRight) {
    const CellArcs cells =
        cells_of({arc_in_rows(150, 0, 9), arc_in_rows(70, 0, 9), arc_in_rows(-195, 0, 9)},
                 {kWidth, kHeight});
    const ArcBands bands(cells, 64, 1);
    std::vector<std::int32_t> columns;
    for (const ArcBands::Entry& entry : bands.entries(0)) {
        columns.push_back(pixel_of(entry.arc->low.x));
    }
    EXPECT_EQ(columns, (std::vector<std::int32_t>{-195, 70, 150}));  // -195 is wrapped to 5
}

// An arc across the upper border of the torus has a copy at the lower border, displaced by the
// shear.
TEST(ArcBands, WrapAroundTheTorus) {
    CellArcs cells = cells_of({arc_in_rows(5, 90, 110)}, {kWidth, kHeight, 3, 0});
    cells.shear = 77;
    const ArcBands bands(cells, 64, 1);
    ASSERT_EQ(bands.entries(0).size(), 1U);
    ASSERT_EQ(bands.entries(1).size(), 1U);
    const SubpixelPoint shift = shift_of(cells.grid);
    EXPECT_EQ(bands.entries(1)[0].translation, shift);
    EXPECT_EQ(bands.entries(0)[0].translation, shift - (SubpixelPoint{77, kHeight * kSubpixel}));
}

TEST(ArcBands, AreTheSameForAnyThreads) {
    CellArcs cells = cells_of({}, {kWidth, kHeight});
    for (int k = 0; k < 40; ++k) {
        cells.batches.push_back({arc_in_rows(k * 5 % kWidth, k, k + 30)});
    }
    const ArcBands one(cells, 16, 1);
    const ArcBands three(cells, 16, 3);
    for (int band = 0; band < one.count(); ++band) {
        const auto same = [](const ArcBands::Entry& a, const ArcBands::Entry& b) {
            return a.arc == b.arc && a.translation == b.translation;
        };
        EXPECT_TRUE(std::ranges::equal(one.entries(band), three.entries(band), same));
    }
}

}  // namespace
}  // namespace foam::texgen
