#pragma once

#include "texgen/image/cache_line.h"
#include "texgen/raster/coverage.h"
#include "texgen/raster/paint_row.h"
#include "texgen/raster/simd/kernel.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace foam::texgen {

/// Turns the sums along a row into samples: to_samples(sums, words) writes the pixel of each sum,
/// of `Channels` samples. Keeps its memory from one row to the next.
template <class Sums, std::size_t Channels, class Sample, class ToSamples>
class RowWriter {
  public:
    RowWriter(const ToSamples& to_samples, Stores stores)
        : to_samples_(to_samples), stores_(stores) {}

    /// Has a row's memory fetched before it is written: stores would wait for it one by one.
    void fetch(std::span<const Sample> row) const {
        if (stores_ == Stores::Kept) {
            for (std::size_t k = 0; k < row.size(); k += kLineBytes / sizeof(Sample)) {
                __builtin_prefetch(&row[k], 1);
            }
        }
    }

    /// Writes a row of `width` pixels, of which `room` begins with: what is beyond may be written
    /// over.
    void write(const RowSums<typename Sums::Sum>& sums, std::size_t width, std::span<Sample> room) {
        grow(pixels_, sums.count + kPixelsBeyond);
        to_samples_(std::span(sums.sums).first(sums.count), pixels_.data());
        const Stretches<kPixelBytes> stretches{std::span(sums.flags).first(flag_words(width)),
                                               std::span(sums.begins).first(sums.count + 1),
                                               pixels_.data()};
        const std::size_t painted = painted_bytes(width, kPixelBytes);
        if (room.size_bytes() >= painted) {
            paint_row(stretches, stores_, reinterpret_cast<std::uint8_t*>(room.data()));
            return;
        }
        bytes_.resize(painted);
        paint_row(stretches, Stores::Kept, bytes_.data());
        std::memcpy(room.data(), bytes_.data(), width * kPixelBytes);
    }

    /// After the last row that other threads may then read.
    void finish() const {
        if (stores_ == Stores::Streamed) {
            finish_stores();
        }
    }

  private:
    static constexpr std::size_t kPixelBytes = Channels * sizeof(Sample);
    using Word = PixelWord<kPixelBytes>;

    ToSamples to_samples_;
    Stores stores_;
    std::vector<Word> pixels_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace foam::texgen
