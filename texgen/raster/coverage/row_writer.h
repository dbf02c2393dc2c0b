// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/cache_line.h"
#include "texgen/raster/coverage/coverage.h"
#include "texgen/raster/simd/kernel.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace foam::texgen {

/// The samples of a pixel.
template <std::size_t Channels>
using PixelSamples = std::array<std::uint16_t, Channels>;

/// Returns the samples of a pixel in one word. The byte that is first in the image is the lowest
/// byte of the word.
template <std::size_t Channels>
std::uint64_t packed(const PixelSamples<Channels>& samples);

/// Converts sums to pixels whose samples are the means of the values (mean_of). A call stores one
/// packed pixel per sum. Precondition: there is at least one sum. Buffers are reused between rows.
template <std::size_t Channels>
class RoundedMeans {
  public:
    void operator()(std::span<const PixelSums<Channels>> sums, std::uint64_t* pixels);

  private:
    std::vector<std::uint16_t> means_;
};

/// Converts sums of premultiplied colors to pixels of straight colors. The last channel is the
/// opacity; the other channels are divided by it. All samples of a pixel are 0 if the opacity is 0
/// or negative. A call stores one packed pixel per sum.
template <std::size_t Channels>
class StraightMeans {
  public:
    void operator()(std::span<const PixelSums<Channels>> sums, std::uint64_t* pixels) const;
};

/// The number of bytes that paint_spans writes at once, and therefore an upper bound of the number
/// of bytes that it writes beyond the end of a row.
inline constexpr std::size_t kBlockBytes = 128;

/// Writes a row of pixels as spans of equal pixels. A pixel has 2, 4, 6 or 8 bytes. Span k consists
/// of the pixels [begins[k], begins[k + 1]). The word pixels[k] contains the bytes of each pixel of
/// the span: the byte that is first in memory is the lowest byte of the word. May write up to
/// kBlockBytes beyond the end of the row.
template <std::size_t PixelBytes>
void paint_spans(std::span<const std::uint16_t> begins,
                 const std::uint64_t* pixels,
                 std::uint8_t* row);

/// Converts the sums along a row to samples and writes them. `ToPixels` is RoundedMeans or
/// StraightMeans. Buffers are reused between rows.
template <std::size_t Channels, class ToPixels>
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
        to_pixels_(std::span(sums.sums).first(sums.count), pixels_.data());
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
    static constexpr std::size_t kPixelBytes = sizeof(PixelSamples<Channels>);

    ToPixels to_pixels_;
    std::vector<std::uint64_t> pixels_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace foam::texgen
