// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/colormap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

double luminance(const LinearRgb& color) {
    return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

double lightness(const ColorMap& map, int i) {
    return std::cbrt(luminance(map.at(i / 255.0)));
}

// The expected colors are from Matplotlib's documentation: viridis(0.0), viridis(1.0) and so on.
TEST(ColorMap, HasTheKnownEntries) {
    EXPECT_EQ(find_colormap("viridis").entry(0), (Srgb8{0x44, 0x01, 0x54}));
    EXPECT_EQ(find_colormap("viridis").entry(128), (Srgb8{0x21, 0x91, 0x8c}));
    EXPECT_EQ(find_colormap("viridis").entry(255), (Srgb8{0xfd, 0xe7, 0x25}));
    EXPECT_EQ(find_colormap("magma").entry(255), (Srgb8{0xfc, 0xfd, 0xbf}));
    EXPECT_EQ(find_colormap("inferno").entry(255), (Srgb8{0xfc, 0xff, 0xa4}));
    EXPECT_EQ(find_colormap("plasma").entry(0), (Srgb8{0x0d, 0x08, 0x87}));
    EXPECT_EQ(find_colormap("cividis").entry(0), (Srgb8{0x00, 0x22, 0x4e}));
    EXPECT_EQ(find_colormap("grey").entry(77), (Srgb8{77, 77, 77}));
}

// Compares entries whose indices differ by 4, because rounding to 8 bits can reverse the order of
// adjacent entries.
TEST(ColorMap, LightnessIsMonotone) {
    for (const std::string_view name : colormap_names()) {
        const ColorMap& map = find_colormap(name);
        const bool darkens = name == "labyrinth_blue";
        for (int i = 4; i < 256; ++i) {
            const double step = lightness(map, i) - lightness(map, i - 4);
            EXPECT_GT(darkens ? -step : step, 0.0) << name << " at " << i;
        }
    }
}

TEST(ColorMap, LabyrinthBlueRunsFromNearWhiteToNavyAndStaysBlue) {
    const ColorMap& map = find_colormap("labyrinth_blue");
    EXPECT_GT(luminance(map.at(0.0)), 0.9);
    EXPECT_LT(luminance(map.at(1.0)), 0.02);
    for (int i = 0; i < 256; ++i) {
        const Srgb8 color = map.entry(i);
        EXPECT_TRUE(color.b > color.g && color.g > color.r) << i;
    }
}

TEST(ColorMap, HitsEntriesAndMixesBetweenThemInSrgb) {
    const ColorMap& gray = find_colormap("grey");
    EXPECT_EQ(to_srgb8(gray.at(51.0 / 255.0)), (Srgb8{51, 51, 51}));
    // Halfway between codes 100 and 101.
    EXPECT_NEAR(gray.at(100.5 / 255.0).g, srgb_to_linear(100.5 / 255.0), 1e-12);
}

TEST(ColorMap, ClampsItsArgument) {
    const ColorMap& map = find_colormap("viridis");
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(map.at(-inf), map.at(0.0));
    EXPECT_EQ(map.at(inf), map.at(1.0));
    EXPECT_EQ(map.at(std::nan("")), map.at(0.0));
    EXPECT_EQ(to_srgb8(map.at(1.0)), map.entry(255));
}

TEST(ColorMap, AnUnknownNameListsTheKnown) {
    try {
        find_colormap("jet");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "colormap 'jet': must be one of viridis, magma, inferno, plasma, cividis, "
                     "grey, labyrinth_blue, sea_water");
    }
}

}  // namespace
}  // namespace foam::texgen
