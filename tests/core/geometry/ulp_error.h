// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace foam::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// A number of MPFR, which computes elementary functions with any precision.
class Reference {
  public:
    explicit Reference(mpfr_prec_t bits) { mpfr_init2(number_, bits); }
    explicit Reference(double value) : Reference(mpfr_prec_t{53}) {
        mpfr_set_d(number_, value, MPFR_RNDN);
    }
    ~Reference() { mpfr_clear(number_); }
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;

    mpfr_ptr get() { return number_; }

  private:
    mpfr_t number_;
};

inline constexpr mpfr_prec_t kReferenceBits = 160;

/// Returns the difference of two numbers in ulp of `exact`. Returns infinity if one of the numbers
/// is not finite, or if one of them is zero, and the other is not the same.
inline double ulp_error(double computed, Reference& exact) {
    const double nearest = mpfr_get_d(exact.get(), MPFR_RNDN);
    if (std::isnan(nearest) && std::isnan(computed)) {
        return 0.0;
    }
    if (!std::isfinite(nearest) || !std::isfinite(computed) || nearest == 0.0) {
        return nearest == computed ? 0.0 : kInfinity;
    }
    const int exponent = std::max(std::ilogb(nearest), -1022);
    Reference difference(kReferenceBits);
    mpfr_sub_d(difference.get(), exact.get(), computed, MPFR_RNDN);
    mpfr_mul_2si(difference.get(), difference.get(), 52 - exponent, MPFR_RNDN);
    return std::abs(mpfr_get_d(difference.get(), MPFR_RNDN));
}

/// Returns the largest error in ulp, over arguments drawn at random, of a function of one argument.
/// `reference` is the function of MPFR.
template <class Function, class Draw>
double largest_error(Function function,
                     int (*reference)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t),
                     Draw draw,
                     int count = 4000) {
    double largest = 0.0;
    Reference exact(kReferenceBits);
    for (int k = 0; k < count; ++k) {
        const double x = draw();
        reference(exact.get(), Reference(x).get(), MPFR_RNDN);
        largest = std::max(largest, ulp_error(function(x), exact));
    }
    return largest;
}

/// Returns the largest error in ulp, over arguments drawn at random, of a function of two
/// arguments. `reference` is the function of MPFR.
template <class Function, class DrawFirst, class DrawSecond>
double largest_error(Function function,
                     int (*reference)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t),
                     DrawFirst draw_first,
                     DrawSecond draw_second,
                     int count = 4000) {
    double largest = 0.0;
    Reference exact(kReferenceBits);
    for (int k = 0; k < count; ++k) {
        const double x = draw_first();
        const double y = draw_second();
        reference(exact.get(), Reference(x).get(), Reference(y).get(), MPFR_RNDN);
        largest = std::max(largest, ulp_error(function(x, y), exact));
    }
    return largest;
}

/// Draws random numbers for tests.
class Draws {
  public:
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
    }
    /// Returns a finite number with random bits, of any sign and exponent.
    double any() {
        double x = kInfinity;
        while (!std::isfinite(x)) {
            x = std::bit_cast<double>(engine_());
        }
        return x;
    }

  private:
    std::mt19937_64 engine_{1};
};

/// Returns true if two numbers have the same value and sign, or both are NaN.
inline bool are_same(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

}  // namespace foam::test
