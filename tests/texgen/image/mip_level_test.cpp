// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/mip_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace foam::texgen {
namespace {

Image<float> row_of(const std::vector<float>& values) {
    Image<float> image(static_cast<int>(values.size()), 1, 1);
    std::ranges::copy(values, image.samples().begin());
    return image;
}

std::vector<float> samples_of(const Image<float>& image) {
    return {image.samples().begin(), image.samples().end()};
}

double mean_of(const Image<float>& image) {
    const auto samples = image.samples();
    return std::accumulate(samples.begin(), samples.end(), 0.0) /
           static_cast<double>(samples.size());
}

TEST(MipLevel, EvenExtentsAreMeansOfPairs) {
    EXPECT_EQ(samples_of(mean_level(row_of({1, 3, 10, 20}).view(), 0)),
              (std::vector<float>{2, 15}));
}

// Five pixels become two, each of which covers two and a half pixels.
TEST(MipLevel, OddExtentsShareAPixel) {
    const auto level = samples_of(mean_level(row_of({1, 2, 4, 8, 16}).view(), 0));
    EXPECT_EQ(level, (std::vector<float>{(1 + 2 + 4 / 2.0F) / 2.5F, (4 / 2.0F + 8 + 16) / 2.5F}));
}

TEST(MipLevel, OneColumnStaysOne) {
    Image<float> column(1, 2, 1);
    column.row(0)[0] = 1.0F;
    column.row(1)[0] = 2.0F;
    EXPECT_EQ(samples_of(mean_level(column.view(), 0)), std::vector<float>{1.5F});
    EXPECT_EQ(samples_of(mean_level(row_of({7}).view(), 0)), std::vector<float>{7});
}

// All pixels have the same weight, also if the width or the height is odd. In this case, filters of
// 2 x 2 pixels would drop the last column or row.
TEST(MipLevel, TheMeanOfAllStays) {
    for (const auto& [width, height] : {std::pair(8, 4), std::pair(7, 5), std::pair(3, 11)}) {
        Image<float> image(width, height, 2);
        int k = 0;
        for (float& sample : image.samples()) {
            sample = static_cast<float>(k * k % 97);
            ++k;
        }
        Image<float> alone(width, height, 1);
        for (std::size_t i = 0; i < alone.samples().size(); ++i) {
            alone.samples()[i] = image.samples()[2 * i + 1];
        }
        EXPECT_NEAR(mean_of(mean_level(image.view(), 1)), mean_of(alone), 1e-5);
    }
}

// If the picture is shifted around the torus by two pixels, its level is shifted by one. A picture
// that tiles therefore has a level that tiles.
TEST(MipLevel, ShiftsAroundTheTorus) {
    const std::vector<float> values = {1, 5, 2, 9, 4, 4, 8, 0};
    std::vector<float> shifted = values;
    std::rotate(shifted.begin(), shifted.begin() + 2, shifted.end());
    std::vector<float> level = samples_of(mean_level(row_of(values).view(), 0));
    std::rotate(level.begin(), level.begin() + 1, level.end());
    EXPECT_EQ(samples_of(mean_level(row_of(shifted).view(), 0)), level);
}

// Products of two indices of pixels exceed 32 bits.
TEST(MipLevel, LongRowsDoNotOverflow) {
    const int width = 200'001;
    Image<float> row(width, 1, 1);
    std::ranges::fill(row.samples(), 3.0F);
    EXPECT_EQ(samples_of(mean_level(row.view(), 0)),
              std::vector<float>(static_cast<std::size_t>(width / 2), 3.0F));
    Image<std::uint32_t> ids(width, 1, 1);
    std::iota(ids.samples().begin(), ids.samples().end(), 0U);
    const Image<std::uint32_t> level = central_level(ids.view(), 0);
    EXPECT_EQ(level.samples().front(), 1U);
    EXPECT_EQ(level.samples().back(), static_cast<std::uint32_t>(width - 2));
}

TEST(MipLevel, IntegersAreChosen) {
    Image<std::uint32_t> ids(5, 2, 1);
    std::iota(ids.samples().begin(), ids.samples().end(), 4'000'000'000U);
    const Image<std::uint32_t> level = central_level(ids.view(), 0);
    ASSERT_EQ(level.width(), 2);
    ASSERT_EQ(level.height(), 1);
    // A pixel of the level covers 2.5 x 2 pixels. The middles of the two areas are at x = 1.25 and
    // 3.75, in row 1.
    EXPECT_EQ(level.row(0)[0], ids.row(1)[1]);
    EXPECT_EQ(level.row(0)[1], ids.row(1)[3]);
}

}  // namespace
}  // namespace foam::texgen
