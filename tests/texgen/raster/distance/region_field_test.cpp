// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/region_field.h"

#include "tests/support/raster_reference.h"
#include "tests/support/sample_foams.h"
#include "tests/support/simd_levels.h"
#include "texgen/raster/distance/patch_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {
namespace {

// Measures region k of a patch in all rows of the image. Expects that each pixel of the mask is in
// exactly one batch, and that its distance is that of the nearest of all films. Returns the number
// of batches.
int expect_nearest(const Frame& frame, const RasterGrid& grid, std::size_t k) {
    const std::vector<Region> regions = patch_regions(frame, grid, 1);
    const test::NearestFilms films(frame, *grid.view, grid.width, grid.height);
    RegionPixels pixels;
    pixels.rasterize(regions[k], {}, {0, grid.height});
    const PixelBox& box = pixels.box();
    std::size_t expected = 0;
    for (int row = 0; row < box.rows(); ++row) {
        pixels.mask().for_each_span(
            row, [&](int, int count) { expected += static_cast<std::size_t>(count); });
    }
    Image<int> seen(box.columns(), box.rows(), 1);
    std::size_t measured = 0;
    int batches = 0;
    RegionField field;
    field.measure(regions[k], pixels, {.gradient = true}, [&](const PixelBatch& batch) {
        ++batches;
        for (const PixelBatch::Span& span : batch.spans()) {
            for (std::uint32_t i = 0; i < span.count; ++i) {
                const int column = span.column + static_cast<int>(i);
                ++measured;
                EXPECT_EQ(seen.pixel(column, span.row)[0]++, 0);
                const Vec2 center(box.left + column + 0.5, box.bottom + span.row + 0.5);
                const double nearest = films.at(center).distance;
                EXPECT_NEAR(batch.distance()[span.first + i], nearest, 1e-6 * (8.0 + nearest));
            }
        }
    });
    EXPECT_EQ(measured, expected);
    return batches;
}

// A bubble of the ring is measured in one batch, or in tiles if it is large. Its wide outer side is
// halved.
TEST(RegionField, MeasuresABubbleAtOnceOrByTiles) {
    const Frame ring = snapshot(test::ring_foam(), 1);
    at_every_simd_level([&] {
        EXPECT_EQ(expect_nearest(ring, {40, 40, 0, 0, View{{0.0, 0.0}, 8.0}}, 1), 1);
        EXPECT_GT(expect_nearest(ring, {100, 100, 0, 0, View{{0.0, 0.0}, 22.0}}, 1), 4);
    });
}

// The surroundings have a hole, corners of more than 180 degrees, and more sides than a batch
// needs.
TEST(RegionField, FindsTheNearestOfManySides) {
    const Frame ring = snapshot(test::ring_foam(), 1);
    const Frame disc = snapshot(test::patch_foam(120, 3), 1);
    at_every_simd_level([&] {
        expect_nearest(ring, {90, 90, 0, 0, View{{0.0, 0.0}, 16.0}}, 0);
        expect_nearest(disc, {150, 130, 0, 0, View{{0.0, 0.0}, 9.0}}, 0);
        expect_nearest(disc, {70, 60, 0, 0, View{{5.0, 5.0}, 9.0}}, 0);
    });
}

}  // namespace
}  // namespace foam::texgen
