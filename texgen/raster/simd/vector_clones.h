#pragma once

#include "texgen/raster/simd/kernel.h"

/// Compiles a function for processors with AVX-512 and with AVX2 as well, which is chosen when the
/// program begins: sixteen floats, or eight, at once in place of four. All do the same IEEE
/// operations, so that the results have the same bits. Left out where a sanitizer would have to be
/// ready that early.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FOAMTEX_VECTOR_CLONES [[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#else
#define FOAMTEX_VECTOR_CLONES
#endif
