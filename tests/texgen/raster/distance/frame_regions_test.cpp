#include "texgen/raster/distance/frame_regions.h"

#include "core/dynamics/shear.h"
#include "tests/support/sample_foams.h"
#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kBandRows = 16;

// Every copy whose box shares rows with a band is in the band, and no other; copies of a bubble are
// a period apart, and one of them is within the columns.
TEST(FrameRegions, PutCopiesIntoTheBandsThatTheyReach) {
    Foam foam = test::bent_foam(40, 0.4, 3);
    shear(foam, 0.3);
    const Frame frame = test::fitted_frame(foam, 75, 140);
    const RasterGrid grid{75, 140, 33, 70};
    const FrameRegions regions(frame, grid, 1);
    const Buckets<RegionCopy> bands = regions.copies_by_band(kBandRows, 1);
    std::set<std::tuple<std::uint32_t, int, int>> copies;
    for (const RegionCopy& copy : bands.items) {
        copies.insert({copy.region, copy.translation.x, copy.translation.y});
        const int first = regions.regions()[copy.region].first.x + copy.translation.x;
        EXPECT_GE(first, 0);
        EXPECT_LT(first, grid.width * kSubpixel);
    }
    EXPECT_GT(copies.size(), regions.regions().size());
    for (const auto& [region, x, y] : copies) {
        const PixelBox box = box_around(regions.regions()[region], {x, y});
        for (int band = 0; band * kBandRows < grid.height; ++band) {
            const auto k = static_cast<std::size_t>(band);
            std::size_t found = 0;
            for (const RegionCopy& copy : bands.of(k, k + 1)) {
                found += std::tuple(copy.region, copy.translation.x, copy.translation.y) ==
                                 std::tuple(region, x, y)
                             ? 1U
                             : 0U;
            }
            const bool reaches = box.bottom < (band + 1) * kBandRows && box.top > band * kBandRows;
            EXPECT_EQ(found, reaches ? 1U : 0U);
        }
    }
}

TEST(FrameRegions, AreTheSameForAnyThreads) {
    const Frame frame = test::fitted_frame(test::bent_foam(9000, 0.3, 3), 300, 300);
    const FrameRegions one(frame, {300, 300}, 1);
    const FrameRegions three(frame, {300, 300}, 3);
    const Buckets<RegionCopy> expected = one.copies_by_band(64, 1);
    const Buckets<RegionCopy> found = three.copies_by_band(64, 3);
    EXPECT_EQ(found.ends, expected.ends);
    ASSERT_EQ(found.items.size(), expected.items.size());
    for (std::size_t k = 0; k < found.items.size(); ++k) {
        EXPECT_EQ(found.items[k].region, expected.items[k].region);
        EXPECT_EQ(found.items[k].translation, expected.items[k].translation);
    }
}

TEST(FrameRegions, OfAPatchHaveOneCopyEach) {
    const Frame frame = snapshot(test::patch_foam(20, 3), 1);
    const RasterGrid grid{60, 60, 0, 0, View{{0.0, 0.0}, 8.0}};
    const FrameRegions regions(frame, grid, 1);
    const Buckets<RegionCopy> copies = regions.copies_by_band(60, 1);
    ASSERT_EQ(copies.items.size(), regions.regions().size());
    for (std::size_t k = 0; k < copies.items.size(); ++k) {
        EXPECT_EQ(copies.items[k].region, k);
        EXPECT_EQ(copies.items[k].translation, SubpixelPoint{});
    }
}

TEST(FrameRegions, RejectAnImageOfAnotherAspect) {
    const Frame frame = test::fitted_frame(test::bent_foam(9, 0.1, 1), 8, 8);
    EXPECT_THROW(FrameRegions(frame, RasterGrid{9, 8}, 1), std::invalid_argument);
}

// The regions that hold each pixel, of all copies in bands of some rows.
std::vector<int> owners_of(const Frame& frame, const RasterGrid& grid, int band_rows) {
    const FrameRegions regions(frame, grid, 1);
    const Buckets<RegionCopy> bands = regions.copies_by_band(band_rows, 1);
    std::vector<int> owners(static_cast<std::size_t>(grid.width * grid.height), -1);
    RegionPixels pixels;
    for (std::size_t band = 0; band + 1 < bands.ends.size(); ++band) {
        const int begin = static_cast<int>(band) * band_rows;
        const PixelRows rows{begin, std::min(begin + band_rows, grid.height)};
        for (const RegionCopy& copy : bands.of(band, band + 1)) {
            pixels.place(regions, copy, rows);
            const PixelMask& mask = pixels.mask();
            for (int row = mask.rows().begin; row < mask.rows().end; ++row) {
                const int y = pixels.box().bottom + row;
                EXPECT_GE(y, rows.begin);
                EXPECT_LT(y, rows.end);
                mask.for_each_span(row, [&](int column, int count) {
                    for (int k = 0; k < count; ++k) {
                        const int x = wrap(pixels.box().left + column + k, grid.width);
                        int& owner = owners[static_cast<std::size_t>(y * grid.width + x)];
                        EXPECT_EQ(owner, -1) << x << ", " << y;
                        owner = static_cast<int>(pixels.region().id);
                    }
                });
            }
        }
    }
    return owners;
}

void expect_tiling(const Frame& frame, const RasterGrid& grid) {
    at_every_simd_level([&] {
        const std::vector<int> owners = owners_of(frame, grid, grid.height);
        EXPECT_EQ(std::count(owners.begin(), owners.end(), -1), 0);
        EXPECT_EQ(owners_of(frame, grid, 8), owners);
    });
}

// Each pixel belongs to exactly one region, whatever the bands.
TEST(RegionPixels, TileTheTorus) {
    Foam foam = test::bent_foam(30, 0.5, 3);
    shear(foam, 0.3);
    expect_tiling(test::fitted_frame(foam, 75, 140), {75, 140, 33, 70});
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
    expect_tiling(circles, {200, 120, 0, 0, View{{0.0, 0.0}, 20.0}});
}

}  // namespace
}  // namespace foam::texgen
