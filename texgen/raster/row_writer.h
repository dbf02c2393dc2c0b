#pragma once

#include "texgen/raster/coverage.h"
#include "texgen/raster/make_room.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace foam::texgen {

/// Holds a pixel of so many bytes, in the order of memory, the first in the lowest bits.
template <std::size_t PixelBytes>
using PixelWord = std::conditional_t<PixelBytes <= 4, std::uint32_t, std::uint64_t>;

/// A row in stretches of pixels of one value: each from where it begins to where the next one does.
template <std::size_t PixelBytes>
struct Stretches {
    std::size_t count = 0;
    const std::uint32_t* begins = nullptr;  // one more than stretches: the last is the row's end
    const PixelWord<PixelBytes>* pixels = nullptr;
};

/// By how many bytes paint_row may write beyond the end of a row.
inline constexpr std::size_t kPaintedBeyond = 128;

/// Writes a row of pixels, of 1, 2, 3, 4, 6 or 8 bytes.
void paint_row(const Stretches<1>& stretches, std::uint8_t* row);
void paint_row(const Stretches<2>& stretches, std::uint8_t* row);
void paint_row(const Stretches<3>& stretches, std::uint8_t* row);
void paint_row(const Stretches<4>& stretches, std::uint8_t* row);
void paint_row(const Stretches<6>& stretches, std::uint8_t* row);
void paint_row(const Stretches<8>& stretches, std::uint8_t* row);

/// Turns the sums along a row into samples: to_samples(sums, put) calls put(k, samples) with those
/// of each sum, of which there are `Channels`. Keeps its memory from one row to the next.
template <class Sums, std::size_t Channels, class Sample, class ToSamples>
class RowWriter {
  public:
    explicit RowWriter(const ToSamples& to_samples) : to_samples_(to_samples) {}

    /// Has a row's memory fetched before it is written: stores would wait for it one by one.
    static void fetch(std::span<const Sample> row) {
        constexpr std::size_t kLineBytes = 64;
        for (std::size_t k = 0; k < row.size(); k += kLineBytes / sizeof(Sample)) {
            __builtin_prefetch(&row[k], 1);
        }
    }

    /// Writes a row of `width` pixels, of which `room` begins with: what is beyond may be written
    /// over.
    void write(RowSums<typename Sums::Sum>& sums, std::size_t width, std::span<Sample> room) {
        make_room(pixels_, sums.count);
        to_samples_(std::span<const typename Sums::Sum>(sums.sums).first(sums.count),
                    pixels_.data());
        sums.begins[sums.count] = static_cast<std::uint32_t>(width);
        const Stretches<kPixelBytes> stretches{sums.count, sums.begins.data(), pixels_.data()};
        const std::size_t row_bytes = width * kPixelBytes;
        if (room.size_bytes() >= row_bytes + kPaintedBeyond) {
            paint_row(stretches, reinterpret_cast<std::uint8_t*>(room.data()));
            return;
        }
        bytes_.resize(row_bytes + kPaintedBeyond);
        paint_row(stretches, bytes_.data());
        std::memcpy(room.data(), bytes_.data(), row_bytes);
    }

  private:
    static constexpr std::size_t kPixelBytes = Channels * sizeof(Sample);
    using Word = PixelWord<kPixelBytes>;

    ToSamples to_samples_;
    std::vector<Word> pixels_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace foam::texgen
