// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/opacity.h"

#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/map_subjects.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The film of 3 pixels ends at 21.5 pixels from the middle.
TEST(Opacity, HasTheAreaOfADisc) {
    LoneCircle circle(20.0);
    const NumberPixels opacity = draw_opacity(circle.layers, test::films_of(3.0));
    EXPECT_NEAR(test::sum_of(opacity.pixels), 21.5 * 21.5 * std::numbers::pi, 0.1);
    EXPECT_EQ(opacity.pixels.pixel(32, 32)[0], 1.0F);
    EXPECT_EQ(opacity.pixels.pixel(0, 0)[0], 0.0F);
}

TEST(Opacity, IsTheAlphaOfAlbedo) {
    FrameLayers layers(test::patch_subject().input(), test::patch_grid(96), 1);
    const ColorPixels albedo = draw_albedo(layers, test::films_of(2.0));
    const NumberPixels opacity = draw_opacity(layers, test::films_of(2.0));
    for (std::size_t k = 0; k < opacity.pixels.samples().size(); ++k) {
        ASSERT_EQ(opacity.pixels.samples()[k],
                  static_cast<float>(albedo.pixels.samples()[4 * k + 3] / 65535.0));
    }
}

}  // namespace
}  // namespace foam::texgen
