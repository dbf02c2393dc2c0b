#pragma once

namespace foam::texgen {

/// As std::min and std::max, but of values; as a && b, but asks for both. So compilers see no
/// branch, and take several at once.
template <class Real>
[[gnu::always_inline]] inline Real least(Real a, Real b) {
    return a < b ? a : b;
}
template <class Real>
[[gnu::always_inline]] inline Real most(Real a, Real b) {
    return a > b ? a : b;
}
[[gnu::always_inline]] inline bool both(bool a, bool b) {
    return (static_cast<int>(a) & static_cast<int>(b)) != 0;
}

}  // namespace foam::texgen

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
