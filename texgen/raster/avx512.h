#pragma once

#if defined(__GNUC__) && defined(__x86_64__)

#pragma GCC diagnostic push
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // in GCC 12's intrinsics: its bug 105593
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop

/// Marks functions for processors with AVX-512 as of Ice Lake and Zen 4: those that say so of
/// themselves (has_avx512) may be asked to run them. Only there is it defined.
#define FOAMTEX_AVX512 \
    [[gnu::target("avx512f,avx512bw,avx512vl,avx512vbmi,avx512vbmi2,avx512vpopcntdq,popcnt")]]

#endif

namespace foam::texgen {

/// Whether this processor runs functions marked with FOAMTEX_AVX512.
inline bool has_avx512() {
#ifdef FOAMTEX_AVX512
    static const bool supported =
        __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
        __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512vbmi") != 0 &&
        __builtin_cpu_supports("avx512vbmi2") != 0 &&
        __builtin_cpu_supports("avx512vpopcntdq") != 0 && __builtin_cpu_supports("popcnt") != 0;
    return supported;
#else
    return false;
#endif
}

}  // namespace foam::texgen
