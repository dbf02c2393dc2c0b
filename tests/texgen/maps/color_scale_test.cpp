// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/color_scale.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ColorScale, BlendsInSrgb) {
    const std::vector<LinearRgb> colors = parse_colors({"#000000", "#ff8000", "#ffffff"});
    EXPECT_EQ(to_srgb8(blended(colors, 0.0)), (Srgb8{0, 0, 0}));
    EXPECT_EQ(to_srgb8(blended(colors, 0.2)), (Srgb8{102, 51, 0}));
    EXPECT_EQ(to_srgb8(blended(colors, 0.5)), (Srgb8{255, 128, 0}));
    EXPECT_EQ(to_srgb8(blended(colors, 2.0)), (Srgb8{255, 255, 255}));
    EXPECT_EQ(to_srgb8(blended(colors, -1.0)), (Srgb8{0, 0, 0}));
}

TEST(ColorScale, PicksOneOfTheColors) {
    const std::vector<LinearRgb> colors = parse_colors({"#102030", "#405060"});
    EXPECT_EQ(to_srgb8(picked(colors, 0.49)), (Srgb8{16, 32, 48}));
    EXPECT_EQ(to_srgb8(picked(colors, 0.51)), (Srgb8{64, 80, 96}));
    EXPECT_EQ(to_srgb8(picked(colors, 1.0)), (Srgb8{64, 80, 96}));
}

TEST(ColorScale, AnInvalidColorIsRejected) {
    EXPECT_THROW(parse_colors({"#12345"}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
