// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/quantize.h"

#include "texgen/image/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foam::texgen {
namespace {

template <class Pixels, class Sample>
Pixels row_of(const std::vector<Sample>& samples, int channels) {
    Pixels row;
    row.pixels = Image<Sample>(static_cast<int>(samples.size()) / channels, 1, channels);
    std::copy(samples.begin(), samples.end(), row.pixels.samples().begin());
    return row;
}

template <class Code>
std::vector<Code> codes_of(const MapImage& map, int bits) {
    const CodedImage coded = quantize(map, bits);
    const auto samples = std::get<Image<Code>>(coded.codes).samples();
    return {samples.begin(), samples.end()};
}

// The range is from -1 to 3, so 0 is at 1/4 of the range and 1 at 1/2. 63.75 rounds to 64, 127.5 to
// 128.
TEST(Quantize, NumbersGoFromLowToHigh) {
    auto numbers = row_of<NumberPixels>(std::vector<float>{-1.0F, 0.0F, 1.0F, 3.0F}, 1);
    numbers.low = -1.0;
    numbers.high = 3.0;
    EXPECT_EQ(codes_of<std::uint8_t>(numbers, 8), (std::vector<std::uint8_t>{0, 64, 128, 255}));
    EXPECT_EQ(codes_of<std::uint16_t>(numbers, 16),
              (std::vector<std::uint16_t>{0, 16384, 32768, 65535}));
    EXPECT_FALSE(quantize(numbers, 8).color);
}

TEST(Quantize, NumbersBeyondTheEndsAreHeldAtThem) {
    const float infinity = std::numeric_limits<float>::infinity();
    const auto numbers =
        row_of<NumberPixels>(std::vector<float>{-0.1F, 1.1F, -infinity, infinity, NAN}, 1);
    EXPECT_EQ(codes_of<std::uint8_t>(numbers, 8), (std::vector<std::uint8_t>{0, 255, 0, 255, 0}));
}

TEST(Quantize, TwoChannelsGetAThird) {
    const auto numbers = row_of<NumberPixels>(std::vector<float>{0.0F, 1.0F, 1.0F, 0.2F}, 2);
    EXPECT_EQ(codes_of<std::uint8_t>(numbers, 8),
              (std::vector<std::uint8_t>{0, 255, 0, 255, 51, 0}));
}

TEST(Quantize, ColorsAreSrgbAndOpacityIsNot) {
    // Light 0.5 is code 188 of sRGB; opacity 0.5 is code 128.
    const auto colors = row_of<ColorPixels>(std::vector<std::uint16_t>{0, 32768, 65535, 32768}, 4);
    EXPECT_EQ(codes_of<std::uint8_t>(colors, 8), (std::vector<std::uint8_t>{0, 188, 255, 128}));
    EXPECT_TRUE(quantize(colors, 8).color);
}

TEST(Quantize, EveryLightIsTheNearestCode) {
    for (int value = 0; value < 65536; value += 7) {
        const auto light = static_cast<std::uint16_t>(value);
        const auto colors = row_of<ColorPixels>(std::vector<std::uint16_t>{light, light, light}, 3);
        const double exact = 255.0 * linear_to_srgb(value / 65535.0);
        EXPECT_NEAR(codes_of<std::uint8_t>(colors, 8).front(), exact, 0.5 + 1e-9);
    }
}

TEST(Quantize, IdsKeepTheirLowestBits) {
    const auto ids = row_of<IdPixels>(std::vector<std::uint32_t>{5, 65535, 65536 + 258}, 1);
    EXPECT_EQ(codes_of<std::uint16_t>(ids, 16), (std::vector<std::uint16_t>{5, 65535, 258}));
    EXPECT_EQ(codes_of<std::uint8_t>(ids, 8), (std::vector<std::uint8_t>{5, 255, 2}));
}

}  // namespace
}  // namespace foam::texgen
