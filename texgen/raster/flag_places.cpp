#include "texgen/raster/flag_places.h"

#include "texgen/raster/avx512.h"

#include <array>
#include <bit>
#include <numeric>

namespace foam::texgen {

namespace {

#ifdef FOAMTEX_AVX512
struct Places {
    alignas(sizeof(__m512i)) std::array<std::uint8_t, kFlagsPerWord> of_word{};

    constexpr Places() { std::iota(of_word.begin(), of_word.end(), std::uint8_t{0}); }
};

// Those of a word at once. The only branch is foreseen, as a word with more than 32 is rare.
FOAMTEX_AVX512 std::size_t find_places_in_lanes(std::span<const std::uint64_t> flags,
                                                std::uint16_t* places) {
    static constexpr Places kPlaces;
    constexpr std::size_t kLanes = 32;
    const __m512i all = _mm512_load_si512(kPlaces.of_word.data());
    const __m512i step = _mm512_set1_epi16(kFlagsPerWord);
    __m512i first = _mm512_setzero_si512();
    std::uint16_t* to = places;
    for (const std::uint64_t word : flags) {
        const auto count = static_cast<std::size_t>(std::popcount(word));
        const __m512i within = _mm512_maskz_compress_epi8(word, all);
        const __m512i some = _mm512_cvtepu8_epi16(_mm512_castsi512_si256(within));
        _mm512_storeu_si512(to, _mm512_add_epi16(first, some));
        if (count > kLanes) [[unlikely]] {
            const __m512i rest = _mm512_cvtepu8_epi16(_mm512_extracti64x4_epi64(within, 1));
            _mm512_storeu_si512(to + kLanes, _mm512_add_epi16(first, rest));
        }
        first = _mm512_add_epi16(first, step);
        to += count;
    }
    return static_cast<std::size_t>(to - places);
}
#endif

}  // namespace

std::size_t find_places(std::span<const std::uint64_t> flags, std::uint16_t* places) {
#ifdef FOAMTEX_AVX512
    if (has_avx512()) {
        return find_places_in_lanes(flags, places);
    }
#endif
    return find_places_one_by_one(flags, places);
}

std::size_t find_places_one_by_one(std::span<const std::uint64_t> flags, std::uint16_t* places) {
    std::size_t count = 0;
    for (std::size_t word = 0; word < flags.size(); ++word) {
        for (std::uint64_t bits = flags[word]; bits != 0; bits &= bits - 1) {
            const std::size_t place =
                word * kFlagsPerWord + static_cast<std::size_t>(std::countr_zero(bits));
            places[count++] = static_cast<std::uint16_t>(place);
        }
    }
    return count;
}

}  // namespace foam::texgen
