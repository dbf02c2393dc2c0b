// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/simd_level.h"

#include <vector>

/// Tells GCC that the arrays of the loop that follows do not overlap. GCC then vectorizes the loop
/// without comparing the addresses of the arrays. Without this macro, GCC vectorizes only loops
/// over few arrays, and these loops compare the addresses at run time.
#if defined(__GNUC__) && !defined(__clang__)
#define FOAM_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define FOAM_INDEPENDENT_ITERATIONS
#endif

namespace foam::texgen {

/// Return the smaller (min_value) and the larger (max_value) of two values. Unlike std::min and
/// std::max, they take no references, so that compilers vectorize loops that call them.
template <class Number>
[[gnu::always_inline]] inline Number min_value(Number a, Number b) {
    return a < b ? a : b;
}
template <class Number>
[[gnu::always_inline]] inline Number max_value(Number a, Number b) {
    return a > b ? a : b;
}

/// Grows a scratch array to at least `count` values. Never shrinks it. If the array is too small,
/// it grows to twice the count, so that repeated use rarely allocates memory.
template <class Value>
void grow(std::vector<Value>& values, std::size_t count) {
    if (values.size() < count) {
        values.resize(2 * count);
    }
}

}  // namespace foam::texgen
