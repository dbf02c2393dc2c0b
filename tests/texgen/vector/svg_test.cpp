// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/svg.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/vector/svg_reader.h"
#include "texgen/vector/draw.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr int kSvgPixels = 256;

// Draws frames with the default options of all maps.
struct SvgOfFrame {
    Frame frame;
    RasterGrid grid{kSvgPixels, kSvgPixels};
    FoamRecord record{};
    MapOptions maps{};
    VectorOptions options{};

    std::string text(VectorContent content = VectorContent::Foam) {
        FrameLayers layers({frame, record}, grid, 1);
        return to_svg(draw(layers, content, maps, options));
    }
};

double read_number(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
}

// Checks that the areas inside the paths of all bubbles are the areas of the bubbles.
void expect_exact_areas(SvgOfFrame& subject) {
    const std::string text = subject.text();
    const auto paths = SvgReader(text).paths("bubble");
    ASSERT_EQ(paths.size(), subject.frame.bubbles.size() + subject.frame.lone_bubbles.size());
    const std::string scale_name = "data-mm-per-foam-unit=\"";
    const double scale = read_number(text.substr(text.find(scale_name) + scale_name.size()));
    for (const auto& path : paths) {
        double area = 0.0;
        for (const Chain& chain : path.chains) {
            EXPECT_TRUE(chain.is_closed);
            area -= signed_area(chain);  // y points down, so outlines are clockwise
        }
        const double expected = read_number(path.attribute("data-area")) * scale * scale;
        EXPECT_NEAR(area / expected, 1.0, 1e-6);
    }
}

TEST(Svg, AreasSurviveTheTextOnATorus) {
    SvgOfFrame subject{test::fitted_frame(test::polydisperse_foam(80, 4), kSvgPixels, kSvgPixels)};
    expect_exact_areas(subject);
    subject.options.wrap = VectorWrap::Whole;
    expect_exact_areas(subject);
}

// Small drawings have small bubbles: 80 bubbles on 1 mm².
TEST(Svg, AreasSurviveTheTextInASmallDrawing) {
    SvgOfFrame subject{test::fitted_frame(test::polydisperse_foam(80, 4), kSvgPixels, kSvgPixels)};
    subject.options.width_mm = 1.0;
    expect_exact_areas(subject);
}

// The outer films of a patch, and circles, turn by more than 180 degrees.
TEST(Svg, AreasSurviveTheTextInAPatch) {
    Foam foam = test::patch_foam(12, 5);
    foam.lone_bubbles.push_back({foam.next_identity, {10.0, 0.0}, 2.0});
    SvgOfFrame subject{snapshot(foam, 1), {kSvgPixels, kSvgPixels, 0, 0, View{{0.0, 0.0}, 20.0}}};
    expect_exact_areas(subject);
}

TEST(Svg, BubblesHaveDataAndUniqueIds) {
    SvgOfFrame subject{test::fitted_frame(test::polydisperse_foam(30, 4), kSvgPixels, kSvgPixels)};
    const std::string text = subject.text();
    const auto paths = SvgReader(text).paths("bubble");
    for (std::size_t k = 0; k < paths.size(); ++k) {
        const auto id = id_at<BubbleId>(k);
        const FrameBubble& bubble = subject.frame.bubbles[id];
        EXPECT_EQ(paths[k].attribute("id"), "bubble-" + std::to_string(bubble.identity));
        EXPECT_EQ(read_number(paths[k].attribute("data-area")), bubble.area);
        EXPECT_EQ(read_number(paths[k].attribute("data-pressure")), bubble.pressure);
        EXPECT_EQ(paths[k].attribute("data-sides"),
                  std::to_string(subject.frame.network.sides(id)));
        EXPECT_EQ(paths[k].attribute("fill").size(), 7U);
    }
}

// A drawing of one closed chain: a half disk of radius 1 around (2, 1) with its straight side
// below, on a page that is 4 x 3 mm.
TEST(Svg, AHalfDiskIsTwoArcsAndALine) {
    Drawing drawing{.width = 4.0, .height = 3.0, .title = "a < b & c"};
    const Chain half{{3.0, 1.0}, {{{1.0, 1.0}, 0.5 * std::numbers::pi}, {{3.0, 1.0}, 0.0}}, true};
    drawing.layers.push_back({.name = "walls",
                              .style = {.fill = "#000000"},
                              .shapes = {{.kind = "wall", .chains = {half}}}});
    const std::string text = to_svg(drawing);
    // Half a circle is written as two arcs of 90 degrees; y is measured from the top.
    EXPECT_NE(text.find("d=\"M3,2A1,1 0 0,0 2,1A1,1 0 0,0 1,2L3,2Z\""), std::string::npos) << text;
    EXPECT_NE(text.find("width=\"4mm\" height=\"3mm\" viewBox=\"0 0 4 3\""), std::string::npos);
    EXPECT_NE(text.find("<title>a &lt; b &amp; c</title>"), std::string::npos);
    EXPECT_NE(text.find("<g id=\"walls\" inkscape:groupmode=\"layer\" inkscape:label=\"walls\""),
              std::string::npos);
}

}  // namespace
}  // namespace foam::texgen
