#pragma once

/// Compiles a function for processors with AVX2 as well, which is chosen when the program begins:
/// eight floats at once in place of four. Both do the same IEEE operations, so that the results
/// have the same bits. Left out where a sanitizer would have to be ready that early.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FOAMTEX_VECTOR_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define FOAMTEX_VECTOR_CLONES
#endif
