// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

// The arithmetic of which the elementary functions (trigonometric.h, exponential.h) consist. All
// functions are free of branches and are inlined, so that loops that call them can be vectorized.

namespace foam::ieee {

/// A number that is stored as the sum of two doubles. `high` is close to the number, `low` is the
/// number minus `high`.
struct TwoDoubles {
    double high = 0.0;
    double low = 0.0;
};

/// A constant that rounds doubles to integers: x + kRounder - kRounder is x rounded to the nearest
/// integer, for |x| < 2^51. The lowest bits of x + kRounder are the bits of this integer.
inline constexpr double kRounder = 0x1.8p52;

[[gnu::always_inline]] inline std::uint64_t bits_of(double x) {
    return std::bit_cast<std::uint64_t>(x);
}

[[gnu::always_inline]] inline double from_bits(std::uint64_t bits) {
    return std::bit_cast<double>(bits);
}

/// Returns |x|.
[[gnu::always_inline]] inline double magnitude(double x) {
    return from_bits(bits_of(x) & ~(std::uint64_t{1} << 63));
}

/// Returns |x| with the sign of `sign`.
[[gnu::always_inline]] inline double with_sign(double x, double sign) {
    constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
    return from_bits((bits_of(x) & ~kSign) | (bits_of(sign) & kSign));
}

/// Returns a if `first` is 1, or b if it is 0.
[[gnu::always_inline]] inline double select(std::uint64_t first, double a, double b) {
    const std::uint64_t mask = 0 - first;
    return from_bits((bits_of(a) & mask) | (bits_of(b) & ~mask));
}

/// Returns 2^exponent. Precondition: the exponent is a whole number from -1022 to 1023.
[[gnu::always_inline]] inline double power_of_two(double exponent) {
    return from_bits(bits_of(exponent + (kRounder + 1023.0)) << 52);
}

/// Returns a + b exactly (T. J. Dekker, "A floating-point technique for extending the available
/// precision", 1971). Precondition: |a| >= |b| or a = 0.
[[gnu::always_inline]] inline TwoDoubles ordered_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// Returns a + b exactly (D. E. Knuth, "The Art of Computer Programming", volume 2, 4.2.2).
[[gnu::always_inline]] inline TwoDoubles exact_sum(double a, double b) {
    const double sum = a + b;
    const double second = sum - a;
    return {sum, (a - (sum - second)) + (b - second)};
}

/// Returns a * b exactly, unless `low` underflows (Dekker, with G. W. Veltkamp's splitting of each
/// factor into halves of 26 bits). Precondition: |a|, |b| < 2^995, and a * b does not overflow.
[[gnu::always_inline]] inline TwoDoubles exact_product(double a, double b) {
    constexpr double kSplitter = 0x1p27 + 1.0;
    const double a_scaled = kSplitter * a;
    const double b_scaled = kSplitter * b;
    const double a_high = a_scaled - (a_scaled - a);
    const double b_high = b_scaled - (b_scaled - b);
    const double a_low = a - a_high;
    const double b_low = b - b_high;
    const double product = a * b;
    const double error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high);
    return {product, error + a_low * b_low};
}

/// Returns a * b with a relative error of about 2^-103.
[[gnu::always_inline]] inline TwoDoubles product(const TwoDoubles& a, const TwoDoubles& b) {
    const TwoDoubles high = exact_product(a.high, b.high);
    return ordered_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

/// Returns a / b with a relative error of about 2^-103.
[[gnu::always_inline]] inline TwoDoubles quotient(const TwoDoubles& a, const TwoDoubles& b) {
    const double inverse = 1.0 / b.high;
    const double high = a.high * inverse;
    const TwoDoubles back = exact_product(high, b.high);
    const double rest = ((a.high - back.high) - back.low) + (a.low - high * b.low);
    return {high, rest * inverse};
}

/// Returns the value of a polynomial at x. `coefficients` begins with the constant term. The terms
/// of even and of odd powers are summed separately, so that the two chains of dependent operations
/// overlap.
template <std::size_t Size>
[[gnu::always_inline]] inline double polynomial(const std::array<double, Size>& coefficients,
                                                double x) {
    const double square = x * x;
    double sums[2] = {coefficients[Size - 1], coefficients[Size - 2]};
    // Horner's scheme for the remaining coefficients, from the last to the first. The fold
    // expression unrolls the loop.
    [&]<std::size_t... Term>(std::index_sequence<Term...>) {
        ((sums[Term % 2] = sums[Term % 2] * square + coefficients[Size - 3 - Term]), ...);
    }
    (std::make_index_sequence<Size - 2>{});
    const double even = Size % 2 == 0 ? sums[1] : sums[0];
    const double odd = Size % 2 == 0 ? sums[0] : sums[1];
    return even + x * odd;
}

}  // namespace foam::ieee
