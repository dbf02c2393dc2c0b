// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/trigonometric.h"

#include <limits>

namespace foam::ieee {

namespace {

// The bits of 2/pi after the binary point, in words of 32 bits.
constexpr std::array<std::uint32_t, 38> kTwoOverPi = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};

constexpr int kMantissaBits = 52;

// Returns 64 bits of 2/pi, the first of which has the weight 2^-(first + 1).
std::uint64_t bits_of_two_over_pi(int first) {
    const auto word = [](int index) -> std::uint64_t {
        return index < 0 ? 0 : kTwoOverPi[static_cast<std::size_t>(index)];
    };
    const int index = first >= 0 ? first / 32 : (first - 31) / 32;
    const int shift = first - 32 * index;
    const std::uint64_t high = (word(index) << 32) | word(index + 1);
    return shift == 0 ? high : (high << shift) | (word(index + 2) >> (32 - shift));
}

// Returns the upper 64 bits of the product of two numbers of 64 bits.
std::uint64_t upper_product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t kLow = 0xffffffff;
    const std::uint64_t low = (a & kLow) * (b & kLow);
    const std::uint64_t middle = (a >> 32) * (b & kLow) + (low >> 32);
    const std::uint64_t other = (a & kLow) * (b >> 32) + (middle & kLow);
    return (a >> 32) * (b >> 32) + (middle >> 32) + (other >> 32);
}

// A number of quarter turns modulo 4, as a fixed-point number of 128 bits with two bits before the
// binary point.
struct QuarterTurns {
    std::uint64_t high;
    std::uint64_t low;
};

// Returns x * 2/pi modulo 4. The mantissa of x, an integer, is multiplied by 192 bits of 2/pi.
// Higher bits contribute only multiples of 4, and lower bits contribute too little to matter.
// Precondition: x is positive and normal.
QuarterTurns quarter_turns(double x) {
    const std::uint64_t mantissa = (bits_of(x) & ((std::uint64_t{1} << kMantissaBits) - 1)) |
                                   (std::uint64_t{1} << kMantissaBits);
    const int exponent = static_cast<int>(bits_of(x) >> kMantissaBits) - 1023 - kMantissaBits;
    const int first = exponent - 2;
    const std::uint64_t second = bits_of_two_over_pi(first + 64);
    const std::uint64_t third = upper_product(mantissa, bits_of_two_over_pi(first + 128));
    const std::uint64_t low = mantissa * second + third;
    const std::uint64_t carry = low < third ? 1 : 0;
    return {mantissa * bits_of_two_over_pi(first) + upper_product(mantissa, second) + carry, low};
}

}  // namespace

// Multiplies by 2/pi in fixed point (M. H. Payne and R. N. Hanek, "Radian reduction for
// trigonometric functions", 1983).
detail::ReducedAngle detail::reduced_large(double x) {
    if (!(x <= std::numeric_limits<double>::max())) {
        return {{std::numeric_limits<double>::quiet_NaN(), 0.0}, 0};
    }
    const QuarterTurns turns = quarter_turns(x);
    // `quarters` is the nearest whole number of quarter turns. `high` and `low` together become
    // `turns` minus `quarters`, as a signed number.
    const std::uint64_t quarters = (turns.high + (std::uint64_t{1} << 61)) >> 62;
    std::uint64_t high = turns.high << 2 | turns.low >> 62;
    std::uint64_t low = turns.low << 2;
    const bool is_negative = high >> 63 != 0;
    if (is_negative) {
        high = ~high + (low == 0 ? 1 : 0);
        low = 0 - low;
    }
    // The magnitude of the difference is the sum of four numbers of 32 bits, each of which a double
    // represents exactly.
    const double first = static_cast<double>(high >> 32) * 0x1p-32;
    const double second = static_cast<double>(high & 0xffffffff) * 0x1p-64;
    const double third = static_cast<double>(low >> 32) * 0x1p-96;
    const double fourth = static_cast<double>(low & 0xffffffff) * 0x1p-128;
    const TwoDoubles upper = ordered_sum(first, second);
    const TwoDoubles rest = ordered_sum(upper.high, upper.low + (third + fourth));
    const TwoDoubles angle = product(rest, kQuarterTurn);
    return {is_negative ? TwoDoubles{-angle.high, -angle.low} : angle, quarters & 3U};
}

