// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/row_writer.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace foam::texgen {

namespace {

constexpr std::size_t kWords = kBlockBytes / sizeof(std::uint64_t);  // words per block

// Returns a word whose first byte in memory is the lowest byte of `word`.
std::uint64_t to_little_endian(std::uint64_t word) {
    return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

// The pattern of a block of equal pixels. A pixel is repeated until it fills a pattern of 8 bytes;
// a pixel of 6 bytes is a pattern by itself. In the second case the words of a block start at
// different bytes of the pattern; each word is composed of two shifted copies of the pattern.
template <std::size_t PixelBytes>
struct Repetition {
    static constexpr std::size_t kBytes = PixelBytes == 6 ? 6 : 8;

    // For each word, the number of bits by which one copy of the pattern is shifted right and the
    // other copy left.
    std::array<std::uint64_t, kWords> right{};
    std::array<std::uint64_t, kWords> left{};

    constexpr Repetition() {
        for (std::size_t k = 0; k < kWords; ++k) {
            right[k] = 8 * (8 * k % kBytes);
            left[k] = (8 * kBytes - right[k]) % 64;
        }
    }

    // Returns the pattern for a pixel.
    static std::uint64_t repeated(std::uint64_t pixel) {
        for (std::size_t bytes = PixelBytes; bytes < kBytes; bytes *= 2) {
            pixel |= pixel << 8 * bytes;
        }
        return pixel;
    }
};

template <std::size_t PixelBytes>
inline void store_block(std::uint64_t pixel, std::uint8_t* to) {
    static constexpr Repetition<PixelBytes> kRepetition;
    const std::uint64_t all = kRepetition.repeated(pixel);
#pragma GCC unroll 1  // GCC would not vectorize the unrolled loop
    for (std::size_t k = 0; k < kWords; ++k) {
        const std::uint64_t word =
            to_little_endian(all >> kRepetition.right[k] | all << kRepetition.left[k]);
        std::memcpy(to + k * sizeof(word), &word, sizeof(word));
    }
}

// Returns the straight color and the opacity of a pixel.
template <std::size_t Channels>
PixelSamples<Channels> straight(const PixelSums<Channels>& sums) {
    PixelSamples<Channels> samples{};
    const auto opacity = static_cast<std::int64_t>(sums[Channels - 1]);
    if (opacity <= 0) {
        return samples;
    }
    for (std::size_t c = 0; c + 1 < Channels; ++c) {
        const auto whole = static_cast<std::int64_t>(sums[c]);
        const std::int64_t color = (whole * kLargestMean + opacity / 2) / opacity;
        samples[c] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(color, 0, kLargestMean));
    }
    samples[Channels - 1] = mean_of(sums[Channels - 1]);
    return samples;
}

}  // namespace

template <std::size_t Channels>
std::uint64_t packed(const PixelSamples<Channels>& samples) {
    std::uint64_t pixel = 0;
    for (std::size_t c = 0; c < Channels; ++c) {
        const std::uint16_t sample =
            std::endian::native == std::endian::little ? samples[c] : __builtin_bswap16(samples[c]);
        pixel |= std::uint64_t{sample} << (8 * sizeof(sample) * c);
    }
    return pixel;
}

template <std::size_t Channels>
void RoundedMeans<Channels>::operator()(std::span<const PixelSums<Channels>> sums,
                                        std::uint64_t* pixels) {
    constexpr std::size_t kChannels = std::tuple_size_v<PixelSums<Channels>>;
    const std::size_t count = kChannels * sums.size();
    grow(means_, count);
    at_simd_level([numbers = sums.front().data(), count, to = means_.data()] {
        std::uint16_t* __restrict means = to;
        for (std::size_t k = 0; k < count; ++k) {
            means[k] = mean_of(numbers[k]);
        }
    });
    const std::uint16_t* means = means_.data();
    for (std::size_t k = 0; k < sums.size(); ++k, means += kChannels) {
        PixelSamples<Channels> samples;
        std::copy_n(means, Channels, samples.begin());
        pixels[k] = packed<Channels>(samples);
    }
}

template <std::size_t Channels>
void StraightMeans<Channels>::operator()(std::span<const PixelSums<Channels>> sums,
                                         std::uint64_t* pixels) const {
    for (std::size_t k = 0; k < sums.size(); ++k) {
        pixels[k] = packed<Channels>(straight<Channels>(sums[k]));
    }
}

// Writes spans in whole blocks. Most spans are shorter than a block; the next span overwrites the
// excess. A loop over single pixels would have an unpredictable branch per span.
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

template std::uint64_t packed<1>(const PixelSamples<1>&);
template class RoundedMeans<1>;
template class StraightMeans<1>;
template std::uint64_t packed<2>(const PixelSamples<2>&);
template class RoundedMeans<2>;
template class StraightMeans<2>;
template std::uint64_t packed<3>(const PixelSamples<3>&);
template class RoundedMeans<3>;
template class StraightMeans<3>;
template std::uint64_t packed<4>(const PixelSamples<4>&);
template class RoundedMeans<4>;
template class StraightMeans<4>;
template void paint_spans<2>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<4>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<6>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<8>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);

}  // namespace foam::texgen
