// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_strokes.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/albedo_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

namespace foam::texgen {
namespace {

// The width of a stroke is given in diameters of a mean bubble, whose area is 1. A horizontal
// stroke of length 2 covers 2 x width plus a disk at its ends.
TEST(StrokesAlong, HaveTheGivenWidth) {
    constexpr int kSide = 128;
    const Frame frame = foam::test::fitted_frame(honeycomb(4, 4), kSide, kSide);
    const FoamRecord record;
    const FrameLayers layers({frame, record}, {kSide, kSide}, 1);
    const double scale = pixels_per_unit(layers.grid(), frame.domain);
    const std::vector<PlacedArc> line = {{{1.0, 1.0}, {{2.0 * scale, 0.0}, 1.0, 0.0}}};
    const double diameter = 2.0 / std::sqrt(std::numbers::pi);
    for (const double width : {0.1, 0.4}) {
        const Image<float> image = strokes_along(layers, line, width / diameter);
        const double covered =
            std::accumulate(image.samples().begin(), image.samples().end(), 0.0) / (scale * scale);
        EXPECT_NEAR(covered, 2.0 * width + 0.25 * std::numbers::pi * width * width, 0.01) << width;
    }
}

Image<float> even_layer(int side, float part) {
    Image<float> image(side, side, 1);
    std::ranges::fill(image.samples(), part);
    return image;
}

// On a torus a later layer covers the earlier ones, and colors are mixed as linear light.
TEST(PaintLayers, LaterLayersCoverEarlierOnes) {
    const test::MapSubject& torus = test::torus_subject();
    FrameLayers layers(torus.input(), test::torus_grid(8), 1);
    const std::array over = {PaintLayer{"#ffffff", even_layer(8, 1.0F)},
                             PaintLayer{"#ff0000", even_layer(8, 0.25F)}};
    const ColorPixels painted = paint_layers(layers, "#000000", over);
    ASSERT_EQ(painted.pixels.channels(), 3);
    const auto pixel = painted.pixels.pixel(3, 5);
    EXPECT_EQ(pixel[0], to_sample(1.0));
    EXPECT_EQ(pixel[1], to_sample(0.75));
    EXPECT_EQ(pixel[2], to_sample(0.75));
}

// Around a patch, pixels have the opacity and the color of the layers alone.
TEST(PaintLayers, AroundAPatchOnlyLayersAreVisible) {
    const test::MapSubject& patch = test::patch_subject();
    FrameLayers layers(patch.input(), test::patch_grid(32), 1);
    const std::array over = {PaintLayer{"#ff0000", even_layer(32, 0.5F)}};
    const ColorPixels painted = paint_layers(layers, "#0000ff", over);
    ASSERT_EQ(painted.pixels.channels(), kChannelsWithOpacity);
    const auto corner = painted.pixels.pixel(0, 0);
    EXPECT_EQ(corner[0], to_sample(1.0));
    EXPECT_EQ(corner[2], 0);
    EXPECT_EQ(corner[3], to_sample(0.5));
}

}  // namespace
}  // namespace foam::texgen
