// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/elementary_arithmetic.h"

#include <cmath>
#include <numbers>

// Trigonometric functions whose results are the same on every machine (see elementary.h).
// The polynomials, S(z), C(z) and A(z) in the formulas below, are minimax approximations;
// minimax.py computes their coefficients.

namespace foam::ieee {

/// The sine and the cosine of an angle.
struct SineAndCosine {
    double sine = 0.0;
    double cosine = 1.0;
};

namespace detail {

inline constexpr TwoDoubles kQuarterTurn = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};  // pi/2

// An angle, reduced to the range from -pi/4 to pi/4: the original angle is `angle` plus `quarters`
// quarter turns, up to whole turns.
struct ReducedAngle {
    TwoDoubles angle;
    std::uint64_t quarters = 0;
};

// Angles up to this magnitude are reduced without integer arithmetic.
inline constexpr double kMaxModerateAngle = 0x1p20;

// Reduces an angle above kMaxModerateAngle. The result is NaN if x is infinite or NaN.
ReducedAngle reduced_large(double x);

// Reduces an angle in [0, kMaxModerateAngle] by subtraction of k pi/2, where k is a whole number
// (W. J. Cody and W. Waite, "Software Manual for the Elementary Functions", 1980). The number pi/2
// is the sum of three numbers of at most 33 bits and a small remainder. The products of the three
// numbers with k are exact.
[[gnu::always_inline]] inline ReducedAngle reduced(double x) {
    const double shifted = x * (2.0 / std::numbers::pi) + kRounder;
    const double k = shifted - kRounder;
    const TwoDoubles first = exact_sum(x - k * 0x1.921fb544p+0, -(k * 0x1.0b4611a6p-34));
    const TwoDoubles second = exact_sum(first.high, -(k * 0x1.3198a2ep-69));
    const double low = (first.low + second.low) - k * 0x1.b839a252049c1p-104;
    return {ordered_sum(second.high, low), bits_of(shifted)};
}

// Returns sin x for x in [-pi/4, pi/4]: x + x z S(z) with z = x².
[[gnu::always_inline]] inline TwoDoubles sine_of_small(const TwoDoubles& x) {
    constexpr std::array kSine = {-0x1.5555555555549p-3,
                                  0x1.111111110f87ap-7,
                                  -0x1.a01a019c11978p-13,
                                  0x1.71de3577b56b1p-19,
                                  -0x1.ae5e6639d428fp-26,
                                  0x1.5d9300cf18812p-33};
    const double z = x.high * x.high;
    return ordered_sum(x.high, x.high * z * polynomial(kSine, z) + x.low * (1.0 - 0.5 * z));
}

// Returns cos x for x in [-pi/4, pi/4]: 1 - z / 2 + z² C(z) with z = x².
[[gnu::always_inline]] inline TwoDoubles cosine_of_small(const TwoDoubles& x) {
    constexpr std::array kCosine = {0x1.555555555554cp-5,
                                    -0x1.6c16c16c1517ep-10,
                                    0x1.a01a019cb1bebp-16,
                                    -0x1.27e4f809f15ecp-22,
                                    0x1.1ee9ebe9aae80p-29,
                                    -0x1.8fae9cb4449ffp-37};
    const double z = x.high * x.high;
    const TwoDoubles start = ordered_sum(1.0, -0.5 * z);
    return ordered_sum(start.high, start.low + (z * z * polynomial(kCosine, z) - x.high * x.low));
}

// Returns the sine and the cosine of the original angle of x. The sine is negated if `sign` is
// negative.
[[gnu::always_inline]] inline SineAndCosine sine_and_cosine(const ReducedAngle& x, double sign) {
    const double sine = sine_of_small(x.angle).high;
    const double cosine = cosine_of_small(x.angle).high;
    const std::uint64_t odd = x.quarters & 1U;
    const std::uint64_t sine_flip = (x.quarters & 2U) << 62;
    const std::uint64_t cosine_flip = ((x.quarters + 1U) & 2U) << 62;
    const double turned = from_bits(bits_of(select(odd, cosine, sine)) ^ sine_flip);
    return {from_bits(bits_of(turned) ^ (bits_of(sign) & (std::uint64_t{1} << 63))),
            from_bits(bits_of(select(odd, sine, cosine)) ^ cosine_flip)};
}

// An angle in [0, pi/2], computed from its sine. The angle is pi/2 - 2 (root + rest) if `is_steep`
// is true, otherwise root + rest.
struct Arcsine {
    bool is_steep;
    double root;
    double rest;
};

// Returns asin s for s in [0, 1], or NaN for s > 1. Up to 1/2, asin s = s + s z A(z) with z = s².
// Above 1/2, asin s = pi/2 - 2 asin t with t² = z = (1 - s) / 2. In the second case, `root`
// consists of the upper bits of t, and `rest` is asin t - root.
[[gnu::always_inline]] inline Arcsine arcsine(double s) {
    constexpr std::array kArcsine = {0x1.5555555555578p-3,
                                     0x1.333333332df7cp-4,
                                     0x1.6db6db7226208p-5,
                                     0x1.f1c71a8dbc924p-6,
                                     0x1.6e8bdfa713e7ap-6,
                                     0x1.1c49e2b140f65p-6,
                                     0x1.ca20cee391f84p-7,
                                     0x1.757b743ac1a18p-7,
                                     0x1.61740f22dd775p-7,
                                     0x1.e2bd39f2c1a60p-9,
                                     0x1.649301bf9c932p-6,
                                     -0x1.5954dd5cea49ep-6,
                                     0x1.0bb07834d778dp-5};
    const bool is_steep = s > 0.5;
    const double z = is_steep ? 0.5 * (1.0 - s) : s * s;
    const double t = is_steep ? std::sqrt(z) : s;
    const double bend = t * z * polynomial(kArcsine, z);
    const double high = from_bits(bits_of(t) & ~std::uint64_t{0xffffffff});
    const double sum = t + high;
    const double low = (z - high * high) / (sum == 0.0 ? 1.0 : sum);
    return {is_steep, is_steep ? high : s, is_steep ? low + bend : bend};
}

}  // namespace detail

