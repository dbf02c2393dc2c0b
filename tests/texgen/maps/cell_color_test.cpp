// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cell_color.h"

#include "core/foam/honeycomb.h"
#include "tests/texgen/maps/map_subjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Frame hexagons() {
    return snapshot(foam::honeycomb(4, 4), 1);
}

TEST(CellColor, AreasAndSidesOfAHoneycombAreInTheMiddleOfTheScale) {
    for (const ColorBy by : {ColorBy::Area, ColorBy::Sides}) {
        AlbedoOptions options;
        options.color_by = by;
        for (const double position : scale_positions(hexagons(), {}, options)) {
            EXPECT_NEAR(position, 0.5, 1e-12);
        }
    }
}

TEST(CellColor, ARandomColorStaysWithItsBubble) {
    AlbedoOptions options;
    options.color_by = ColorBy::Random;
    const PerBubble<double> before = scale_positions(test::torus_subject().frame, {}, options);
    const PerBubble<double> after = scale_positions(test::torus_subject().next, {}, options);
    EXPECT_EQ(before, after);
    EXPECT_GE(*std::ranges::min_element(before), 0.0);
    EXPECT_LT(*std::ranges::max_element(before), 1.0);
    EXPECT_GT(*std::ranges::max_element(before) - *std::ranges::min_element(before), 0.8);
}

TEST(CellColor, AnEmptyRangeOfPressuresIsRejected) {
    AlbedoOptions options;
    options.pressure_low = 0.75;
    options.pressure_high = 0.5;
    try {
        scale_positions(hexagons(), {}, options);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()),
                  "albedo.pressure_low is 0.75, but must be below albedo.pressure_high, which is "
                  "0.5");
    }
}

TEST(CellColor, ColorsOfYourOwnAreBlendedInSrgbOrPicked) {
    AlbedoOptions options;
    options.color_by = ColorBy::Area;
    options.colors = {"#000000", "#ff8000", "#ffffff"};
    EXPECT_EQ(to_srgb8(cell_colors(hexagons(), {}, options).front()), (Srgb8{255, 128, 0}));
    options.colors = {"#000000", "#808080"};
    EXPECT_EQ(to_srgb8(cell_colors(hexagons(), {}, options).front()), (Srgb8{64, 64, 64}));
    options.color_mix = ColorMix::Pick;
    EXPECT_EQ(to_srgb8(cell_colors(hexagons(), {}, options).front()), (Srgb8{128, 128, 128}));
}

TEST(CellColor, VariationIsOfLightAndStaysWithinItsPart) {
    AlbedoOptions options;
    options.colors = {"#808080"};
    options.variation = 0.25;
    const double gray = to_linear(parse_color("#808080")).r;
    std::vector<double> light;
    for (const LinearRgb& color : cell_colors(test::torus_subject().frame, {}, options)) {
        EXPECT_EQ(color.r, color.b);
        light.push_back(color.r / gray);
    }
    EXPECT_GE(*std::ranges::min_element(light), 0.75);
    EXPECT_LE(*std::ranges::max_element(light), 1.25);
    EXPECT_GT(*std::ranges::max_element(light) - *std::ranges::min_element(light), 0.3);
}

}  // namespace
}  // namespace foam::texgen
