// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/place_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

template <class Sample>
Image<Sample> numbered(int width, int height, int channels, int first) {
    Image<Sample> image(width, height, channels);
    for (Sample& sample : image.samples()) {
        sample = static_cast<Sample>(first++);
    }
    return image;
}

template <class Sample>
std::vector<Sample> row(const Image<Sample>& image, int y) {
    return {image.row(y).begin(), image.row(y).end()};
}

// Two frames of 2 x 2 pixels are in one column. Row 0 is the bottom row, so the first frame is in
// the upper half:
//
//     3 4      7 8
//     1 2      5 6
TEST(PlaceFrame, OrdersRowsFromTopToBottom) {
    const SheetLayout layout{.frames = 2, .frame_width = 2, .frame_height = 2, .columns = 1};
    Image<std::uint8_t> sheet(2, 4, 1);
    for (int k = 0; k < 2; ++k) {
        const auto frame = numbered<std::uint8_t>(2, 2, 1, 1 + 4 * k);
        place_frame(sheet.view(), layout, k, frame.view(), Gutter::Periodic);
    }
    EXPECT_EQ(row(sheet, 3), (std::vector<std::uint8_t>{3, 4}));
    EXPECT_EQ(row(sheet, 2), (std::vector<std::uint8_t>{1, 2}));
    EXPECT_EQ(row(sheet, 1), (std::vector<std::uint8_t>{7, 8}));
    EXPECT_EQ(row(sheet, 0), (std::vector<std::uint8_t>{5, 6}));
}

// The frame is in the second of two columns. The first column is unchanged.
TEST(PlaceFrame, FillsGuttersWithTheOtherSide) {
    const SheetLayout layout{
        .frames = 2, .frame_width = 3, .frame_height = 2, .columns = 2, .gutter = 1};
    Image<float> sheet(10, 4, 1);
    const auto frame = numbered<float>(3, 2, 1, 1);
    place_frame(sheet.view(), layout, 1, frame.view(), Gutter::Periodic);
    EXPECT_EQ(row(sheet, 3), (std::vector<float>{0, 0, 0, 0, 0, 3, 1, 2, 3, 1}));
    EXPECT_EQ(row(sheet, 2), (std::vector<float>{0, 0, 0, 0, 0, 6, 4, 5, 6, 4}));
    EXPECT_EQ(row(sheet, 1), (std::vector<float>{0, 0, 0, 0, 0, 3, 1, 2, 3, 1}));
    EXPECT_EQ(row(sheet, 0), (std::vector<float>{0, 0, 0, 0, 0, 6, 4, 5, 6, 4}));
}

TEST(PlaceFrame, FillsGuttersWithTheEdge) {
    const SheetLayout layout{.frame_width = 2, .frame_height = 2, .gutter = 1};
    Image<std::uint32_t> sheet(4, 4, 1);
    const auto frame = numbered<std::uint32_t>(2, 2, 1, 1);
    place_frame(sheet.view(), layout, 0, frame.view(), Gutter::Edge);
    EXPECT_EQ(row(sheet, 3), (std::vector<std::uint32_t>{3, 3, 4, 4}));
    EXPECT_EQ(row(sheet, 2), (std::vector<std::uint32_t>{3, 3, 4, 4}));
    EXPECT_EQ(row(sheet, 1), (std::vector<std::uint32_t>{1, 1, 2, 2}));
    EXPECT_EQ(row(sheet, 0), (std::vector<std::uint32_t>{1, 1, 2, 2}));
}

// A gutter may be wider than its frame.
TEST(PlaceFrame, WrapsAsOftenAsNeeded) {
    constexpr int kGutter = 7;
    const SheetLayout layout{.frame_width = 3, .frame_height = 2, .gutter = kGutter};
    Image<std::uint16_t> sheet(17, 16, 3);
    const auto frame = numbered<std::uint16_t>(3, 2, 3, 1000);
    place_frame(sheet.view(), layout, 0, frame.view(), Gutter::Periodic);
    for (int y = 0; y < sheet.height(); ++y) {
        for (int x = 0; x < sheet.width(); ++x) {
            const auto expected = frame.pixel((x - kGutter + 9) % 3, (y - kGutter + 8) % 2);
            EXPECT_TRUE(std::ranges::equal(sheet.pixel(x, y), expected)) << x << " " << y;
        }
    }
}

}  // namespace
}  // namespace foam::texgen
