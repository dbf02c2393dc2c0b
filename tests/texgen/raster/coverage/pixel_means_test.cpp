// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/pixel_means.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

template <class Sums>
typename Sums::Sum sums_of(std::int32_t base, std::int32_t other, double part) {
    typename Sums::Sum sum{Sums::start(base)};
    const auto area = static_cast<std::int32_t>(part * (1 << kAreaBits));
    sum[0] += Sums::of_area(area) * Sums::of_value(other - base);
    return sum;
}

template <class Sums>
void expect_means() {
    const auto add_one = [](std::uint16_t mean) { return static_cast<std::uint16_t>(mean + 1); };
    std::vector<typename Sums::Sum> sums;
    for (int k = 0; k < 37; ++k) {
        sums.push_back(sums_of<Sums>(1000 * k, 20000, 0.25));
    }
    EncodedMeans<1, Sums, decltype(add_one)> means(add_one);
    std::vector<std::uint64_t> pixels(sums.size());
    means(sums, pixels.data());
    for (std::size_t k = 0; k < sums.size(); ++k) {
        EXPECT_EQ(pixels[k], 750 * k + 5000 + 1);
    }
}

// The 37 sums are several vectors and a remainder.
TEST(PixelMeans, AreEncoded) {
    at_every_simd_level([] {
        expect_means<ExactSums<1>>();
        expect_means<SmallSums<1>>();
    });
}

TEST(PixelMeans, PackSamplesInTheOrderOfMemory) {
    EXPECT_EQ(packed(std::array<std::uint8_t, 3>{1, 2, 3}), 0x030201U);
}

// The mean color 20000 at an opacity of 32768 of 65535 is the straight color 20000 / 32768 x 65535.
// All samples of a fully transparent pixel are 0. A color above its opacity is clamped.
TEST(PixelMeans, DivideColorsByOpacity) {
    using Sums = ExactSums<2>;
    const StraightMeans<2> means;
    const auto pixel = [&](double color, double opacity) {
        const std::array<Sums::Sum, 1> sums{{{color * Sums::kPixel, opacity * Sums::kPixel}}};
        std::uint64_t packed_pixel = 0;
        means(sums, &packed_pixel);
        return packed_pixel;
    };
    EXPECT_EQ(pixel(20000, 32768), packed(std::array<std::uint16_t, 2>{39999, 32768}));
    EXPECT_EQ(pixel(5, 0), 0U);
    EXPECT_EQ(pixel(200, 100), packed(std::array<std::uint16_t, 2>{65535, 100}));
}

}  // namespace
}  // namespace foam::texgen
