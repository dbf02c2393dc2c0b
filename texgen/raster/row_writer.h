#pragma once

#include "texgen/raster/coverage_sums.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace foam::texgen {

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

/// Turns the sums along a row into samples; to_samples(sum) makes those of a pixel, of which there
/// are `Channels`.
template <class Sums, std::size_t Channels, class Sample, class ToSamples>
class RowWriter {
  public:
    using Sum = typename Sums::Sum;

    /// `base` is the value that the sums are counted from.
    RowWriter(std::span<const std::uint16_t, Channels> base,
              const ToSamples& to_samples,
              std::span<Sample> row)
        : to_samples_(to_samples),
          pixels_({reinterpret_cast<std::uint8_t*>(row.data()), row.size_bytes()}) {
        for (std::size_t c = 0; c < Channels; ++c) {
            sum_[c] = Sums::start(base[c]);
        }
    }

    void add(const Sum& difference) {
        Sum sum = difference;  // reads all before it writes any, to take several at once
        for (std::size_t c = 0; c < sum.size(); ++c) {
            sum[c] += sum_[c];
        }
        sum_ = sum;
        const auto samples = to_samples_(sum_);
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
