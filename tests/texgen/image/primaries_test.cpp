// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/primaries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

double row_sum(const ColorMatrix& matrix, std::size_t row) {
    return matrix[row][0] + matrix[row][1] + matrix[row][2];
}

ChannelGroup numbers(std::vector<std::string> names, std::initializer_list<float> samples) {
    Image<float> image(
        static_cast<int>(samples.size() / names.size()), 1, static_cast<int>(names.size()));
    std::copy(samples.begin(), samples.end(), image.samples().begin());
    return {std::move(names), SampleType::Half, std::move(image)};
}

std::vector<float> samples_of(const Picture& picture, std::size_t group) {
    const auto samples = std::get<Image<float>>(picture.groups[group].samples).samples();
    return {samples.begin(), samples.end()};
}

// The matrix of the built-in transform of OpenColorIO 2 from ACEScg to linear BT.709 with Bradford
// adaptation, inverted, which is also the figure that colour-science publishes.
TEST(Primaries, TheMatrixToAcesCgIsTheKnownOne) {
    constexpr ColorMatrix kKnown = {{{0.613097, 0.339523, 0.047379},
                                     {0.070194, 0.916354, 0.013452},
                                     {0.020616, 0.109570, 0.869815}}};
    const ColorMatrix found = conversion(Primaries::Srgb, Primaries::AcesCg);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(found[i][j], kKnown[i][j], 1e-6) << i << j;
        }
    }
}

// White has the numbers (1, 1, 1) in both color spaces.
TEST(Primaries, WhiteStaysWhite) {
    for (const auto& [from, to] : {std::pair(Primaries::Srgb, Primaries::AcesCg),
                                   std::pair(Primaries::AcesCg, Primaries::Srgb)}) {
        const ColorMatrix matrix = conversion(from, to);
        for (std::size_t row = 0; row < 3; ++row) {
            EXPECT_NEAR(row_sum(matrix, row), 1.0, 1e-14);
        }
    }
}

TEST(Primaries, AConversionToTheSameSpaceIsTheIdentity) {
    const ColorMatrix matrix = conversion(Primaries::AcesCg, Primaries::AcesCg);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(matrix[i][j], i == j ? 1.0 : 0.0, 1e-14);
        }
    }
}

// Red becomes the first column of the matrix. The opacity and the heights are no colors.
TEST(ConvertColors, ChangesOnlyTheColorsOfTheLayer) {
    const ChannelGroup red = numbers({"R", "G", "B", "A"}, {1.0F, 0.0F, 0.0F, 0.25F});
    const ChannelGroup normal = numbers({"a.R", "a.G", "a.B"}, {1.0F, 0.0F, 0.0F});
    const ChannelGroup height = numbers({"Y"}, {0.5F});
    Picture picture{{red, normal, height}};
    convert_colors(picture, "", Primaries::Srgb, Primaries::AcesCg);
    const std::vector<float> converted = samples_of(picture, 0);
    EXPECT_NEAR(converted[0], 0.613097, 1e-6);
    EXPECT_NEAR(converted[1], 0.070194, 1e-6);
    EXPECT_NEAR(converted[2], 0.020616, 1e-6);
    EXPECT_EQ(converted[3], 0.25F);
    EXPECT_EQ(samples_of(picture, 1), (std::vector<float>{1.0F, 0.0F, 0.0F}));
    EXPECT_EQ(samples_of(picture, 2), std::vector<float>{0.5F});
    convert_colors(picture, "a", Primaries::Srgb, Primaries::AcesCg);
    EXPECT_NEAR(samples_of(picture, 1)[0], 0.613097, 1e-6);
}

// A decoded picture has one group per channel.
TEST(ConvertColors, FindsChannelsOfSeveralGroupsAndInvertsItself) {
    Picture picture{
        {numbers({"B"}, {0.2F, 0.7F}), numbers({"G"}, {0.4F, 0.0F}), numbers({"R"}, {0.9F, 0.1F})}};
    const Picture before = picture;
    convert_colors(picture, "", Primaries::Srgb, Primaries::AcesCg);
    EXPECT_NE(samples_of(picture, 2), samples_of(before, 2));
    convert_colors(picture, "", Primaries::AcesCg, Primaries::Srgb);
    for (std::size_t group = 0; group < 3; ++group) {
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_NEAR(samples_of(picture, group)[k], samples_of(before, group)[k], 1e-6);
        }
    }
}

TEST(ConvertColors, DoesNothingWithoutThreeChannelsOfFloats) {
    Picture picture{{numbers({"R", "G"}, {1.0F, 0.0F})}};
    convert_colors(picture, "", Primaries::Srgb, Primaries::AcesCg);
    EXPECT_EQ(samples_of(picture, 0), (std::vector<float>{1.0F, 0.0F}));
}

TEST(Primaries, HaveNamesOfLinearLight) {
    EXPECT_EQ(linear_space_name(Primaries::Srgb), "linear sRGB");
    EXPECT_EQ(linear_space_name(Primaries::AcesCg), "ACEScg");
}

}  // namespace
}  // namespace foam::texgen
