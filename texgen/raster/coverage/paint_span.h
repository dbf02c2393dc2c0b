// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/coverage/coverage.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace foam::texgen {

static_assert(std::endian::native == std::endian::little,
              "the first sample of a pixel is in the lowest bits of a word");

/// The 16-bit samples of a pixel. std::bit_cast converts them to one word of 64 bits, with the
/// first sample in the lowest bits. Unused samples are 0.
using PackedPixel = std::array<std::uint16_t, 4>;

/// Converts the sums of a pixel to the means of the values (mean_of).
struct RoundedMeans {
    template <std::size_t Channels>
    [[gnu::always_inline]] static std::uint64_t pixel(const PixelSums<Channels>& sums) {
        PackedPixel pixel{};
        for (std::size_t c = 0; c < sums.size(); ++c) {
            pixel[c] = mean_of(sums[c]);
        }
        return std::bit_cast<std::uint64_t>(pixel);
    }
};

/// Converts sums of premultiplied colors to a straight color. The last channel is the opacity; the
/// other channels are divided by it. All samples are 0 if the opacity is 0 or negative.
struct StraightMeans {
    template <std::size_t Channels>
    [[gnu::always_inline]] static std::uint64_t pixel(const PixelSums<Channels>& sums) {
        const auto opacity = static_cast<std::int64_t>(sums[Channels - 1]);
        if (opacity <= 0) {
            return 0;
        }
        PackedPixel pixel{};
        for (std::size_t c = 0; c + 1 < Channels; ++c) {
            const auto whole = static_cast<std::int64_t>(sums[c]);
            const std::int64_t color = (whole * kMaxMean + opacity / 2) / opacity;
            pixel[c] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(color, 0, kMaxMean));
        }
        pixel[Channels - 1] = mean_of(sums[Channels - 1]);
        return std::bit_cast<std::uint64_t>(pixel);
    }
};

/// The number of bytes that paint_span writes at once. It is an upper bound of the number of bytes
/// that paint_span writes beyond the end of a span.
inline constexpr std::size_t kBlockBytes = 128;

/// Stores a block of equal pixels. The size of a pixel is 2, 4, 6 or 8 bytes. A pixel of 6 bytes is
/// a pattern by itself; any other pixel is repeated until it fills a pattern of 8 bytes. A block is
/// written in words of 8 bytes. With pixels of 2, 4 or 8 bytes, each word is the pattern. With
/// pixels of 6 bytes, a word starts at byte 0, 2 or 4 of the pattern, and is composed of two
/// shifted copies of the pattern.
template <std::size_t PixelBytes>
[[gnu::always_inline]] inline void store_block(std::uint64_t pixel, std::uint8_t* to) {
    constexpr std::size_t kPatternBytes = PixelBytes == 6 ? 6 : 8;
    for (std::size_t bytes = PixelBytes; bytes < kPatternBytes; bytes *= 2) {
        pixel |= pixel << 8 * bytes;
    }
#pragma GCC unroll 1  // GCC would not vectorize the unrolled loop
    for (std::size_t k = 0; k < kBlockBytes / sizeof(pixel); ++k) {
        const std::size_t skipped_bits = 8 * (8 * k % kPatternBytes);
        const std::uint64_t word =
            pixel >> skipped_bits | pixel << (8 * kPatternBytes - skipped_bits) % 64;
        std::memcpy(to + k * sizeof(word), &word, sizeof(word));
    }
}

/// Writes the pixels [begin, end) of a row. `row` points to the first pixel of the row. A pixel
/// consists of the lowest PixelBytes (2, 4, 6 or 8) bytes of `pixel`, which are written from the
/// lowest to the highest. The other bytes of `pixel` must be 0. Writes whole blocks, up to
/// kBlockBytes beyond the end of the span. Precondition: there is memory for these bytes. If the
/// spans of a row are written from left to right, each span overwrites the bytes that the span
/// before it wrote beyond its end. Most spans are shorter than a block.
template <std::size_t PixelBytes>
[[gnu::always_inline]] inline void paint_span(std::size_t begin,
                                              std::size_t end,
                                              std::uint64_t pixel,
                                              std::uint8_t* row) {
    for (std::size_t x = begin; x < end; x += kBlockBytes / PixelBytes) {
        store_block<PixelBytes>(pixel, row + x * PixelBytes);
    }
}

}  // namespace foam::texgen
