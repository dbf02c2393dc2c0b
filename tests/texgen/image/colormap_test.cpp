// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/colormap.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

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

// The expected colors are colormap(k / 255) of Matplotlib 3.6, rounded to 8 bits, for k = 0, 50,
// 128, 200 and 255.
TEST(ColorMap, AgreesWithMatplotlib) {
    struct Expected {
        const char* name;
        std::array<std::uint32_t, 5> colors;
    };
    const std::vector<Expected> maps = {
        {"turbo", {0x30123b, 0x4099ff, 0xa4fc3c, 0xf46617, 0x7a0403}},
        {"twilight", {0xe2d9e2, 0x6e92c0, 0x301437, 0xbc6b59, 0xe2d9e2}},
        {"cubehelix", {0x000000, 0x163b4e, 0xa1794a, 0xc2c3f2, 0xffffff}},
        {"Spectral", {0x9e0142, 0xf36b43, 0xffffbe, 0x71c6a5, 0x5e4fa2}},
        {"RdBu", {0x67001f, 0xd55d4c, 0xf6f7f7, 0x4f9bc7, 0x053061}},
        {"RdYlBu", {0xa50026, 0xf36b42, 0xfeffc0, 0x7db4d5, 0x313695}},
        {"BrBG", {0x543005, 0xbd7f2c, 0xf4f5f5, 0x419f97, 0x003c30}},
        {"PuOr", {0x7f3b08, 0xde8013, 0xf6f6f7, 0x887cb2, 0x2d004b}},
        {"YlGnBu", {0xffffd9, 0xd7efb3, 0x40b5c4, 0x2352a3, 0x081d58}},
        {"YlOrRd", {0xffffcc, 0xfee288, 0xfd8c3c, 0xd9131f, 0x800026}},
        {"Blues", {0xf7fbff, 0xd0e2f2, 0x6aaed6, 0x1a68ae, 0x08306b}},
        {"Greens", {0xf7fcf5, 0xd4eece, 0x73c476, 0x19833e, 0x00441b}}};
    constexpr std::array<int, 5> kEntries = {0, 50, 128, 200, 255};
    for (const Expected& expected : maps) {
        for (std::size_t k = 0; k < kEntries.size(); ++k) {
            const Srgb8 color = find_colormap(expected.name).entry(kEntries[k]);
            const std::uint32_t packed = color.r * 0x10000U + color.g * 0x100U + color.b;
            EXPECT_EQ(packed, expected.colors[k]) << expected.name << " at " << kEntries[k];
        }
    }
}

// Compares entries whose indices differ by 4, because rounding to 8 bits can reverse the order of
// adjacent entries.
TEST(ColorMap, LightnessIsMonotone) {
    const std::vector<std::string_view> sequential = {"viridis",
                                                      "magma",
                                                      "inferno",
                                                      "plasma",
                                                      "cividis",
                                                      "grey",
                                                      "labyrinth_blue",
                                                      "sea_water",
                                                      "cubehelix",
                                                      "Blues",
                                                      "Greens",
                                                      "YlGnBu",
                                                      "YlOrRd"};
    for (const std::string_view name : sequential) {
        const ColorMap& map = find_colormap(name);
        const bool darkens = lightness(map, 0) > lightness(map, 255);
        for (int i = 4; i < 256; ++i) {
            const double step = lightness(map, i) - lightness(map, i - 4);
            EXPECT_GT(darkens ? -step : step, 0.0) << name << " at " << i;
        }
    }
}

// Diverging maps are lightest in the middle.
TEST(ColorMap, DivergingMapsAreLightestInTheMiddle) {
    for (const char* const name : {"Spectral", "RdBu", "RdYlBu", "BrBG", "PuOr"}) {
        const ColorMap& map = find_colormap(name);
        for (const int i : {0, 60, 195, 255}) {
            EXPECT_LT(lightness(map, i), lightness(map, 127)) << name;
        }
    }
}

TEST(ColorMap, TwilightIsCyclic) {
    const ColorMap& map = find_colormap("twilight");
    EXPECT_EQ(map.entry(0), map.entry(255));
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
    // The color is halfway between the codes 100 and 101.
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
                     "grey, labyrinth_blue, sea_water, turbo, cubehelix, Blues, Greens, YlGnBu, "
                     "YlOrRd, Spectral, RdBu, RdYlBu, BrBG, PuOr, twilight");
    }
}

}  // namespace
}  // namespace foam::texgen
