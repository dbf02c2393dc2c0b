// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "core/parallel/simd_level.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace foam::texgen {

/// One number for each of several blocks, in a SIMD register of `kBytes` bytes. Operations are done
/// lane by lane, so that the result of a block does not depend on the width of the register.
///
/// The copy constructor is not the default one. Objects of the class are therefore passed in
/// memory, in the same way for all instruction sets. How objects are passed in registers would
/// depend on the instruction set for which a function is compiled. Functions that use lanes are
/// inlined (FOAM_INLINE), so that passing objects takes no time.
template <class Number, int kBytes>
class Lanes {
  public:
    using Register [[gnu::vector_size(kBytes)]] = Number;
    static constexpr std::size_t kCount = kBytes / sizeof(Number);

    FOAM_INLINE Lanes() : lanes{} {}
    // NOLINTNEXTLINE(google-explicit-constructor): the same number in all lanes
    FOAM_INLINE Lanes(Number number) : lanes(number - Register{}) {}
    FOAM_INLINE Lanes(const Lanes& other) : lanes(other.lanes) {}
    FOAM_INLINE Lanes& operator=(const Lanes& other) {
        lanes = other.lanes;
        return *this;
    }
    ~Lanes() = default;

    FOAM_INLINE static Lanes load(const Number* numbers) {
        Lanes loaded;
        std::memcpy(&loaded.lanes, numbers, sizeof loaded.lanes);
        return loaded;
    }
    FOAM_INLINE void store(Number* numbers) const { std::memcpy(numbers, &lanes, sizeof lanes); }

    FOAM_INLINE Lanes& operator+=(const Lanes& other) {
        lanes += other.lanes;
        return *this;
    }
    FOAM_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return from(a.lanes + b.lanes);
    }
    FOAM_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return from(a.lanes - b.lanes);
    }
    FOAM_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return from(a.lanes * b.lanes);
    }
    FOAM_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return from(a.lanes / b.lanes);
    }
    FOAM_INLINE friend Lanes operator&(const Lanes& a, const Lanes& b) {
        return from(a.lanes & b.lanes);
    }
    FOAM_INLINE friend Lanes operator|(const Lanes& a, const Lanes& b) {
        return from(a.lanes | b.lanes);
    }
    FOAM_INLINE friend Lanes operator<<(const Lanes& a, int bits) { return from(a.lanes << bits); }
    FOAM_INLINE friend Lanes operator>>(const Lanes& a, int bits) { return from(a.lanes >> bits); }

    FOAM_INLINE static Lanes from(const Register& given) {
        Lanes made;
        made.lanes = given;
        return made;
    }

    Register lanes;
};

/// The types of lanes at a SIMD level, and operations on them, lane by lane.
template <SimdLevel kLevel>
struct LanesAt {
    static constexpr int kBytes = kLevel == SimdLevel::Avx512 ? 64
                                  : kLevel == SimdLevel::Avx2 ? 32
                                                              : 16;
    using Floats = Lanes<float, kBytes>;
    using Ints = Lanes<std::int32_t, kBytes>;
    static constexpr std::size_t kCount = Floats::kCount;

    /// Return -1 in lanes in which a < b (`less`) or a = b (`equal`) holds, and 0 in the others.
    template <class Numbers>
    FOAM_INLINE static Ints less(const Numbers& a, const Numbers& b) {
        return Ints::from(a.lanes < b.lanes);
    }
    template <class Numbers>
    FOAM_INLINE static Ints equal(const Numbers& a, const Numbers& b) {
        return Ints::from(a.lanes == b.lanes);
    }
    /// Returns the lanes of `a` where the mask is -1, and the lanes of `b` where it is 0.
    template <class Numbers>
    FOAM_INLINE static Numbers select(const Ints& mask, const Numbers& a, const Numbers& b) {
        return Numbers::from(mask.lanes ? a.lanes : b.lanes);
    }
    template <class Numbers>
    FOAM_INLINE static Numbers smaller(const Numbers& a, const Numbers& b) {
        return Numbers::from(a.lanes < b.lanes ? a.lanes : b.lanes);
    }
    template <class Numbers>
    FOAM_INLINE static Numbers larger(const Numbers& a, const Numbers& b) {
        return Numbers::from(a.lanes > b.lanes ? a.lanes : b.lanes);
    }
    /// Returns true if the mask is -1 in any lane.
    FOAM_INLINE static bool any(const Ints& mask) {
        std::int32_t all = 0;
        for (std::size_t k = 0; k < kCount; ++k) {
            all |= mask.lanes[k];
        }
        return all != 0;
    }
    /// Returns the numbers as integers, rounded toward 0.
    FOAM_INLINE static Ints whole(const Floats& numbers) {
        return Ints::from(__builtin_convertvector(numbers.lanes, typename Ints::Register));
    }
    /// Returns the integers as floats.
    FOAM_INLINE static Floats numbers(const Ints& whole) {
        return Floats::from(__builtin_convertvector(whole.lanes, typename Floats::Register));
    }
    FOAM_INLINE static Floats square_root(const Floats& given) {
        KernelArray<float, kCount> roots;
        given.store(roots.data());
#pragma GCC unroll 1  // GCC would not vectorize the unrolled loop
        for (float& root : roots) {
            root = std::sqrt(root);
        }
        return Floats::load(roots.data());
    }
    /// Returns the numbers rounded toward 0.
    FOAM_INLINE static Floats truncated(const Floats& given) {
        return numbers(whole(given));
    }
};

}  // namespace foam::texgen
