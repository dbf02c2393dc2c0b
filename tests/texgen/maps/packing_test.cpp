// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/packing.h"

#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 48;

ShownLayers layers_of(const test::MapSubject& subject, const RasterGrid& grid) {
    return {.layers = FrameLayers({subject.frame,
                                   subject.record,
                                   &subject.next,
                                   {.gradient = true, .smooth = SmoothImages::DistanceAndGradient}},
                                  grid,
                                  1)};
}

MapImage packed(const char* text, const MapOptions& options = {}) {
    ShownLayers shown = layers_of(test::torus_subject(), test::torus_grid(kSize));
    return draw_packed(parse_packing(text), shown, options);
}

template <class Pixels>
Pixels drawn(const char* map, const MapOptions& options = {}) {
    return std::get<Pixels>(draw(map, test::torus_subject(), test::torus_grid(kSize), 1, options));
}

TEST(Packing, ParsesNamesBitsAndChannels) {
    const Packing packing = parse_packing("M-1:16=height,1-roughness,normal.Y,0.25");
    EXPECT_EQ(packing.name, "M-1");
    EXPECT_EQ(packing.bits, 16);
    EXPECT_FALSE(packing.is_color);
    ASSERT_EQ(packing.channels.size(), 4U);
    EXPECT_EQ(packing.channels[0].map, &find_map("height"));
    EXPECT_FALSE(packing.channels[0].inverted);
    EXPECT_EQ(packing.channels[1].map, &find_map("roughness"));
    EXPECT_TRUE(packing.channels[1].inverted);
    EXPECT_EQ(packing.channels[2].map, &find_map("normal"));
    EXPECT_EQ(packing.channels[2].channel, 1);
    EXPECT_EQ(packing.channels[3].map, nullptr);
    EXPECT_EQ(packing.channels[3].constant, 0.25);
    EXPECT_EQ(packing.channels[1].text, "1-roughness");
    EXPECT_EQ(parse_packing("A=0,1,0").bits, 8);
    EXPECT_TRUE(parse_packing("A=albedo.R,albedo.G,albedo.B,opacity").is_color);
}

// Each of these texts is wrong in one place, which the message names.
TEST(Packing, RejectsOtherTexts) {
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"ORM", "must be NAME=R,G,B"},
        {"=0,0,0", "letters, digits"},
        {"a/b=0,0,0", "letters, digits"},
        {"X:12=0,0,0", "8 or 16"},
        {"X:8:8=0,0,0", "8 or 16"},
        {"Albedo=0,0,0", "a map has this name"},
        {"X=0,0", "has 2 channels"},
        {"X=0,0,0,0,0", "has 5 channels"},
        {"X=0,0,1.5", "not from 0 to 1"},
        {"X=0,0,-0.5", "not from 0 to 1"},
        {"X=0,0,nan", "not from 0 to 1"},
        {"X=0,0,heigth", "did you mean 'height'?"},
        {"X=motion,0,0", "has the channels X Y; name one of them, such as motion.X"},
        {"X=normal.W,0,0", "no channel 'W', only X Y Z"},
        {"X=height.X,0,0", "no channel 'X', only Y"},
        {"X=id,0,0", "integers"},
        {"X=sides,0,0", "integers"},
        {"X=albedo.R,roughness,0", "albedo.R is a color, but roughness is not"},
        {"X=roughness,0,0,albedo.R", "albedo.R is a color, but A must be data"},
        {"X=albedo.R,albedo.G,albedo.B,albedo.R", "A must be data"},
        {"X=1-albedo.R,albedo.G,albedo.B", "cannot be inverted"},
        {"X:16=albedo.R,albedo.G,albedo.B", "8 bits"},
    };
    for (const auto& [text, reason] : wrong) {
        try {
            parse_packing(text);
            ADD_FAILURE() << text;
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
    }
}

