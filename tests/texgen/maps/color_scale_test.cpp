// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/color_scale.h"

#include "texgen/json/json_writer.h"

#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>
#include <string>
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

constexpr Srgb8 kBlack{0, 0, 0};
constexpr Srgb8 kGrey{100, 100, 100};
constexpr Srgb8 kWhite{200, 200, 200};

// Without positions, a gradient is the same as its colors.
TEST(ColorScale, AGradientWithoutPositionsIsEven) {
    const Gradient gradient =
        parse_gradient({"#000000", "#ff8000", "#ffffff"}, ScaleEnd::LastColor);
    EXPECT_TRUE(gradient.positions.empty());
    EXPECT_EQ(to_srgb8(blended(gradient, 0.2)), (Srgb8{102, 51, 0}));
    EXPECT_EQ(to_srgb8(picked(gradient, 0.4)), (Srgb8{255, 128, 0}));
}

TEST(ColorScale, PositionsMoveColors) {
    const Gradient gradient =
        parse_gradient({"#000000", "#646464@0.25", "#c8c8c8"}, ScaleEnd::LastColor);
    EXPECT_EQ(gradient.positions, (std::vector<double>{0.0, 0.25, 1.0}));
    EXPECT_EQ(to_srgb8(blended(gradient, 0.0)), kBlack);
    EXPECT_EQ(to_srgb8(blended(gradient, 0.25)), kGrey);
    EXPECT_EQ(to_srgb8(blended(gradient, 0.625)), (Srgb8{150, 150, 150}));
    EXPECT_EQ(to_srgb8(blended(gradient, 2.0)), kWhite);
}

// Colors without positions are evenly spaced between their neighbors, as in a gradient of CSS.
TEST(ColorScale, ColorsBetweenPositionsAreEvenlySpaced) {
    const std::vector<std::string> list = {
        "#000000@0.1", "#000000", "#000000", "#000000@0.4", "#000000", "#000000"};
    const auto expect = [](const std::vector<double>& found, const std::vector<double>& expected) {
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_NEAR(found[k], expected[k], 1e-12) << k;
        }
    };
    expect(parse_gradient(list, ScaleEnd::LastColor).positions, {0.1, 0.2, 0.3, 0.4, 0.7, 1.0});
    expect(parse_gradient(list, ScaleEnd::AfterLastColor).positions,
           {0.1, 0.2, 0.3, 0.4, 0.6, 0.8});
}

// Beyond the first and the last position, the scale is constant. At two equal positions, it jumps.
TEST(ColorScale, GradientsMayJump) {
    const Gradient gradient =
        parse_gradient({"#000000@0.2", "#646464@0.5", "#c8c8c8@0.5"}, ScaleEnd::LastColor);
    EXPECT_EQ(to_srgb8(blended(gradient, 0.1)), kBlack);
    EXPECT_EQ(to_srgb8(blended(gradient, 0.499999)), kGrey);
    EXPECT_EQ(to_srgb8(blended(gradient, 0.5)), kWhite);
    EXPECT_EQ(to_srgb8(blended(gradient, 0.9)), kWhite);
}

// A color is picked from its position to the next one; the first color also before its position.
TEST(ColorScale, PositionsAreBordersOfPickedColors) {
    const Gradient gradient =
        parse_gradient({"#000000@0.1", "#646464@0.6", "#c8c8c8"}, ScaleEnd::AfterLastColor);
    EXPECT_EQ(to_srgb8(picked(gradient, 0.0)), kBlack);
    EXPECT_EQ(to_srgb8(picked(gradient, 0.59)), kBlack);
    EXPECT_EQ(to_srgb8(picked(gradient, 0.6)), kGrey);
    EXPECT_EQ(to_srgb8(picked(gradient, 0.79)), kGrey);
    EXPECT_EQ(to_srgb8(picked(gradient, 0.81)), kWhite);
    EXPECT_EQ(to_srgb8(picked(gradient, 1.0)), kWhite);
}

TEST(ColorScale, SaysWhatIsWrongWithAGradient) {
    const auto fault = [](const std::vector<std::string>& list) {
        Value::List values;
        for (const std::string& item : list) {
            values.push_back({item});
        }
        std::vector<std::string> member;
        EXPECT_EQ(Gradients{}.read({values}, member), Gradients{}.fault({values}).empty());
        return Gradients{}.fault({values});
    };
    EXPECT_EQ(fault({}), "");
    EXPECT_EQ(fault({"#000000@0", "#ffffff@1"}), "");
    EXPECT_EQ(fault({"#000000@0.5", "#ffffff@0.4"}), "positions of colors must not descend");
    EXPECT_EQ(fault({"#00@0.5"}), "color '#00': must be '#rrggbb', six hexadecimal digits");
    for (const char* const item : {"#000000@",
                                   "#000000@1.5",
                                   "#000000@-0.1",
                                   "#000000@25%",
                                   "#000000@nan",
                                   "#000000 @0.5"}) {
        EXPECT_NE(fault({item}), "") << item;
    }
}

// Editors check lists of colors with the pattern of the schema.
TEST(ColorScale, TheSchemaAllowsWhatIsRead) {
    const Json schema = Json::parse(Gradients{}.schema());
    const std::regex pattern(schema["anyOf"][0]["pattern"].get<std::string>());
    EXPECT_EQ(schema["anyOf"][1]["items"], schema["anyOf"][0]);
    const auto is_read = [](const std::string& color) {
        std::vector<std::string> member;
        return Gradients{}.read({color}, member);
    };
    for (const char* const position :
         {"", "@0", "@1", "@00.50", "@.5", "@0.", "@1.", "@01.00", "@1e-1", "@2.5E-01"}) {
        const std::string color = std::string("#fF0000") + position;
        EXPECT_TRUE(std::regex_search(color, pattern)) << color;
        EXPECT_TRUE(is_read(color)) << color;
    }
    for (const char* const position :
         {"@", "@.", "@2", "@1.01", "@10", "@-0.5", "@+0.5", "@0.5.1", "@e-1", "@0.5e", " @0"}) {
        const std::string color = std::string("#fF0000") + position;
        EXPECT_FALSE(std::regex_search(color, pattern)) << color;
        EXPECT_FALSE(is_read(color)) << color;
    }
}

TEST(ColorScale, AnInvalidColorIsRejected) {
    EXPECT_THROW(parse_colors({"#12345"}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
