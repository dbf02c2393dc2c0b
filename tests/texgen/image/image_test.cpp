// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/image.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

namespace foam::texgen {
namespace {

TEST(Image, StartsAtZeroWithTheExtentsAskedFor) {
    const Image<std::uint8_t> image(3, 2, 4);
    EXPECT_EQ(image.width(), 3);
    EXPECT_EQ(image.height(), 2);
    EXPECT_EQ(image.channels(), 4);
    ASSERT_EQ(image.samples().size(), 24U);
    for (const std::uint8_t sample : image.samples()) {
        EXPECT_EQ(sample, 0);
    }
}

TEST(Image, RowsAndPixelsAreInterleaved) {
    Image<int> image(3, 2, 2);
    image.row(1)[5] = 7;  // row 1, pixel 2, channel 1
    EXPECT_EQ(image.pixel(2, 1)[1], 7);
    EXPECT_EQ(image.samples()[11], 7);
}

TEST(Image, AViewWritesThroughAndReadsAsConst) {
    Image<int> image(2, 2, 1);
    image.view().row(0)[1] = 5;
    const ImageView<const int> reading = image.view();
    EXPECT_EQ(reading.row(0)[1], 5);
    EXPECT_EQ(reading.data(), image.samples().data());
}

TEST(Image, RejectsEmptyExtents) {
    EXPECT_THROW(Image<int>(0, 1, 1), std::invalid_argument);
    EXPECT_THROW(Image<int>(1, -1, 1), std::invalid_argument);
    EXPECT_THROW(Image<int>(1, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
