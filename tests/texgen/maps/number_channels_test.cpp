// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/number_channels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foam::texgen {
namespace {

TEST(NumberChannels, NamesAndTypesDescribeTheMap) {
    const ChannelGroup albedo = number_channels(
        ColorPixels{Image<std::uint16_t>(2, 1, 4)}, {"albedo", "R G B"}, SampleType::Float);
    EXPECT_EQ(albedo.names,
              (std::vector<std::string>{"albedo.R", "albedo.G", "albedo.B", "albedo.A"}));
    EXPECT_EQ(albedo.type, SampleType::Half);
    const ChannelGroup height =
        number_channels(NumberPixels{Image<float>(2, 1, 1)}, {"height", "Y"}, SampleType::Float);
    EXPECT_EQ(height.names, std::vector<std::string>{"height.Y"});
    EXPECT_EQ(height.type, SampleType::Float);
    const ChannelGroup id =
        number_channels(IdPixels{Image<std::uint32_t>(2, 1, 1)}, {"", "Y"}, SampleType::Half);
    EXPECT_EQ(id.names, std::vector<std::string>{"Y"});
    EXPECT_EQ(id.type, SampleType::Uint32);
}

TEST(NumberChannels, NumbersMayBeHalves) {
    const ChannelGroup motion =
        number_channels(NumberPixels{Image<float>(2, 1, 2)}, {"", "X Y"}, SampleType::Half);
    EXPECT_EQ(motion.names, (std::vector<std::string>{"X", "Y"}));
    EXPECT_EQ(motion.type, SampleType::Half);
}

// The first pixel has an opacity of about a half, the second one is fully transparent.
TEST(NumberChannels, ColorsAreMultipliedByTheirOpacity) {
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

TEST(NumberChannels, OpaqueColorsAreLightFromZeroToOne) {
    ColorPixels colors{Image<std::uint16_t>(1, 1, 3)};
    colors.pixels.pixel(0, 0)[1] = 65535;
    EXPECT_TRUE(std::ranges::equal(premultiplied(colors).samples(), std::vector{0.0F, 1.0F, 0.0F}));
}

}  // namespace
}  // namespace foam::texgen