double tan(double x) {
    const double size = magnitude(x);
    const detail::ReducedAngle reduced =
        size > detail::kMaxModerateAngle ? detail::reduced_large(size) : detail::reduced(size);
    const TwoDoubles sine = detail::sine_of_small(reduced.angle);
    const TwoDoubles cosine = detail::cosine_of_small(reduced.angle);
    const bool is_odd = reduced.quarters % 2 != 0;
    const TwoDoubles ratio =
        is_odd ? quotient(cosine, {-sine.high, -sine.low}) : quotient(sine, cosine);
    const double tangent = ratio.high + ratio.low;
    return with_sign(tangent, (tangent < 0.0) != std::signbit(x) ? -1.0 : 1.0);
}

double acos(double x) {
    const detail::Arcsine s = detail::arcsine(magnitude(x));
    constexpr TwoDoubles kQuarter = detail::kQuarterTurn;
    if (!s.is_steep) {
        const double rest = std::signbit(x) ? -s.rest : s.rest;
        return kQuarter.high - (x - (kQuarter.low - rest));
    }
    return std::signbit(x) ? 2.0 * ((kQuarter.high - s.root) - (s.rest - kQuarter.low))
                           : 2.0 * (s.root + s.rest);
}

namespace {

// Returns atan q - q for q in [-1/3, 1/2], computed as -q z T(z) with z = q². The polynomial T has
// the coefficients kArctangent.
double arctangent_bend(double q) {
    constexpr std::array kArctangent = {0x1.5555555555518p-2,
                                        -0x1.99999999914cbp-3,
                                        0x1.249249216fa4cp-3,
                                        -0x1.c71c70967a279p-4,
                                        0x1.745cf54d20b00p-4,
                                        -0x1.3b114533c86a2p-4,
                                        0x1.10f366ba3e43bp-4,
                                        -0x1.dfed0bbf15742p-5,
                                        0x1.a3a77a25c396fp-5,
                                        -0x1.571e0344f78e5p-5,
                                        0x1.c1fb0f5e31cccp-6,
                                        -0x1.4c290d1f9781ap-7};
    const double z = q * q;
    return -q * z * polynomial(kArctangent, z);
}

// Returns `count` times pi/4, for a count from 0 to 4.
TwoDoubles eighth_turns(int count) {
    constexpr TwoDoubles kThree = {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54};
    return count == 3 ? kThree
                      : TwoDoubles{0.5 * count * detail::kQuarterTurn.high,
                                   0.5 * count * detail::kQuarterTurn.low};
}

// Returns (ratio - 1) / (ratio + 1).
TwoDoubles folded(const TwoDoubles& ratio) {
    const TwoDoubles less = ordered_sum(ratio.high - 1.0, ratio.low);
    const TwoDoubles more = exact_sum(ratio.high, 1.0);
    return quotient(less, ordered_sum(more.high, more.low + ratio.low));
}

// Returns small / large for 0 <= small <= large. The ratio is 1 if both are infinite, and 0 if both
// are 0.
TwoDoubles ratio_of(double small, double large) {
    if (small < 0x1p-60 * large || small == 0.0) {
        return {large == 0.0 ? 0.0 : small / large, 0.0};
    }
    if (small > std::numeric_limits<double>::max()) {
        return {1.0, 0.0};
    }
    // The scale prevents products that overflow or underflow.
    const double scale = large > 0x1p500 ? 0x1p-600 : large < 0x1p-400 ? 0x1p600 : 1.0;
    return quotient({scale * small, 0.0}, {scale * large, 0.0});
}

}  // namespace

// Symmetries map the angle to the first eighth of a turn, where it is the arctangent of a ratio r
// in [0, 1]. If r is above 1/2, atan r = pi/4 + atan((r - 1) / (r + 1)) is used.
double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double up = magnitude(y);
    const double right = magnitude(x);
    const bool is_swapped = up > right;
    TwoDoubles ratio = is_swapped ? ratio_of(right, up) : ratio_of(up, right);
    const bool is_folded = ratio.high > 0.5;
    if (is_folded) {
        ratio = folded(ratio);
    }
    int eighths = is_folded ? 1 : 0;
    double sign = 1.0;
    if (is_swapped) {
        eighths = 2 - eighths;
        sign = -sign;
    }
    if (std::signbit(x)) {
        eighths = 4 - eighths;
        sign = -sign;
    }
    const TwoDoubles start = eighth_turns(eighths);
    const TwoDoubles sum = exact_sum(start.high, sign * ratio.high);
    const double low = sign * (ratio.low + arctangent_bend(ratio.high));
    return with_sign(sum.high + (sum.low + (start.low + low)), y);
}

}  // namespace foam::ieee
