// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>

/// Turns off those checks of UndefinedBehaviorSanitizer that concern pointers and indices. In the
/// largest kernels (texgen/blocks), these checks are inlined a thousand times, and Clang then takes
/// more than six minutes. Without them, compiling takes 20 s. AddressSanitizer still finds accesses
/// outside of the object that contains the array.
#ifdef __clang__
#define FOAM_UNCHECKED_POINTERS \
    __attribute__((no_sanitize("null", "alignment", "object-size", "pointer-overflow", "bounds")))
#else
#define FOAM_UNCHECKED_POINTERS
#endif

/// Marks functions that kernels call. They are compiled for the instruction set of the kernel
/// (at_simd_level in simd_level.h) only if they are inlined into it. The attribute `flatten`, with
/// which at_simd_level inlines the functions that a kernel calls, does not inline large functions.
#define FOAM_INLINE [[gnu::always_inline]] FOAM_UNCHECKED_POINTERS inline
#define FOAM_INLINE_LAMBDA __attribute__((always_inline)) FOAM_UNCHECKED_POINTERS

namespace foam {

/// An array for kernels (at_simd_level in simd_level.h). Its elements are initialized to 0, or by
/// their default constructor. Its functions are inlined and never check an index. The functions of
/// std::array check indices in hardened builds (SECURITY.md), and the checks keep compilers from
/// vectorizing loops and from holding elements in registers.
template <class Value, std::size_t kSize>
struct KernelArray {  // NOLINT(readability-identifier-naming): names in implicit constructors
    FOAM_INLINE constexpr Value& operator[](std::size_t k) { return values[k]; }
    FOAM_INLINE constexpr const Value& operator[](std::size_t k) const { return values[k]; }
    FOAM_INLINE constexpr Value* begin() { return values; }
    FOAM_INLINE constexpr Value* end() { return values + kSize; }
    FOAM_INLINE constexpr const Value* begin() const { return values; }
    FOAM_INLINE constexpr const Value* end() const { return values + kSize; }
    FOAM_INLINE constexpr Value* data() { return values; }
    FOAM_INLINE constexpr const Value* data() const { return values; }
    FOAM_INLINE static constexpr std::size_t size() { return kSize; }
    FOAM_INLINE constexpr void fill(const Value& value) { std::fill_n(values, kSize, value); }

    Value values[kSize]{};  // NOLINT(*-avoid-c-arrays)
};

}  // namespace foam