TEST(Packing, NamesEachMapOnce) {
    const auto maps = maps_in(parse_packing("X=normal.X,normal.Y,0,roughness"));
    EXPECT_EQ(maps, (std::vector<const Map*>{&find_map("normal"), &find_map("roughness")}));
}

// A packed number is the fraction of the range of its map: for a normal from -1 to 1, the fraction
// of x is (x + 1) / 2.
TEST(Packing, HoldsFractionsOfTheRangesOfItsMaps) {
    MapOptions options;
    options.height.full = {0.5, false};
    const auto image =
        std::get<NumberPixels>(packed("X=height,normal.X,1-roughness,0.25", options));
    EXPECT_EQ(image.low, 0.0);
    EXPECT_EQ(image.high, 1.0);
    const Image<float> height = drawn<NumberPixels>("height", options).pixels;
    const Image<float> normal = drawn<NumberPixels>("normal").pixels;
    const Image<float> roughness = drawn<NumberPixels>("roughness").pixels;
    for (std::size_t k = 0; k < height.samples().size(); ++k) {
        const auto pixel = image.pixels.samples().subspan(4 * k, 4);
        EXPECT_NEAR(pixel[0], height.samples()[k] / 0.5F, 1e-6);
        EXPECT_NEAR(pixel[1], (normal.samples()[3 * k] + 1.0F) / 2.0F, 1e-6);
        EXPECT_NEAR(pixel[2], 1.0F - roughness.samples()[k], 1e-6);
        EXPECT_EQ(pixel[3], 0.25F);
    }
}

TEST(Packing, HoldsThePressureAsNumbersWithAColorMap) {
    MapOptions colored;
    colored.pressure.colormap = "viridis";
    const auto image = std::get<NumberPixels>(packed("X=pressure,1-pressure,0", colored));
    const Image<float> tones = drawn<NumberPixels>("pressure").pixels;
    for (std::size_t k = 0; k < tones.samples().size(); ++k) {
        EXPECT_EQ(image.pixels.samples()[3 * k], tones.samples()[k]);
        EXPECT_FLOAT_EQ(image.pixels.samples()[3 * k + 1], 1.0F - tones.samples()[k]);
    }
}

TEST(Packing, OfColorsHoldsTheirLight) {
    const Image<std::uint16_t> image =
        std::get<ColorPixels>(packed("X=albedo.B,albedo.G,albedo.R,roughness")).pixels;
    const Image<std::uint16_t> albedo = drawn<ColorPixels>("albedo").pixels;
    const Image<float> roughness = drawn<NumberPixels>("roughness").pixels;
    for (std::size_t k = 0; k < roughness.samples().size(); ++k) {
        EXPECT_EQ(image.samples()[4 * k], albedo.samples()[3 * k + 2]);
        EXPECT_EQ(image.samples()[4 * k + 2], albedo.samples()[3 * k]);
        EXPECT_EQ(image.samples()[4 * k + 3],
                  to_sample(static_cast<double>(roughness.samples()[k])));
    }
}

// Around a patch, packed maps have the values that they have as images of their own, and colors do
// not depend on the opacity.
TEST(Packing, OfAPatchHasItsSurroundings) {
    ShownLayers shown = layers_of(test::patch_subject(), test::patch_grid(kSize));
    const auto data = std::get<NumberPixels>(
        draw_packed(parse_packing("X=occlusion,roughness,opacity"), shown, {}));
    const auto corner = data.pixels.pixel(0, kSize - 1);
    EXPECT_EQ(corner[0], 1.0F);
    EXPECT_EQ(corner[1], 0.0F);
    EXPECT_EQ(corner[2], 0.0F);
    const auto colors = std::get<ColorPixels>(
        draw_packed(parse_packing("X=albedo.R,albedo.G,albedo.B"), shown, {}));
    EXPECT_EQ(colors.pixels.channels(), 3);
}

}  // namespace
}  // namespace foam::texgen
