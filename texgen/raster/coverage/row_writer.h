// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/cache_line.h"
#include "texgen/raster/coverage/coverage.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace foam::texgen {

static_assert(std::endian::native == std::endian::little,
              "the first sample of a pixel is in the lowest bits of a word");

/// The 16-bit samples of a pixel in one word, the first sample in the lowest bits.
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
    static std::uint64_t pixel(const PixelSums<Channels>& sums) {
        const auto opacity = static_cast<std::int64_t>(sums[Channels - 1]);
        if (opacity <= 0) {
            return 0;
        }
        PackedPixel pixel{};
        for (std::size_t c = 0; c + 1 < Channels; ++c) {
            const auto whole = static_cast<std::int64_t>(sums[c]);
            const std::int64_t color = (whole * kLargestMean + opacity / 2) / opacity;
            pixel[c] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(color, 0, kLargestMean));
        }
        pixel[Channels - 1] = mean_of(sums[Channels - 1]);
        return std::bit_cast<std::uint64_t>(pixel);
    }
};

/// The number of bytes that paint_spans writes at once, and therefore an upper bound of the number
/// of bytes that it writes beyond the end of a row.
inline constexpr std::size_t kBlockBytes = 128;

/// Stores a block of equal pixels of 2, 4, 6 or 8 bytes. A pixel is repeated until it fills a
/// pattern of 8 bytes; a pixel of 6 bytes is a pattern by itself. The words of a block of such
/// pixels start at different bytes of the pattern, so that each word is composed of two shifted
/// copies of the pattern.
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

/// Writes a row of pixels as spans of equal pixels. A pixel has 2, 4, 6 or 8 bytes. Span k consists
/// of the pixels [begins[k], begins[k + 1]). The word pixels[k] contains the bytes of each pixel of
/// the span, the first one lowest. Spans are written in whole blocks, up to kBlockBytes beyond the
/// end of the row. Most spans are shorter than a block; the next span overwrites the excess.
template <std::size_t PixelBytes>
void paint_spans(std::span<const std::uint16_t> begins,
                 const std::uint64_t* pixels,
                 std::uint8_t* row) {
    at_simd_level([=] {
        constexpr std::size_t kPixels = kBlockBytes / PixelBytes;
        for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
            const std::size_t end = begins[k + 1];
            for (std::size_t x = begins[k]; x < end; x += kPixels) {
                store_block<PixelBytes>(pixels[k], row + x * PixelBytes);
            }
        }
    });
}

/// Converts the sums along a row to samples and writes them. `ToPixel` is RoundedMeans or
/// StraightMeans. Buffers are reused between rows.
template <std::size_t Channels, class ToPixel>
class RowWriter {
  public:
    /// Prefetches a row of the image. If this is done before the sums are computed, later stores do
    /// not stall on one cache miss after the other.
    void prefetch(std::span<const std::uint16_t> row) const {
        for (std::size_t k = 0; k < row.size(); k += kLineBytes / sizeof(row[k])) {
            __builtin_prefetch(&row[k], 1);
        }
    }

    /// Writes a row of `width` pixels to the start of `output`. May overwrite the rest of `output`,
    /// but nothing beyond its end. Rows that are stored in the rest of `output` must be written
    /// after this row.
    void write(const RowSums<Channels>& sums, std::size_t width, std::span<std::uint16_t> output) {
        grow(pixels_, sums.count);
        at_simd_level([from = sums.sums.data(), count = sums.count, to = pixels_.data()] {
            for (std::size_t k = 0; k < count; ++k) {
                to[k] = ToPixel::template pixel<Channels>(from[k]);
            }
        });
        constexpr std::size_t kPixelBytes = Channels * sizeof(output[0]);
        const auto begins = std::span(sums.begins).first(sums.count + 1);
        if (output.size_bytes() >= width * kPixelBytes + kBlockBytes) {
            paint_spans<kPixelBytes>(
                begins, pixels_.data(), reinterpret_cast<std::uint8_t*>(output.data()));
            return;
        }
        grow(bytes_, width * kPixelBytes + kBlockBytes);
        paint_spans<kPixelBytes>(begins, pixels_.data(), bytes_.data());
        std::memcpy(output.data(), bytes_.data(), width * kPixelBytes);
    }

  private:
    std::vector<std::uint64_t> pixels_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace foam::texgen
