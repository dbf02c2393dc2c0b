// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/frame_regions.h"

#include "core/dynamics/shear.h"
#include "tests/support/sample_foams.h"
#include "tests/support/simd_levels.h"
#include "texgen/image/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace foam::texgen {
namespace {

// A copy of a region: its id and its translation in subpixels.
using Copy = std::tuple<std::uint32_t, int, int>;

// Returns the copies that are painted in each row, in the order in which they are painted.
std::vector<std::vector<Copy>> painted_rows(const Frame& frame,
                                            const RasterGrid& grid,
                                            int workers) {
    std::vector<std::vector<Copy>> painted(static_cast<std::size_t>(grid.height));
    const auto paint = [&](int worker, const Region& region, SubpixelPoint by, PixelRows rows) {
        EXPECT_LT(worker, workers);
        const PixelBox box = box_around(region, by);
        for (int row = std::max(box.bottom, rows.begin); row < std::min(box.top, rows.end); ++row) {
            painted[static_cast<std::size_t>(row)].emplace_back(region.id, by.x, by.y);
        }
    };
    paint_regions(frame, grid, workers, paint);
    return painted;
}

// Each copy is painted once in each row of its box. Copies of a bubble are a period apart. Only the
// copies that begin within the columns of the grid are painted.
TEST(FrameRegions, PaintEachCopyOnceInItsRows) {
    Foam foam = test::bent_foam(40, 0.4, 3);
    shear(foam, 0.3);
    const Frame frame = test::fitted_frame(foam, 150, 280);
    const RasterGrid grid{150, 280, 66, 140};
    std::map<Copy, int> rows;
    const auto count_rows = [&](int, const Region& region, SubpixelPoint by, PixelRows in) {
        const PixelBox box = box_around(region, by);
        EXPECT_GE(region.first.x + by.x, 0);
        EXPECT_LT(region.first.x + by.x, grid.width * kSubpixel);
        const int shown = std::min(box.top, grid.height) - std::max(box.bottom, 0);
        int& left = rows.try_emplace(Copy(region.id, by.x, by.y), shown).first->second;
        left -= std::min(box.top, in.end) - std::max(box.bottom, in.begin);
    };
    paint_regions(frame, grid, 1, count_rows);
    EXPECT_GT(rows.size(), 40U);
    for (const auto& [copy, left] : rows) {
        EXPECT_EQ(left, 0);
    }
    for (const std::vector<Copy>& of_row : painted_rows(frame, grid, 1)) {
        EXPECT_EQ(std::set<Copy>(of_row.begin(), of_row.end()).size(), of_row.size());
    }
}

TEST(FrameRegions, ArePaintedInTheSameOrderByAnyThreads) {
    const Frame frame = test::fitted_frame(test::bent_foam(9000, 0.3, 3), 300, 300);
    const RasterGrid grid{300, 300, 10, 70};
    EXPECT_EQ(painted_rows(frame, grid, 3), painted_rows(frame, grid, 1));
}

TEST(FrameRegions, OfAPatchArePaintedInTheirOrder) {
    const Frame frame = snapshot(test::patch_foam(20, 3), 1);
    const RasterGrid grid{400, 400, 0, 0, View{{0.0, 0.0}, 52.0}};
    const auto ghost = static_cast<std::uint32_t>(index_of(frame.network.ghost()));
    for (const std::vector<Copy>& of_row : painted_rows(frame, grid, 2)) {
        ASSERT_FALSE(of_row.empty());
        EXPECT_EQ(of_row.front(), Copy(ghost, 0, 0));
        EXPECT_TRUE(std::is_sorted(of_row.begin() + 1, of_row.end()));
    }
}

TEST(FrameRegions, RejectAnImageOfAnotherAspect) {
    const Frame frame = test::fitted_frame(test::bent_foam(9, 0.1, 1), 8, 8);
    EXPECT_THROW(painted_rows(frame, RasterGrid{9, 8}, 1), std::invalid_argument);
}

// Adds 1 to `times` for each pixel of a region. Expects that all pixels are in the rows.
void count_pixels(const RegionPixels& pixels, PixelRows rows, Image<int>& times) {
    const PixelMask& mask = pixels.mask();
    for (int row = mask.rows().begin; row < mask.rows().end; ++row) {
        const int y = pixels.box().bottom + row;
        EXPECT_GE(y, rows.begin);
        EXPECT_LT(y, rows.end);
        mask.for_each_span(row, [&](int column, int count) {
            for (int k = 0; k < count; ++k) {
                ++times.pixel(wrap(pixels.box().left + column + k, times.width()), y)[0];
            }
        });
    }
}

// Expects that each pixel of an image belongs to exactly one region.
void expect_tiling(const Frame& frame, const RasterGrid& grid) {
    at_every_simd_level([&] {
        Image<int> times(grid.width, grid.height, 1);
        RegionPixels pixels;
        const auto paint = [&](int, const Region& region, SubpixelPoint by, PixelRows rows) {
            pixels.rasterize(region, by, rows);
            count_pixels(pixels, rows, times);
        };
        paint_regions(frame, grid, 1, paint);
        EXPECT_EQ(std::ranges::count(times.samples(), 1), grid.width * grid.height);
    });
}

TEST(RegionPixels, TileTheTorus) {
    Foam foam = test::bent_foam(30, 0.5, 3);
    shear(foam, 0.3);
    expect_tiling(test::fitted_frame(foam, 150, 280), {150, 280, 33, 170});
    expect_tiling(test::fitted_frame(foam, 300, 560), {300, 560, 33, 400});
    expect_tiling(test::fitted_frame(test::single_bubble(), 90, 90), {90, 90, 5, 7});
    expect_tiling(test::fitted_frame(test::bent_foam(600, 0.3, 5), 20, 20), {20, 20});
}

TEST(RegionPixels, TileThePlane) {
    const Frame disc = snapshot(test::patch_foam(30, 3), 1);
    expect_tiling(disc, {90, 70, 0, 0, View{{0.0, 0.0}, 10.0}});
    expect_tiling(disc, {64, 64, 0, 0, View{{1.7, -0.6}, 1e6}});
    const Frame ring = snapshot(test::ring_foam(), 1);
    expect_tiling(ring, {90, 90, 0, 0, View{{0.1, 0.0}, 16.0}});
    const Frame circles = snapshot(test::circles({{0, {-2.0, 0.1}, 4.0}, {1, {1.5, 0.3}, 4.0}}), 1);
    expect_tiling(circles, {500, 300, 0, 0, View{{0.0, 0.0}, 50.0}});
}

}  // namespace
}  // namespace foam::texgen
