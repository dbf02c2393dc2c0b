// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/row_writer.h"

#include <array>
#include <bit>

namespace foam::texgen {

namespace {

constexpr std::size_t kWords = kBlockBytes / sizeof(std::uint64_t);  // words per block

// Returns a word whose first byte in memory is the lowest byte of `word`.
std::uint64_t to_little_endian(std::uint64_t word) {
    return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

// The pattern of a block of equal pixels. A pixel is repeated until it fills a pattern of 8 bytes,
// or of 6 bytes if the pixel has 3 or 6 bytes. In the second case the words of a block start at
// different bytes of the pattern; each word is composed of two shifted copies of the pattern.
template <std::size_t PixelBytes>
struct Repetition {
    static constexpr std::size_t kBytes = 8 % PixelBytes == 0 ? 8 : 6;

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

}  // namespace

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

template void paint_spans<1>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<2>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<3>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<4>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<6>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);
template void paint_spans<8>(std::span<const std::uint16_t>, const std::uint64_t*, std::uint8_t*);

}  // namespace foam::texgen