/// Returns sin x and cos x for |x| <= 2^20, each with an error below 0.8 ulp. Loops that call this
/// function can be vectorized.
[[gnu::always_inline]] inline SineAndCosine sincos_of_moderate(double x) {
    return detail::sine_and_cosine(detail::reduced(magnitude(x)), x);
}

/// Returns sin x and cos x, each with an error below 0.8 ulp.
inline SineAndCosine sincos(double x) {
    const double size = magnitude(x);
    if (size < 0.785) {  // below pi/4, so no reduction is needed
        return {with_sign(detail::sine_of_small({size, 0.0}).high, x),
                detail::cosine_of_small({size, 0.0}).high};
    }
    if (size > detail::kMaxModerateAngle) {
        return detail::sine_and_cosine(detail::reduced_large(size), x);
    }
    return sincos_of_moderate(x);
}

/// Return sin x and cos x with an error below 0.8 ulp.
inline double sin(double x) {
    return sincos(x).sine;
}
inline double cos(double x) {
    return sincos(x).cosine;
}

/// Returns tan x with an error below 1 ulp.
double tan(double x);

/// Returns asin x with an error below 0.8 ulp, or NaN for |x| > 1.
[[gnu::always_inline]] inline double asin(double x) {
    const detail::Arcsine s = detail::arcsine(magnitude(x));
    const double steep =
        (detail::kQuarterTurn.high - 2.0 * s.root) - (2.0 * s.rest - detail::kQuarterTurn.low);
    return with_sign(s.is_steep ? steep : s.root + s.rest, x);
}

/// Returns acos x with an error below 0.8 ulp, or NaN for |x| > 1.
double acos(double x);

/// Returns the angle of the vector (x, y), from -pi to pi, with an error below 1 ulp. For zeros and
/// infinities, the result depends on their signs as the C standard specifies.
double atan2(double y, double x);

/// Returns atan x with an error below 0.8 ulp.
inline double atan(double x) {
    return atan2(x, 1.0);
}

}  // namespace foam::ieee
