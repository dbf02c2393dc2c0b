// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/number_text.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace foam::texgen {
namespace {

TEST(NumberText, LengthsHaveNineDecimalsWithoutTrailingZeros) {
    EXPECT_EQ(length_text(0.1), "0.1");
    EXPECT_EQ(length_text(100.0), "100");
    EXPECT_EQ(length_text(1.0 / 3.0), "0.333333333");
    EXPECT_EQ(length_text(-2.5), "-2.5");
}

TEST(NumberText, TinyLengthsAreZeroWithoutASign) {
    EXPECT_EQ(length_text(1e-12), "0");
    EXPECT_EQ(length_text(-1e-12), "0");
}

TEST(NumberText, LargeLengthsHaveFewerDecimalsAndNoExponent) {
    EXPECT_EQ(length_text(12345.678901234567), "12345.6789012");
    EXPECT_EQ(length_text(1e15), "1000000000000000");
}

TEST(NumberText, ExactTextsAreReadBackWithoutLoss) {
    for (const double number : {1.0 / 3.0, 6.02e23, -1e-300, 0.0}) {
        EXPECT_EQ(std::strtod(exact_text(number).c_str(), nullptr), number);
    }
    EXPECT_EQ(exact_text(0.1), "0.1");
}

}  // namespace
}  // namespace foam::texgen
