#include "texgen/raster/paint_blocks.h"

#include "texgen/raster/simd/vector_clones.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace foam::texgen {

namespace {

static_assert(kBlockBytes % 64 == 0, "whole vectors of pixels side by side, on any processor");

template <std::size_t PixelBytes>
constexpr std::size_t kWords = kBlockBytes / sizeof(PixelWord<PixelBytes>);

// Words hold the pixel from byte f on, and then the next one.
template <std::size_t PixelBytes>
struct Shifts {
    using Word = PixelWord<PixelBytes>;
    std::array<Word, kWords<PixelBytes>> right{};
    std::array<Word, kWords<PixelBytes>> left{};

    constexpr Shifts() {
        for (std::size_t k = 0; k < kWords<PixelBytes>; ++k) {
            const std::size_t first = k * sizeof(Word) % PixelBytes;
            right[k] = static_cast<Word>(8 * first);
            left[k] = static_cast<Word>(8 * (PixelBytes - first));
        }
    }
};

std::uint32_t in_memory(std::uint32_t word) {
    return std::endian::native == std::endian::little ? word : __builtin_bswap32(word);
}
std::uint64_t in_memory(std::uint64_t word) {
    return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

template <std::size_t PixelBytes>
[[gnu::always_inline]] inline void store_block(PixelWord<PixelBytes> pixel, std::uint8_t* to) {
    using Word = PixelWord<PixelBytes>;
    static constexpr Shifts<PixelBytes> kShifts;
    constexpr bool kIsPart = sizeof(Word) % PixelBytes == 0;  // a word holds whole pixels
    constexpr Word kAll = ~Word{0};
    if constexpr (kIsPart) {
        pixel *= kAll / (kAll >> 8 * (sizeof(Word) - PixelBytes));
    }
    for (std::size_t k = 0; k < kWords<PixelBytes>; ++k) {
        const Word word =
            in_memory(kIsPart ? pixel : (pixel >> kShifts.right[k]) | (pixel << kShifts.left[k]));
        std::memcpy(to + k * sizeof(Word), &word, sizeof(Word));
    }
}

}  // namespace

// Nearly all stretches of a row are shorter than a block: what is too long is written over by the
// next, without a branch that a processor would have to foresee.
template <std::size_t PixelBytes>
FOAMTEX_VECTOR_CLONES void paint_blocks(const Stretches<PixelBytes>& stretches,
                                        std::uint8_t* __restrict row) {
    constexpr std::size_t kPixels = kBlockBytes / PixelBytes;
    const std::uint16_t* begins = stretches.begins.data();
    const std::size_t count = stretches.begins.size() - 1;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t end = begins[k + 1];
        for (std::size_t x = begins[k]; x < end; x += kPixels) {
            store_block<PixelBytes>(stretches.pixels[k], row + x * PixelBytes);
        }
    }
}

template void paint_blocks(const Stretches<1>& stretches, std::uint8_t* row);
template void paint_blocks(const Stretches<2>& stretches, std::uint8_t* row);
template void paint_blocks(const Stretches<3>& stretches, std::uint8_t* row);
template void paint_blocks(const Stretches<4>& stretches, std::uint8_t* row);
template void paint_blocks(const Stretches<6>& stretches, std::uint8_t* row);
template void paint_blocks(const Stretches<8>& stretches, std::uint8_t* row);

}  // namespace foam::texgen
