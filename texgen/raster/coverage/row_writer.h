// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/cache_line.h"
#include "texgen/raster/coverage/coverage.h"
#include "texgen/raster/simd/kernel.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace foam::texgen {

/// The number of bytes that paint_spans writes at once, and therefore an upper bound of the number
/// of bytes that it writes beyond the end of a row.
inline constexpr std::size_t kBlockBytes = 128;

/// Writes a row of pixels as spans of equal pixels. A pixel has 1, 2, 3, 4, 6 or 8 bytes. Span k
/// consists of the pixels [begins[k], begins[k + 1]). The word pixels[k] contains the bytes of each
/// pixel of the span: the byte that is first in memory is the lowest byte of the word. May write up
/// to kBlockBytes beyond the end of the row.
template <std::size_t PixelBytes>
void paint_spans(std::span<const std::uint16_t> begins,
                 const std::uint64_t* pixels,
                 std::uint8_t* row);

/// Converts the sums along a row to samples and writes them. to_samples(sums, pixels) must store
/// one pixel of `Channels` samples per sum, as EncodedMeans and StraightMeans do (pixel_means.h).
/// Buffers are reused between rows.
template <class Sums, std::size_t Channels, class Sample, class ToSamples>
class RowWriter {
  public:
    explicit RowWriter(const ToSamples& to_samples) : to_samples_(to_samples) {}

    /// Prefetches a row of the image. If this is done before the sums are computed, later stores do
    /// not stall on one cache miss after the other.
    void prefetch(std::span<const Sample> row) const {
        for (std::size_t k = 0; k < row.size(); k += kLineBytes / sizeof(Sample)) {
            __builtin_prefetch(&row[k], 1);
        }
    }

    /// Writes a row of `width` pixels to the start of `output`. May overwrite the rest of `output`,
    /// but nothing beyond its end. Rows that are stored in the rest of `output` must be written
    /// after this row.
    void write(const RowSums<typename Sums::Sum>& sums,
               std::size_t width,
               std::span<Sample> output) {
        grow(pixels_, sums.count);
        to_samples_(std::span(sums.sums).first(sums.count), pixels_.data());
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
    static constexpr std::size_t kPixelBytes = Channels * sizeof(Sample);

    ToSamples to_samples_;
    std::vector<std::uint64_t> pixels_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace foam::texgen
