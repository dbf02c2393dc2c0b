// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/paint_span.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <span>
#include <vector>

namespace foam::texgen {
namespace {

constexpr std::size_t kWidth = 300;

// A row of spans of random lengths and values.
template <std::size_t PixelBytes>
class Row {
  public:
    Row(std::mt19937_64& random, unsigned longest) {
        std::size_t next = 0;  // the start of the next span
        for (std::size_t x = 0; x < kWidth; ++x) {
            if (x == next) {
                begins_.push_back(static_cast<std::uint16_t>(x));
                pixels_.push_back(random() >> (64 - 8 * PixelBytes));
                next += 1 + random() % longest;
            }
            for (std::size_t k = 0; k < PixelBytes; ++k) {
                expected_.push_back(static_cast<std::uint8_t>(pixels_.back() >> 8 * k));
            }
        }
        begins_.push_back(kWidth);
    }

    // Paints the row into an array, `offset` bytes from its start. Expects that the bytes before
    // the row, and the bytes more than a block after the row, are unchanged.
    void expect_painted(std::size_t offset) const {
        std::vector<std::uint8_t> bytes(offset + expected_.size() + kBlockBytes + 1, kUntouched);
        at_simd_level([this, row = bytes.data() + offset] {
            for (std::size_t k = 0; k < pixels_.size(); ++k) {
                paint_span<PixelBytes>(begins_[k], begins_[k + 1], pixels_[k], row);
            }
        });
        const std::span<const std::uint8_t> all = bytes;
        EXPECT_TRUE(std::ranges::equal(all.subspan(offset, expected_.size()), expected_))
            << PixelBytes << " bytes";
        EXPECT_EQ(all.back(), kUntouched);
        EXPECT_EQ(std::ranges::count(all.first(offset), kUntouched),
                  static_cast<std::ptrdiff_t>(offset));
    }

  private:
    static constexpr std::uint8_t kUntouched = 0xA5;

    std::vector<std::uint16_t> begins_;
    std::vector<std::uint64_t> pixels_;
    std::vector<std::uint8_t> expected_;
};

// Tests spans of one pixel, of a few pixels, and of more than a block.
template <std::size_t PixelBytes>
void expect_painted() {
    at_every_simd_level([] {
        std::mt19937_64 random(5);
        for (const unsigned longest : {1U, 4U, 40U, 300U}) {
            for (int round = 0; round < 50; ++round) {
                const Row<PixelBytes> row(random, longest);
                row.expect_painted(0);
                row.expect_painted(1);
            }
        }
    });
}

TEST(PaintSpan, WritesEverySpan) {
    expect_painted<2>();
    expect_painted<4>();
    expect_painted<6>();
    expect_painted<8>();
}

TEST(PixelMeans, PackSamplesInTheOrderOfMemory) {
    const double unit = kPixelArea;
    EXPECT_EQ(RoundedMeans::pixel<3>({0x0201 * unit, 0x0403 * unit, 0x0605 * unit}),
              0x060504030201U);
}

TEST(PixelMeans, AreRounded) {
    for (int k = 0; k < 37; ++k) {
        const std::uint64_t pixel = RoundedMeans::pixel<3>(
            {750.25 * kPixelArea * k, 0.5 * kPixelArea, 65535 * kPixelArea, 0.0});
        EXPECT_EQ(pixel & 0xFFFF, std::lround(750.25 * k));
        EXPECT_EQ(pixel >> 16, 0xFFFF0001U);
    }
}

// The mean color 20000 at an opacity of 32768 of 65535 is the straight color 20000 / 32768 x 65535.
// All samples of a fully transparent pixel are 0. A color above its opacity is clamped.
TEST(PixelMeans, DivideColorsByOpacity) {
    const auto pixel = [](double color, double opacity) {
        return StraightMeans::pixel<2>({color * kPixelArea, opacity * kPixelArea});
    };
    EXPECT_EQ(pixel(20000, 32768), 39999U | 32768U << 16);
    EXPECT_EQ(pixel(5, 0), 0U);
    EXPECT_EQ(pixel(200, 100), 65535U | 100U << 16);
}

}  // namespace
}  // namespace foam::texgen
