// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/pixel_format.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(PixelFormat, IsFoundByItsNumbers) {
    for (int k = 0; k <= static_cast<int>(PixelFormat::Bc7Srgb); ++k) {
        const auto format = static_cast<PixelFormat>(k);
        EXPECT_EQ(facts_of(format).format, format);
        EXPECT_EQ(find_dxgi_format(facts_of(format).dxgi), format);
        EXPECT_EQ(find_vulkan_format(facts_of(format).vulkan), format);
    }
    EXPECT_FALSE(find_dxgi_format(0));
    EXPECT_FALSE(find_vulkan_format(0));
}

// A block covers 4 x 4 texels, so 5 x 3 texels are two blocks.
TEST(PixelFormat, BlocksCoverPartsOfAnImage) {
    EXPECT_EQ(image_bytes(PixelFormat::Bc7, 5, 3), 32U);
    EXPECT_EQ(image_bytes(PixelFormat::Bc4, 1, 1), 8U);
    EXPECT_EQ(image_bytes(PixelFormat::Rgba8, 5, 3), 60U);
    EXPECT_EQ(image_bytes(PixelFormat::Rg16, 5, 3), 60U);
}

TEST(PixelFormat, LevelsEndWithOnePixel) {
    EXPECT_EQ(full_level_count(1, 1), 1);
    EXPECT_EQ(full_level_count(8, 2), 4);
    EXPECT_EQ(full_level_count(9, 9), 4);
    EXPECT_EQ(level_extent(9, 1), 4);
    EXPECT_EQ(level_extent(9, 3), 1);
    EXPECT_EQ(level_extent(2, 3), 1);
}

}  // namespace
}  // namespace foam::texgen
