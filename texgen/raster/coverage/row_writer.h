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

/// The number of bytes that paint_spans may write beyond the end of a row.
inline constexpr std::size_t kBlockBytes = 128;

/// Writes a row of pixels of 1, 2, 3, 4, 6 or 8 bytes as spans of equal pixels. Span k covers the
/// pixels [begins[k], begins[k + 1]), and pixels[k] contains the bytes of each pixel: the first
/// byte in memory is the lowest one. May write up to kBlockBytes beyond the end of the row.
template <std::size_t PixelBytes>
void paint_spans(std::span<const std::uint16_t> begins,
                 const std::uint64_t* pixels,
                 std::uint8_t* row);

/// Converts the sums along a row into samples and writes them. to_samples(sums, pixels) computes
/// one pixel of `Channels` samples from each sum. Buffers are reused between rows.
template <class Sums, std::size_t Channels, class Sample, class ToSamples>
class RowWriter {
  public:
    explicit RowWriter(const ToSamples& to_samples) : to_samples_(to_samples) {}

    /// Prefetches a row before its sums are computed. Without it, stores stall on the cache misses
    /// one after the other.
    void prefetch(std::span<const Sample> row) const {
        for (std::size_t k = 0; k < row.size(); k += kLineBytes / sizeof(Sample)) {
            __builtin_prefetch(&row[k], 1);
        }
    }

    /// Writes a row of `width` pixels to the start of `output`. The rest of `output` may be
    /// overwritten.
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
