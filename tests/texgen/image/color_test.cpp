// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

TEST(Color, TransferFunctionMatchesTheStandard) {
    EXPECT_DOUBLE_EQ(srgb_to_linear(0.0), 0.0);
    EXPECT_DOUBLE_EQ(srgb_to_linear(1.0), 1.0);
    EXPECT_DOUBLE_EQ(srgb_to_linear(0.04), 0.04 / 12.92);              // in the linear part
    EXPECT_NEAR(srgb_to_linear(0.5), 0.214041140482, 1e-12);           // (0.555 / 1.055)^2.4
    EXPECT_NEAR(linear_to_srgb(0.18), 0.461356129500, 1e-12);          // middle gray
    EXPECT_NEAR(linear_to_srgb(0.0031308), 12.92 * 0.0031308, 1e-15);  // end of the linear part
}

TEST(Color, EveryCodeRoundTripsThroughLinearLight) {
    for (int code = 0; code < 256; ++code) {
        const auto c = static_cast<std::uint8_t>(code);
        const Srgb8 color{c, static_cast<std::uint8_t>(255 - code), c};
        EXPECT_EQ(to_srgb8(to_linear(color)), color) << code;
    }
}

TEST(Color, LightOutOfRangeIsClamped) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(to_srgb8({-0.5, 2.0, nan}), (Srgb8{0, 255, 0}));
}

TEST(Color, ParsesSixHexDigitsInEitherCase) {
    EXPECT_EQ(parse_color("#ffa007"), (Srgb8{255, 160, 7}));
    EXPECT_EQ(parse_color("#FFA007"), (Srgb8{255, 160, 7}));
}

TEST(Color, RejectsAnythingElse) {
    for (const char* text :
         {"", "#", "ffa007", "#ffa00", "#ffa0070", "#ffa00g", "#-fa007", "# fa007"}) {
        EXPECT_THROW(parse_color(text), std::invalid_argument) << text;
    }
    try {
        parse_color("white");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "color 'white': must be '#rrggbb', six hexadecimal digits");
    }
}

}  // namespace
}  // namespace foam::texgen
