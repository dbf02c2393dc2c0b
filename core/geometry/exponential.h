// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/elementary_arithmetic.h"

#include <limits>

// Exponential functions and logarithms whose results are the same on every machine (see
// elementary.h). The polynomials, E(r) and L(z) in the formulas below, are minimax approximations;
// minimax.py computes their coefficients.

namespace foam::ieee {

namespace detail {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The number log 2. `high` has only 42 bits, so that its products with the exponents of doubles are
// exact; `low` is the small remainder.
inline constexpr TwoDoubles kLog2 = {0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};

// Returns exp x, computed as 2^k exp r. Here x = k log 2 + r with |r| <= log(2) / 2, and
// exp r = 1 + r + r² E(r). If exp x is too large for a double, returns infinity; if exp x is too
// small, returns 0.
[[gnu::always_inline]] inline double exponential(const TwoDoubles& x) {
    constexpr std::array kExponential = {0x1p-1,
                                         0x1.5555555555557p-3,
                                         0x1.5555555555558p-5,
                                         0x1.11111111100dbp-7,
                                         0x1.6c16c16c151fap-10,
                                         0x1.a01a01abe8204p-13,
                                         0x1.a01a01acfb1c1p-16,
                                         0x1.71de02313782fp-19,
                                         0x1.27e4cccdb79e9p-22,
                                         0x1.af4dea2b1bc57p-26,
                                         0x1.1f8b4c1725b48p-29};
    const double bounded_below = x.high < -746.0 ? -746.0 : x.high;
    const double high = bounded_below > 710.0 ? 710.0 : bounded_below;
    const double k = (high * 0x1.71547652b82fep+0 + kRounder) - kRounder;
    const double low = high == x.high ? x.low : 0.0;
    const TwoDoubles r = ordered_sum(high - k * kLog2.high, low - k * kLog2.low);
    const double bend = r.high * r.high * polynomial(kExponential, r.high);
    const double power = 1.0 + (r.high + (bend + (r.low + r.low * r.high)));
    const double half = (0.5 * k + kRounder) - kRounder;
    return power * power_of_two(half) * power_of_two(k - half);
}

// Returns log x, with a relative error of about 2^-65, for a positive finite number x. The number x
// is 2^k m with m in [sqrt(1/2), sqrt 2), so that log x = k log 2 + log m. With
// s = (m - 1) / (m + 1) and z = s², log m = 2 s (1 + z / 3 + z² L(z)).
[[gnu::always_inline]] inline TwoDoubles logarithm(double x) {
    constexpr std::array kLogarithm = {0x1.9999999999996p-3,
                                       0x1.2492492493038p-3,
                                       0x1.c71c71c580066p-4,
                                       0x1.745d183281b9ep-4,
                                       0x1.3b1362a988b7dp-4,
                                       0x1.1120b78218cbcp-4,
                                       0x1.de3324927676bp-5,
                                       0x1.eb139a668bc9dp-5};
    constexpr TwoDoubles kThird = {0x1.5555555555555p-2, 0x1.5555555555555p-56};
    constexpr std::uint64_t kRootOfHalf = 0x3fe6a09e667f3bcd;
    constexpr std::uint64_t kOne = 0x3ff0000000000000;
    constexpr std::uint64_t kMantissa = 0x000fffffffffffff;
    constexpr double kSmallest = std::numeric_limits<double>::min();
    const double normal = x < kSmallest ? x * 0x1p54 : x;
    const std::uint64_t shifted = bits_of(normal) + (kOne - kRootOfHalf);
    const double m = from_bits((shifted & kMantissa) + kRootOfHalf);
    const double biased = from_bits((shifted >> 52) | bits_of(0x1p52)) - 0x1p52;
    const double k = biased - (x < kSmallest ? 1023.0 + 54.0 : 1023.0);

    const TwoDoubles s = quotient({m - 1.0, 0.0}, exact_sum(1.0, m));
    const TwoDoubles z = product(s, s);
    const double bend = z.high * polynomial(kLogarithm, z.high);
    const TwoDoubles third = ordered_sum(kThird.high, kThird.low + bend);
    const TwoDoubles rest = product(s, product(z, third));
    const TwoDoubles half = ordered_sum(s.high, rest.high);
    const TwoDoubles whole = exact_sum(k * kLog2.high, 2.0 * half.high);
    const double low = 2.0 * (half.low + (s.low + rest.low)) + k * kLog2.low;
    return ordered_sum(whole.high, whole.low + low);
}

// Returns log x times a positive factor. For x = 0, x = infinity, NaN and x < 0 the result is the
// value that IEEE 754 gives for a logarithm.
[[gnu::always_inline]] inline double scaled_logarithm(double x, const TwoDoubles& factor) {
    const TwoDoubles scaled = product(logarithm(x), factor);
    const double unbounded = x == 0.0 ? -kInfinity : kInfinity;
    const double finite = scaled.high + scaled.low;
    const double number = x > 0.0 && x < kInfinity ? finite : unbounded;
    return x >= 0.0 ? number : kNaN;
}

}  // namespace detail

/// Returns exp x with an error below 0.85 ulp (below 1 ulp if the result is subnormal).
[[gnu::always_inline]] inline double exp(double x) {
    return detail::exponential({x, 0.0});
}

/// log, log2 and log10 return the logarithms to base e, 2 and 10 with an error below 0.6 ulp.
/// Logarithms that are whole numbers are exact. As in the C standard, the logarithm of 0 is minus
/// infinity, and the logarithm of a negative number is NaN.
inline double log(double x) {
    return detail::scaled_logarithm(x, {1.0, 0.0});
}
inline double log2(double x) {
    return detail::scaled_logarithm(x, {0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56});
}
inline double log10(double x) {
    return detail::scaled_logarithm(x, {0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57});
}

/// Returns x^y for x >= 0, with an error below 1 ulp. If a double can represent x^y exactly, the
/// result is exact, for example for powers of 10. Loops that call this function can be vectorized.
[[gnu::always_inline]] inline double pow_of_positive(double x, double y) {
    // Exponents beyond these limits give the same results as the limits: 0, 1 or infinity. The
    // limits prevent an overflow.
    const double bounded_below = y < -0x1p100 ? -0x1p100 : y;
    const double exponent = bounded_below > 0x1p100 ? 0x1p100 : bounded_below;
    const double power = detail::exponential(product(detail::logarithm(x), {exponent, 0.0}));
    const double power_of_zero = y > 0.0 ? 0.0 : detail::kInfinity;
    const double power_of_infinity = y > 0.0 ? detail::kInfinity : 0.0;
    const double power_of_x =
        x == 0.0 ? power_of_zero : (x == detail::kInfinity ? power_of_infinity : power);
    const double power_or_nan = x != x || y != y ? x + y : power_of_x;
    return y == 0.0 || x == 1.0 ? 1.0 : power_or_nan;
}

/// Returns x^y. The error is the same as for pow_of_positive. For finite x < 0, the result is NaN
/// unless y is a whole number or infinite. Zeros, infinities and NaN give the results of the C
/// standard.
double pow(double x, double y);

}  // namespace foam::ieee
