#include "texgen/raster/paint_row.h"

#include "texgen/image/cache_line.h"
#include "texgen/raster/avx512.h"
#include "texgen/raster/paint_blocks.h"

#include <array>
#include <bit>
#include <cassert>

namespace foam::texgen {

namespace {

constexpr std::size_t kStreamedBytes = std::size_t{8} << 20;  // of an image

#ifdef FOAMTEX_AVX512

constexpr std::size_t kVectorBytes = 64;

// Sixteen pixels in words of 32 bits, or eight in words of 64.
template <std::size_t PixelBytes>
constexpr std::size_t kLanes = kVectorBytes / sizeof(PixelWord<PixelBytes>);

// Four vectors of pixels in words become fewer, of pixels side by side: the bytes of each come from
// one of the four and, if need be, the one after it.
template <std::size_t PixelBytes>
struct Packing {
    static constexpr std::size_t kWordBytes = sizeof(PixelWord<PixelBytes>);
    static constexpr std::size_t kVectors = 4 * PixelBytes / kWordBytes;
    static constexpr std::size_t kPacked = kLanes<PixelBytes> * PixelBytes;  // bytes, of a vector

    static constexpr std::size_t source(std::size_t vector) {
        return vector * kVectorBytes / kPacked;
    }

    alignas(kVectorBytes) std::array<std::array<std::uint8_t, kVectorBytes>, kVectors> bytes{};

    constexpr Packing() {
        for (std::size_t vector = 0; vector < kVectors; ++vector) {
            for (std::size_t k = 0; k < kVectorBytes; ++k) {
                const std::size_t byte = vector * kVectorBytes + k - source(vector) * kPacked;
                const std::size_t in_source = byte % kPacked;
                bytes[vector][k] = static_cast<std::uint8_t>(byte / kPacked % 2 * kVectorBytes +
                                                             in_source / PixelBytes * kWordBytes +
                                                             in_source % PixelBytes);
            }
        }
    }
};

template <Stores Kind>
FOAMTEX_AVX512 inline void store(__m512i vector, std::uint8_t* to) {
    if constexpr (Kind == Stores::Streamed) {
        _mm512_stream_si512(reinterpret_cast<__m512i*>(to), vector);
    } else {
        _mm512_storeu_si512(to, vector);
    }
}

// Per pixel, the flags after the first one's up to its own.
template <class Word>
struct UpTo {
    alignas(kVectorBytes) std::array<Word, kVectorBytes / sizeof(Word)> flags{};

