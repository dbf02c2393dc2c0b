// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coords/pixel_frame.h"

#include "core/dynamics/shear.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

constexpr int kSide = 200;  // pixels

TEST(PixelFrame, RoundsJunctionsToTheNearestSubpixel) {
    const Frame frame = test::fitted_frame(test::bent_foam(40, 0.3, 2), kSide, kSide);
    const RasterGrid grid{kSide, kSide};
    const PixelFrame pixels(frame, grid);
    for (std::size_t k = 0; k < frame.positions.size(); ++k) {
        const auto junction = id_at<JunctionId>(k);
        const SubpixelPoint rounded_position = pixels.rounded_position(junction);
        const Vec2 exact = pixels.exact_position(junction);
        EXPECT_LE(std::abs(rounded_position.x - kSubpixel * exact.x()), 0.5 + 1e-9);
        EXPECT_LE(std::abs(rounded_position.y - kSubpixel * exact.y()), 0.5 + 1e-9);
    }
}

// The period to the right is the width of the grid. The period upward is the height of the grid and
// the shear.
TEST(PixelFrame, TranslatesByPeriods) {
    Foam foam = test::bent_foam(40, 0.3, 2);
    shear(foam, 0.25);
    const Frame frame = test::fitted_frame(foam, kSide, kSide);
    const RasterGrid grid{kSide, kSide};
    const PixelFrame pixels(frame, grid);
    EXPECT_NE(pixels.shear, 0);
    EXPECT_EQ(pixels.translation({1, 0}), (SubpixelPoint{kSide * kSubpixel, 0}));
    EXPECT_EQ(pixels.translation({0, -1}), (SubpixelPoint{-pixels.shear, -kSide * kSubpixel}));
}

}  // namespace
}  // namespace foam::texgen
