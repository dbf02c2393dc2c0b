#pragma once

#include "texgen/raster/coverage.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace foam::texgen {

/// What Coverage counts for a value of 1 that covers a pixel.
inline constexpr double kFullCoverage = std::int64_t{1} << kCoverageBits;

/// Sums of 16-bit values as the nearest means. Arcs of an invalid foam may overlap: a mean may then
/// lie out of range, and is held there.
template <std::size_t Lanes>
std::array<std::int32_t, Lanes> rounded_means(const std::array<double, Lanes>& sum) {
    constexpr std::int32_t kLargest = std::numeric_limits<std::uint16_t>::max();
    constexpr double kHalf = 0.5;  // makes truncation the nearest
    std::array<std::int32_t, Lanes> means{};
    for (std::size_t c = 0; c < Lanes; ++c) {
        means[c] = static_cast<std::int32_t>(sum[c] * (1.0 / kFullCoverage) + kHalf);
    }
    std::int32_t bits = 0;
    for (const std::int32_t mean : means) {
        bits |= mean;
    }
    if ((bits & ~kLargest) != 0) [[unlikely]] {
        for (std::int32_t& mean : means) {
            mean = std::clamp(mean, 0, kLargest);
        }
    }
    return means;
}

/// Writes pixels of up to eight bytes, given in the order of memory, the first in the lowest bits.
template <std::size_t PixelBytes>
class PixelWriter {
  public:
    /// Of the bytes to write to, from left to right, as what is beyond a pixel may be written over.
    explicit PixelWriter(std::span<std::uint8_t> row) : row_(row.data()), size_(row.size()) {}

    void write(std::uint64_t pixel, std::size_t from, std::size_t to) {
        std::size_t begin = from * PixelBytes;
        const std::size_t end = to * PixelBytes;
        if (to - from == 1 && begin + kWord <= size_) {
            store(pixel, begin);
        } else if (to > from) {
            begin = write_blocks(pixel, begin, end);
            for (; begin < end; begin += PixelBytes) {
                for (std::size_t byte = 0; byte < PixelBytes; ++byte) {
                    row_[begin + byte] = static_cast<std::uint8_t>(pixel >> 8 * byte);
                }
            }
        }
    }

  private:
    static constexpr std::size_t kWord = sizeof(std::uint64_t);
    static constexpr std::size_t kBlock = kWord * PixelBytes;  // of eight pixels

    // As far as whole ones fit. Returns where they end.
    std::size_t write_blocks(std::uint64_t pixel, std::size_t begin, std::size_t end) {
        std::array<std::uint64_t, PixelBytes> words{};
        for (std::size_t word = 0; word < PixelBytes; ++word) {
            words[word] = repeated(pixel, kWord * word % PixelBytes);
        }
        for (; begin < end && begin + kBlock <= size_; begin += kBlock) {
            for (std::size_t word = 0; word < PixelBytes; ++word) {
                store(words[word], begin + word * kWord);
            }
        }
        return begin;
    }

    // A word of pixels that begins with byte `first` of one.
    static std::uint64_t repeated(std::uint64_t pixel, std::size_t first) {
        constexpr std::size_t kBits = 8 * PixelBytes;
        std::uint64_t word = pixel >> 8 * first;
        for (std::size_t shift = kBits - 8 * first; shift < 64; shift += kBits) {
            word |= pixel << shift;
        }
        return word;
    }

    void store(std::uint64_t word, std::size_t at) {
        if constexpr (std::endian::native == std::endian::big) {
            word = __builtin_bswap64(word);
        }
        std::memcpy(row_ + at, &word, kWord);
    }

    std::uint8_t* row_;
    std::size_t size_;
};

/// Turns the sums along a row into samples; ToSamples makes those of a pixel of its sums.
template <std::size_t Channels, class Sample, class ToSamples>
class RowWriter {
  public:
    using Sum = typename Coverage<Channels>::Sum;

    /// `base` is the value that the sums are counted from.
    RowWriter(std::span<const std::uint16_t, Channels> base,
              const ToSamples& to_samples,
              std::span<Sample> row)
        : to_samples_(to_samples),
          pixels_({reinterpret_cast<std::uint8_t*>(row.data()), row.size_bytes()}) {
        for (std::size_t c = 0; c < Channels; ++c) {
            sum_[c] = base[c] * kFullCoverage;
        }
    }

    void add(const Sum& difference) {
        Sum sum = difference;  // reads all before it writes any, to take several at once
        for (std::size_t c = 0; c < sum.size(); ++c) {
            sum[c] += sum_[c];
        }
        sum_ = sum;
        const auto samples = to_samples_.template samples_of<Channels>(sum_);
        pixel_ = 0;
        for (std::size_t c = 0; c < Channels; ++c) {
            std::uint64_t sample = samples[c];
            if constexpr (std::endian::native == std::endian::big && sizeof(Sample) == 2) {
                sample = __builtin_bswap16(samples[c]);
            }
            pixel_ |= sample << (8 * sizeof(Sample) * c);
        }
    }

    /// Stretches come from left to right.
    void write(std::size_t from, std::size_t to) { pixels_.write(pixel_, from, to); }

  private:
    const ToSamples& to_samples_;
    Sum sum_{};
    std::uint64_t pixel_ = 0;
    PixelWriter<Channels * sizeof(Sample)> pixels_;
};

}  // namespace foam::texgen
