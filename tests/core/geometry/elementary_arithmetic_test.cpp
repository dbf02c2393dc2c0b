// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/elementary_arithmetic.h"

#include "tests/core/geometry/ulp_error.h"

#include <gtest/gtest.h>

#include <array>

namespace foam {
namespace {

using test::Draws;
using test::Reference;

// Returns |high + low - exact| relative to |exact|, where `exact` has 160 bits.
double relative_error(const ieee::TwoDoubles& number, Reference& exact) {
    Reference difference(test::kReferenceBits);
    mpfr_sub_d(difference.get(), exact.get(), number.high, MPFR_RNDN);
    mpfr_sub_d(difference.get(), difference.get(), number.low, MPFR_RNDN);
    mpfr_div(difference.get(), difference.get(), exact.get(), MPFR_RNDN);
    return std::abs(mpfr_get_d(difference.get(), MPFR_RNDN));
}

TEST(ElementaryArithmetic, SumsAndProductsAreExact) {
    Draws draws;
    Reference exact(test::kReferenceBits);
    for (int k = 0; k < 10000; ++k) {
        const double a = draws.between(-1.0, 1.0);
        const double b = draws.between(-1e-3, 1e3);
        mpfr_add(exact.get(), Reference(a).get(), Reference(b).get(), MPFR_RNDN);
        EXPECT_EQ(relative_error(ieee::exact_sum(a, b), exact), 0.0);
        mpfr_mul(exact.get(), Reference(a).get(), Reference(b).get(), MPFR_RNDN);
        EXPECT_EQ(relative_error(ieee::exact_product(a, b), exact), 0.0);
    }
}

TEST(ElementaryArithmetic, QuotientsHaveTwiceThePrecision) {
    Draws draws;
    Reference exact(test::kReferenceBits);
    for (int k = 0; k < 10000; ++k) {
        const double a = draws.between(0.0, 1.0);
        const double b = draws.between(1e-3, 1e3);
        mpfr_div(exact.get(), Reference(a).get(), Reference(b).get(), MPFR_RNDN);
        EXPECT_LT(relative_error(ieee::quotient({a, 0.0}, {b, 0.0}), exact), 0x1p-101);
    }
}

TEST(ElementaryArithmetic, EvaluatesPolynomialsOfEvenAndOddDegree) {
    EXPECT_EQ(ieee::polynomial(std::array{1.0, 2.0, 3.0}, 10.0), 321.0);
    EXPECT_EQ(ieee::polynomial(std::array{1.0, 2.0, 3.0, 4.0}, 10.0), 4321.0);
    EXPECT_EQ(ieee::polynomial(std::array{1.0, 2.0, 3.0, 4.0, 5.0}, 10.0), 54321.0);
}

TEST(ElementaryArithmetic, SelectsAndScales) {
    EXPECT_EQ(ieee::select(1, 2.0, 3.0), 2.0);
    EXPECT_EQ(ieee::select(0, 2.0, 3.0), 3.0);
    EXPECT_EQ(ieee::power_of_two(-1022.0), 0x1p-1022);
    EXPECT_EQ(ieee::power_of_two(1023.0), 0x1p1023);
    EXPECT_EQ(ieee::with_sign(2.0, -0.0), -2.0);
    EXPECT_EQ(ieee::magnitude(-2.0), 2.0);
}

}  // namespace
}  // namespace foam
