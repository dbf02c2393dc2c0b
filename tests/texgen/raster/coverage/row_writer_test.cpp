// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/row_writer.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
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
        paint_spans<PixelBytes>(begins_, pixels_.data(), bytes.data() + offset);
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

TEST(PaintSpans, WritesEverySpan) {
    expect_painted<1>();
    expect_painted<2>();
    expect_painted<3>();
    expect_painted<4>();
    expect_painted<6>();
    expect_painted<8>();
}

// Writes the samples of two spans, once with room for a block after the row and once without.
TEST(RowWriter, WritesOnlyItsRow) {
    using Sums = SmallSums<1>;
    const auto to_samples = [](std::span<const Sums::Sum> sums, std::uint64_t* pixels) {
        for (std::size_t k = 0; k < sums.size(); ++k) {
            pixels[k] = sums[k][0];
        }
    };
    RowWriter<Sums, 1, std::uint8_t, decltype(to_samples)> writer(to_samples);
    RowSums<Sums::Sum> sums;
    sums.count = 2;
    sums.begins = {0, 3, 5};
    sums.sums = {{7}, {9}};
    for (const std::size_t size : {std::size_t{6}, 6 + kBlockBytes}) {
        std::vector<std::uint8_t> bytes(size, 1);
        writer.prefetch(std::span<const std::uint8_t>(bytes).first(5));
        writer.write(sums, 5, bytes);
        EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + 5),
                  (std::vector<std::uint8_t>{7, 7, 7, 9, 9}));
        EXPECT_TRUE(size > 6 || bytes.back() == 1);
    }
}

}  // namespace
}  // namespace foam::texgen
