// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coords/raster_grid.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace foam::texgen {
namespace {

TEST(RasterGrid, CountsPixelsPerFoamUnit) {
    EXPECT_DOUBLE_EQ(pixels_per_unit({256, 128, 0, 0}, {8.0, 4.0}), 32.0);
}

TEST(RasterGrid, RejectsPixelsThatAreNotSquare) {
    EXPECT_NO_THROW(pixels_per_unit({100, 100, 0, 0}, {1.0, 1.0 + 0.9e-6}));
    EXPECT_THROW(pixels_per_unit({100, 100, 0, 0}, {1.0, 1.0 + 1.2e-6}), std::invalid_argument);
}

TEST(RasterGrid, RejectsSidesOutOfRange) {
    EXPECT_THROW(pixels_per_unit({0, 0, 0, 0}, {1.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(pixels_per_unit({kMaxGridSide + 1, kMaxGridSide + 1, 0, 0}, {1.0, 1.0}),
                 std::invalid_argument);
    EXPECT_NO_THROW(pixels_per_unit({kMaxGridSide, kMaxGridSide, 0, 0}, {1.0, 1.0}));
}

TEST(RasterGrid, HasAViewOnlyOfThePlane) {
    EXPECT_THROW(pixels_per_unit({10, 10, 0, 0}, kPlane), std::invalid_argument);
    const View view{{1.0, 2.0}, 7.5};
    EXPECT_EQ(pixels_per_unit({10, 20, 0, 0, view}, kPlane), 7.5);
    EXPECT_THROW(pixels_per_unit({10, 10, 0, 0, view}, {1.0, 1.0}), std::invalid_argument);
}

TEST(RasterGrid, SnapsIntoTheGrid) {
    const Snap snap({10, 20, 3, 4}, {1.0, 2.0});
    EXPECT_EQ(snap({0.25, 1.5}), (SubpixelPoint{2560, 15360}));
    // The nearest subpixel to a position just below the upper border is the border.
    EXPECT_EQ(snap({0.0, 2.0 - 1e-9}), (SubpixelPoint{0, 20480}));
}

// The shear is half a period of 10 pixels to the left, with 1024 subpixels per pixel.
TEST(RasterGrid, ReturnsTheShear) {
    EXPECT_EQ(shear_in_subpixels({10, 20, 0, 0}, {1.0, 2.0, -0.5}), -5120);
    EXPECT_EQ(shear_in_subpixels({10, 20, 0, 0}, {1.0, 2.0}), 0);
}

}  // namespace
}  // namespace foam::texgen
