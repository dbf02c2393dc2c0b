// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cross_fade.h"

#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

template <class Sample>
Image<Sample> row_of(const std::vector<Sample>& samples, int channels) {
    const int width = static_cast<int>(samples.size()) / channels;
    Image<Sample> image(width, 1, channels);
    std::copy(samples.begin(), samples.end(), image.samples().begin());
    return image;
}

template <class Sample>
std::vector<Sample> samples_of(const Image<Sample>& image) {
    return {image.samples().begin(), image.samples().end()};
}

template <class Sample>
Image<float> all_of(float weight, const Image<Sample>& like) {
    Image<float> weights(like.width(), like.height(), 1);
    std::ranges::fill(weights.samples(), weight);
    return weights;
}

TEST(CrossFade, EveryPixelHasAShareOfItsOwn) {
    const NumberPixels fading_out{row_of<float>({0.0F, 0.0F, 0.0F}, 1)};
    const NumberPixels fading_in{row_of<float>({8.0F, 8.0F, 8.0F}, 1)};
    const auto mixed = std::get<NumberPixels>(
        cross_fade(fading_out, fading_in, row_of<float>({0.0F, 0.25F, 1.0F}, 1), Mixing::Values));
    EXPECT_EQ(samples_of(mixed.pixels), (std::vector<float>{0.0F, 2.0F, 8.0F}));
}

TEST(CrossFade, ColorsAreMixedAsLight) {
    const ColorPixels fading_out{row_of<std::uint16_t>({0, 1000, 65535}, 3)};
    const ColorPixels fading_in{row_of<std::uint16_t>({65535, 3000, 65535}, 3)};
    const auto mixed = [&](float weight) {
        return samples_of(std::get<ColorPixels>(cross_fade(fading_out,
                                                           fading_in,
                                                           all_of(weight, fading_out.pixels),
                                                           Mixing::Values))
                              .pixels);
    };
    EXPECT_EQ(mixed(0.25F), (std::vector<std::uint16_t>{16384, 1500, 65535}));
    EXPECT_EQ(mixed(0.0F), samples_of(fading_out.pixels));
    EXPECT_EQ(mixed(1.0F), samples_of(fading_in.pixels));
}

TEST(CrossFade, NumbersAreMixedAndKeepTheirRange) {
    const NumberPixels fading_out{row_of<float>({1.0F, -2.0F}, 1), -3.0, 3.0};
    const NumberPixels fading_in{row_of<float>({2.0F, 2.0F}, 1), -3.0, 3.0};
    const auto mixed = std::get<NumberPixels>(
        cross_fade(fading_out, fading_in, all_of(0.75F, fading_out.pixels), Mixing::Values));
    EXPECT_EQ(samples_of(mixed.pixels), (std::vector<float>{1.75F, 1.0F}));
    EXPECT_EQ(mixed.low, -3.0);
    EXPECT_EQ(mixed.high, 3.0);
}

TEST(CrossFade, IdsAreThoseOfTheLargerShare) {
    const IdPixels fading_out{row_of<std::uint32_t>({5, 6}, 1)};
    const IdPixels fading_in{row_of<std::uint32_t>({7, 9}, 1)};
    const auto shown = [&](float weight) {
        return samples_of(std::get<IdPixels>(cross_fade(fading_out,
                                                        fading_in,
                                                        all_of(weight, fading_out.pixels),
                                                        Mixing::Values))
                              .pixels);
    };
    EXPECT_EQ(shown(0.49F), samples_of(fading_out.pixels));
    EXPECT_EQ(shown(0.51F), samples_of(fading_in.pixels));
}

std::vector<float> normal_of(double x_slope, double y_slope) {
    const double length = std::sqrt(1.0 + x_slope * x_slope + y_slope * y_slope);
    return {static_cast<float>(-x_slope / length),
            static_cast<float>(-y_slope / length),
            static_cast<float>(1.0 / length)};
}

// The slopes of the two surfaces are (2, 0) and (-1, 4). With the weight 1/4 of the second surface,
// the mean slope is (1.25, 1).
TEST(CrossFade, NormalsAreThoseOfMixedHeights) {
    const NumberPixels fading_out{row_of(normal_of(2.0, 0.0), 3), -1.0, 1.0};
    const NumberPixels fading_in{row_of(normal_of(-1.0, 4.0), 3), -1.0, 1.0};
    const auto mixed = samples_of(
        std::get<NumberPixels>(
            cross_fade(fading_out, fading_in, all_of(0.25F, fading_out.pixels), Mixing::Slopes))
            .pixels);
    const std::vector<float> expected = normal_of(1.25, 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(mixed[k], expected[k], 4 * std::numeric_limits<float>::epsilon()) << k;
    }
    EXPECT_EQ(find_map("normal").mixing, Mixing::Slopes);
}

}  // namespace
}  // namespace foam::texgen
