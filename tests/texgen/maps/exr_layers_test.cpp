#include "texgen/maps/exr_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foam::texgen {
namespace {

std::vector<std::string> names_of(const ExrLayers& layers) {
    std::vector<std::string> names;
    for (const ExrChannel& channel : layers.channels()) {
        names.push_back(channel.name);
    }
    return names;
}

TEST(ExrLayers, NamesAndTypesSayWhatAMapIs) {
    ExrLayers layers(ExrType::Float);
    layers.add("albedo", "R G B", ColorPixels{Image<std::uint16_t>(2, 1, 4)});
    layers.add("height", "Y", NumberPixels{Image<float>(2, 1, 1)});
    layers.add("", "Y", IdPixels{Image<std::uint32_t>(2, 1, 1)});
    EXPECT_EQ(names_of(layers),
              (std::vector<std::string>{
                  "albedo.R", "albedo.G", "albedo.B", "albedo.A", "height.Y", "Y"}));
    EXPECT_EQ(layers.channels()[3].type, ExrType::Half);
    EXPECT_EQ(layers.channels()[3].channel, 3);
    EXPECT_EQ(layers.channels()[4].type, ExrType::Float);
    EXPECT_EQ(layers.channels()[5].type, ExrType::Uint);
    EXPECT_TRUE(layers.has_colors());
}

TEST(ExrLayers, NumbersMayBeHalves) {
    ExrLayers layers(ExrType::Half);
    layers.add("", "X Y", NumberPixels{Image<float>(2, 1, 2)});
    EXPECT_EQ(names_of(layers), (std::vector<std::string>{"X", "Y"}));
    EXPECT_EQ(layers.channels()[0].type, ExrType::Half);
    EXPECT_FALSE(layers.has_colors());
}

// Half opaque, white becomes half as bright; where nothing is opaque, nothing shines.
TEST(ExrLayers, ColorsAreMultipliedByTheirOpacity) {
    ColorPixels colors{Image<std::uint16_t>(2, 1, 4)};
    std::ranges::copy(std::vector{65535, 0, 13107, 32768}, colors.pixels.pixel(0, 0).begin());
    std::ranges::copy(std::vector{65535, 65535, 65535, 0}, colors.pixels.pixel(1, 0).begin());
    const Image<float> light = premultiplied(colors);
    const float half = 32768.0F / 65535.0F;
    EXPECT_EQ(light.pixel(0, 0)[0], half);
    EXPECT_EQ(light.pixel(0, 0)[1], 0.0F);
    EXPECT_NEAR(light.pixel(0, 0)[2], 0.2F * half, 1e-7F);
    EXPECT_EQ(light.pixel(0, 0)[3], half);
    EXPECT_TRUE(std::ranges::equal(light.pixel(1, 0), std::vector{0.0F, 0.0F, 0.0F, 0.0F}));
}

TEST(ExrLayers, OpaqueColorsAreLightFromZeroToOne) {
    ColorPixels colors{Image<std::uint16_t>(1, 1, 3)};
    colors.pixels.pixel(0, 0)[1] = 65535;
    EXPECT_TRUE(std::ranges::equal(premultiplied(colors).samples(), std::vector{0.0F, 1.0F, 0.0F}));
}

}  // namespace
}  // namespace foam::texgen