    constexpr UpTo() {
        for (std::size_t k = 0; k < flags.size(); ++k) {
            flags[k] = (Word{2} << k) - 2;
        }
    }
};

// A vector of the pixels with these flags. The first is that of `stretches`; how many stretches
// begin after it, up to a pixel, tells which one that is in.
FOAMTEX_AVX512 inline __m512i spread(std::uint32_t flags, const std::uint32_t* stretches) {
    static constexpr UpTo<std::uint32_t> kUpTo;
    const __m512i up_to = _mm512_load_si512(kUpTo.flags.data());
    const __m512i all = _mm512_set1_epi32(static_cast<std::int32_t>(flags));
    const __m512i which = _mm512_popcnt_epi32(_mm512_and_si512(all, up_to));
    return _mm512_permutexvar_epi32(which, _mm512_loadu_si512(stretches));
}

FOAMTEX_AVX512 inline __m512i spread(std::uint32_t flags, const std::uint64_t* stretches) {
    static constexpr UpTo<std::uint64_t> kUpTo;
    const __m512i up_to = _mm512_load_si512(kUpTo.flags.data());
    const __m512i which = _mm512_popcnt_epi64(_mm512_and_si512(_mm512_set1_epi64(flags), up_to));
    return _mm512_permutexvar_epi64(which, _mm512_loadu_si512(stretches));
}

// Four vectors of pixels, the flags of which begin at a bit of a word.
template <std::size_t PixelBytes, Stores Kind>
FOAMTEX_AVX512 inline void paint_vectors(std::uint64_t flags,
                                         std::size_t bit,
                                         const PixelWord<PixelBytes>* pixels,
                                         std::uint8_t* to) {
    using Pack = Packing<PixelBytes>;
    static constexpr Pack kPacking;
    constexpr std::size_t kSome = kLanes<PixelBytes>;
    __m512i vectors[4];
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t first = bit + k * kSome;
        const std::uint64_t before = flags & ((std::uint64_t{1} << first) - 1);
        const auto own = static_cast<std::uint32_t>(flags >> first) & ((1U << kSome) - 1);
        // The first pixel's stretch begins there, or is the one before.
        vectors[k] = spread(own, pixels + std::popcount(before) + (own & 1) - 1);
    }
    if constexpr (PixelBytes == 1) {
        // Of all four, a half each of two.
        const __m512i bytes = _mm512_load_si512(kPacking.bytes[0].data());
        const __m512i low = _mm512_permutex2var_epi8(vectors[0], bytes, vectors[1]);
        const __m512i high = _mm512_permutex2var_epi8(vectors[2], bytes, vectors[3]);
        store<Kind>(_mm512_inserti64x4(low, _mm512_castsi512_si256(high), 1), to);
    } else {
        for (std::size_t k = 0; k < Pack::kVectors; ++k) {
            const std::size_t source = Pack::source(k);
            const __m512i bytes = _mm512_load_si512(kPacking.bytes[k].data());
            store<Kind>(_mm512_permutex2var_epi8(
                            vectors[source], bytes, vectors[source < 3 ? source + 1 : 3]),
                        to + k * kVectorBytes);
        }
    }
}

template <std::size_t PixelBytes, Stores Kind>
FOAMTEX_AVX512 void paint_lanes(const Stretches<PixelBytes>& stretches, std::uint8_t* row) {
    constexpr std::size_t kSome = 4 * kLanes<PixelBytes>;
    const PixelWord<PixelBytes>* pixels = stretches.pixels;
    std::uint8_t* to = row;
    for (const std::uint64_t flags : stretches.flags) {
        for (std::size_t bit = 0; bit < kFlagsPerWord; bit += kSome) {
            paint_vectors<PixelBytes, Kind>(flags, bit, pixels, to);
            to += kSome * PixelBytes;
        }
        pixels += std::popcount(flags);
    }
}

#endif

}  // namespace

Stores stores_for(const void* first, std::size_t row_bytes, std::size_t rows) {
    const std::size_t place = reinterpret_cast<std::uintptr_t>(first) | row_bytes;
    const bool streams =
        has_avx512() && row_bytes * rows >= kStreamedBytes && place % kLineBytes == 0;
    return streams ? Stores::Streamed : Stores::Kept;
}

void finish_stores() {
#ifdef FOAMTEX_AVX512
    _mm_sfence();
#endif
}

// Lanes write whole words of flags.
std::size_t painted_bytes(std::size_t width, std::size_t pixel_bytes) {
    if (has_avx512()) {
        return flag_words(width) * kFlagsPerWord * pixel_bytes;
    }
    return width * pixel_bytes + kBlockBytes;
}

template <std::size_t PixelBytes>
void paint_row(const Stretches<PixelBytes>& stretches,
               [[maybe_unused]] Stores stores,
               std::uint8_t* row) {
#ifdef FOAMTEX_AVX512
    if (has_avx512()) {
        if (stores == Stores::Streamed) {
            assert(reinterpret_cast<std::uintptr_t>(row) % kLineBytes == 0);
            paint_lanes<PixelBytes, Stores::Streamed>(stretches, row);
        } else {
            paint_lanes<PixelBytes, Stores::Kept>(stretches, row);
        }
        return;
    }
#endif
    paint_blocks(stretches, row);
}

template void paint_row(const Stretches<1>& stretches, Stores stores, std::uint8_t* row);
template void paint_row(const Stretches<2>& stretches, Stores stores, std::uint8_t* row);
template void paint_row(const Stretches<3>& stretches, Stores stores, std::uint8_t* row);
template void paint_row(const Stretches<4>& stretches, Stores stores, std::uint8_t* row);
template void paint_row(const Stretches<6>& stretches, Stores stores, std::uint8_t* row);
template void paint_row(const Stretches<8>& stretches, Stores stores, std::uint8_t* row);

}  // namespace foam::texgen
