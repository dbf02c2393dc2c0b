// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png_filter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace foam::texgen {
namespace {

std::vector<int> numbers(std::span<const std::byte> bytes) {
    std::vector<int> all;
    for (const std::byte byte : bytes) {
        all.push_back(std::to_integer<int>(byte));
    }
    return all;
}

/// Returns a picture of 2 x 2 gray pixels: 10 and 20 in the top row, 30 and 25 in the bottom row.
Image<std::uint8_t> four() {
    Image<std::uint8_t> image(2, 2, 1);
    image.row(1)[0] = 10;
    image.row(1)[1] = 20;
    image.row(0)[0] = 30;
    image.row(0)[1] = 25;
    return image;
}

std::vector<int> filtered(PngFilter filter, int first, int last) {
    const Image<std::uint8_t> image = four();
    RowFilter filters;
    return numbers(filters.filter(PngRows(image.view()), filter, first, last));
}

// Computed by hand from section 9 of the PNG specification. Bytes to the left of the picture or
// above it count as 0. Differences are modulo 256. For the pixel 25, Paeth computes left + above -
// above left = 30 + 20 - 10 = 40. The left pixel, 30, is the nearest to it.
TEST(PngFilter, PredictsAsThePngStandard) {
    EXPECT_EQ(filtered(PngFilter::None, 0, 2), (std::vector<int>{0, 10, 20, 0, 30, 25}));
    EXPECT_EQ(filtered(PngFilter::Sub, 0, 2), (std::vector<int>{1, 10, 10, 1, 30, 251}));
    EXPECT_EQ(filtered(PngFilter::Up, 0, 2), (std::vector<int>{2, 10, 20, 2, 20, 5}));
    EXPECT_EQ(filtered(PngFilter::Average, 0, 2), (std::vector<int>{3, 10, 15, 3, 25, 0}));
    EXPECT_EQ(filtered(PngFilter::Paeth, 0, 2), (std::vector<int>{4, 10, 10, 4, 20, 251}));
}

TEST(PngFilter, RowsOfALaterPartKnowTheOneAbove) {
    EXPECT_EQ(filtered(PngFilter::Up, 1, 2), (std::vector<int>{2, 20, 5}));
    EXPECT_EQ(filtered(PngFilter::Paeth, 1, 2), (std::vector<int>{4, 20, 251}));
}

TEST(PngFilter, SixteenBitsAreTwoBytesTheHighOneFirst) {
    Image<std::uint16_t> image(2, 1, 1);
    image.row(0)[0] = 0x0102;
    image.row(0)[1] = 0x0405;
    RowFilter filters;
    const auto rows = filters.filter(PngRows(image.view()), PngFilter::Sub, 0, 1);
    EXPECT_EQ(numbers(rows), (std::vector<int>{1, 1, 2, 3, 3}));
}

/// Returns the byte at x in row y, or 0 to the left of the row or above the picture.
int byte_at(const std::vector<std::vector<int>>& rows, int y, int x) {
    return y < 0 || x < 0 ? 0 : rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
}

// Returns the value that a filter predicts for a byte.
int predicted(int filter, int left, int above, int above_left) {
    const int guess = left + above - above_left;
    switch (filter) {
        case 0:
            return 0;
        case 1:
            return left;
        case 2:
            return above;
        case 3:
            return (left + above) / 2;
        default:
            break;
    }
    int best = left;
    best = std::abs(guess - above) < std::abs(guess - best) ? above : best;
    return std::abs(guess - above_left) < std::abs(guess - best) ? above_left : best;
}

// The inverse of every filter, applied byte by byte as the specification defines it, restores the
// rows.
RC_GTEST_PROP(PngFilter, IsUndoneFromLeftToRight, ()) {
    const int channels = *rc::gen::inRange(1, 5);
    Image<std::uint8_t> image(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 5), channels);
    for (std::uint8_t& sample : image.samples()) {
        sample = *rc::gen::arbitrary<std::uint8_t>();
    }
    const int filter = *rc::gen::inRange(0, 5);
    RowFilter filters;
    const auto stream = numbers(
        filters.filter(PngRows(image.view()), static_cast<PngFilter>(filter), 0, image.height()));
    const int width = image.width() * channels;
    std::size_t at = 0;
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        ++at;  // skips the byte of the filter type
        for (int x = 0; x < width; ++x) {
            const int guess = predicted(filter,
                                        byte_at(rows, y, x - channels),
                                        byte_at(rows, y - 1, x),
                                        byte_at(rows, y - 1, x - channels));
            rows[static_cast<std::size_t>(y)].push_back((stream[at++] + guess) % 256);
        }
        const auto expected = image.row(image.height() - 1 - y);
        RC_ASSERT(std::equal(
            expected.begin(), expected.end(), rows[static_cast<std::size_t>(y)].begin()));
    }
}

}  // namespace
}  // namespace foam::texgen
