// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/exponential.h"

#include "tests/core/geometry/ulp_error.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::Draws;
using test::kInfinity;
using test::kTiny;
using test::largest_error;

constexpr double kLargest = std::numeric_limits<double>::max();

double exponential(double x) {
    return ieee::exp(x);
}

// The errors below were measured with 25 times as many arguments or more. They are at most 0.83 for
// the exponential function and for powers, and 0.501 for logarithms.
TEST(Exponential, PowersHaveSmallErrors) {
    Draws draws;
    EXPECT_LT(largest_error(exponential, mpfr_exp, [&] { return draws.between(-1.0, 1.0); }), 0.85);
    EXPECT_LT(largest_error(exponential, mpfr_exp, [&] { return draws.between(-708.0, 709.7); }),
              0.85);
    EXPECT_LT(largest_error(exponential, mpfr_exp, [&] { return draws.between(-745.0, -708.0); }),
              1.0);
    const auto fraction = [&] { return draws.between(0.0, 1.0); };
    EXPECT_LT(largest_error(ieee::pow, mpfr_pow, fraction, [&] { return draws.between(0.0, 5.0); }),
              0.85);
    EXPECT_LT(largest_error(
                  ieee::pow,
                  mpfr_pow,
                  [&] { return draws.between(0.0, 100.0); },
                  [&] { return draws.between(-150.0, 150.0); }),
              0.85);
    EXPECT_LT(largest_error(
                  ieee::pow,
                  mpfr_pow,
                  [&] { return draws.between(0.999, 1.001); },
                  [&] { return draws.between(-7e5, 7e5); }),
              0.85);
    EXPECT_LT(largest_error(
                  ieee::pow,
                  mpfr_pow,
                  [&] { return std::abs(draws.any()); },
                  [&] { return draws.between(-0.9, 0.9); }),
              0.85);
}

TEST(Exponential, LogarithmsHaveSmallErrors) {
    Draws draws;
    const auto any = [&] { return std::abs(draws.any()); };
    const auto near_one = [&] { return draws.between(0.5, 2.0); };
    const auto below_one = [&] { return 1.0 - std::exp2(draws.between(-53.0, -1.0)); };
    EXPECT_LT(largest_error(ieee::log, mpfr_log, any), 0.51);
    EXPECT_LT(largest_error(ieee::log, mpfr_log, near_one), 0.51);
    EXPECT_LT(largest_error(ieee::log, mpfr_log, below_one), 0.51);
    EXPECT_LT(largest_error(ieee::log2, mpfr_log2, any), 0.51);
    EXPECT_LT(largest_error(ieee::log2, mpfr_log2, near_one), 0.51);
    EXPECT_LT(largest_error(ieee::log10, mpfr_log10, any), 0.51);
    EXPECT_LT(largest_error(ieee::log10, mpfr_log10, near_one), 0.51);
}

TEST(Exponential, RepresentableResultsAreExact) {
    double power = 1.0;
    for (int k = 0; k <= 22; ++k) {
        EXPECT_EQ(ieee::pow(10.0, k), power);
        EXPECT_EQ(ieee::log10(power), k);
        power *= 10.0;
    }
    for (int k = -1074; k <= 1023; ++k) {
        EXPECT_EQ(ieee::pow(2.0, k), std::ldexp(1.0, k));
        EXPECT_EQ(ieee::log2(std::ldexp(1.0, k)), k);
    }
    EXPECT_EQ(ieee::pow(0.25, 0.5), 0.5);
    EXPECT_EQ(ieee::pow(-3.0, 3.0), -27.0);
}

TEST(Exponential, SpecialValuesAreThoseOfTheStandard) {
    EXPECT_EQ(ieee::exp(0.0), 1.0);
    EXPECT_EQ(ieee::exp(-0.0), 1.0);
    EXPECT_EQ(ieee::exp(710.0), kInfinity);
    EXPECT_EQ(ieee::exp(kInfinity), kInfinity);
    EXPECT_EQ(ieee::exp(-746.0), 0.0);
    EXPECT_EQ(ieee::exp(-kInfinity), 0.0);
    EXPECT_TRUE(std::isnan(ieee::exp(std::nan(""))));
    EXPECT_TRUE(are_same(ieee::log(1.0), 0.0));
    EXPECT_EQ(ieee::log(0.0), -kInfinity);
    EXPECT_EQ(ieee::log(kInfinity), kInfinity);
    EXPECT_TRUE(std::isnan(ieee::log(-1.0)));
    EXPECT_TRUE(std::isnan(ieee::log(std::nan(""))));
}

// The C standard defines powers of zeros, infinities, NaN and negative numbers.
TEST(Exponential, SpecialPowersAreThoseOfTheStandard) {
    const std::vector<double> numbers = {0.0,
                                         -0.0,
                                         1.0,
                                         -1.0,
                                         2.0,
                                         -2.0,
                                         3.0,
                                         -3.0,
                                         0.5,
                                         -0.5,
                                         kTiny,
                                         -kTiny,
                                         kLargest,
                                         -kLargest,
                                         kInfinity,
                                         -kInfinity,
                                         std::nan("")};
    for (const double x : numbers) {
        for (const double y : numbers) {
            const double expected = std::pow(x, y);
            const double found = ieee::pow(x, y);
            EXPECT_TRUE(are_same(found, expected) ||
                        std::abs(found - expected) <= 2.3e-16 * std::abs(expected))
                << x << " to the power of " << y << ": " << found;
        }
    }
}

TEST(Exponential, IsMonotonic) {
    Draws draws;
    for (int k = 0; k < 10000; ++k) {
        const double x = draws.between(-5.0, 5.0);
        EXPECT_LE(ieee::exp(x), ieee::exp(x + 1e-15 * std::abs(x)));
        const double y = draws.between(0.1, 5.0);
        EXPECT_LE(ieee::log(y), ieee::log(std::nextafter(y, kInfinity)));
    }
}

}  // namespace
}  // namespace foam
