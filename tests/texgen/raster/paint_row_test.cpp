#include "texgen/raster/paint_row.h"

#include "texgen/image/image.h"
#include "texgen/raster/paint_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

namespace foam::texgen {
namespace {

constexpr std::size_t kWidth = 300;  // not of whole words of flags

// A row of stretches, and what is around it.
template <std::size_t PixelBytes>
class Row {
  public:
    Row(std::mt19937_64& random, unsigned longest) : flags_(flag_words(kWidth)) {
        std::size_t next = 0;  // where the next stretch begins
        PixelWord<PixelBytes> pixel{};
        for (std::size_t x = 0; x < kWidth; ++x) {
            if (x == next) {
                begins_.push_back(static_cast<std::uint16_t>(x));
                flags_[x / kFlagsPerWord] |= std::uint64_t{1} << x % kFlagsPerWord;
                pixel = static_cast<PixelWord<PixelBytes>>(random() >> (64 - 8 * PixelBytes));
                pixels_.push_back(pixel);
                next += 1 + random() % longest;
            }
            for (std::size_t k = 0; k < PixelBytes; ++k) {
                expected_.push_back(static_cast<std::uint8_t>(pixel >> 8 * k));
            }
        }
        begins_.push_back(kWidth);
        pixels_.resize(pixels_.size() + kPixelsBeyond);
    }

    std::size_t bytes() const { return expected_.size(); }
    std::size_t painted() const { return painted_bytes(kWidth, PixelBytes); }
    Stretches<PixelBytes> stretches() const { return {flags_, begins_, pixels_.data()}; }

    // paint(bytes) writes the row, and at most so many bytes; it begins `offset` bytes after a line
    // of a cache.
    template <class Paint>
    void expect_painted_by(const Paint& paint, std::size_t painted, std::size_t offset) const {
        Image<std::uint8_t> bytes(static_cast<int>(offset + painted) + 1, 1, 1);
        std::ranges::fill(bytes.samples(), kUntouched);
        paint(bytes.samples().data() + offset);
        const std::span<const std::uint8_t> all = bytes.samples();
        EXPECT_TRUE(std::ranges::equal(all.subspan(offset, expected_.size()), expected_))
            << PixelBytes << " bytes";
        EXPECT_EQ(all.back(), kUntouched);
        EXPECT_EQ(std::ranges::count(all.first(offset), kUntouched),
                  static_cast<std::ptrdiff_t>(offset));
    }

  private:
    static constexpr std::uint8_t kUntouched = 0xA5;

    std::vector<std::uint64_t> flags_;
    std::vector<std::uint16_t> begins_;
    std::vector<PixelWord<PixelBytes>> pixels_;
    std::vector<std::uint8_t> expected_;
};

// Stretches of one pixel each, of a few, and of more than a word of flags.
template <std::size_t PixelBytes>
void expect_painted() {
    std::mt19937_64 random(5);
    for (const unsigned longest : {1U, 4U, 40U, 300U}) {
        for (int round = 0; round < 50; ++round) {
            const Row<PixelBytes> row(random, longest);
            const auto all = row.stretches();
            const auto blocks = [&](std::uint8_t* to) { paint_blocks(all, to); };
            const auto kept = [&](std::uint8_t* to) { paint_row(all, Stores::Kept, to); };
            for (const std::size_t offset : {0UL, 1UL, 48UL}) {
                row.expect_painted_by(blocks, row.bytes() + kBlockBytes, offset);
                row.expect_painted_by(kept, row.painted(), offset);
            }
        }
    }
}

TEST(PaintRow, WritesEveryStretch) {
    expect_painted<1>();
    expect_painted<2>();
    expect_painted<3>();
    expect_painted<4>();
    expect_painted<6>();
    expect_painted<8>();
}

// As caches keep nothing of them, rows of large images are stored past those, where that is known
// to work: whole lines, from a line on.
TEST(PaintRow, StreamsLargeImages) {
    const Image<std::uint8_t> image(4096, 1, 3);
    constexpr std::size_t kRowBytes = std::size_t{3} * 4096;
    const Stores large = stores_for(image.samples().data(), kRowBytes, 4096);
    EXPECT_EQ(stores_for(image.samples().data(), kRowBytes, 16), Stores::Kept);
    EXPECT_EQ(stores_for(image.samples().data() + 3, kRowBytes, 4096), Stores::Kept);
    EXPECT_EQ(stores_for(image.samples().data(), kRowBytes + 3, 4096), Stores::Kept);
    std::mt19937_64 random(6);
    for (int round = 0; round < 50; ++round) {
        const Row<3> row(random, 30);
        const auto streamed = [&](std::uint8_t* to) {
            paint_row(row.stretches(), large, to);
            finish_stores();
        };
        row.expect_painted_by(streamed, row.painted(), 0);
    }
}

}  // namespace
}  // namespace foam::texgen
