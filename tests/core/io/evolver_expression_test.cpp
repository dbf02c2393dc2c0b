// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_expression.h"

#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::evolver {
namespace {

const std::string file_name = "a.fe";
const Parameters known{{"width", 3.0}, {"e1", 0.25}};

double value_of(std::string_view text) {
    TokenReader reader(text, file_name);
    return take_expression(reader, known);
}

void expect_rejected(std::string_view text, const std::string& what) {
    test::expect_format_error([&] { value_of(text); }, what);
}

TEST(EvolverExpression, ObeysPrecedence) {
    EXPECT_EQ(value_of("1 + 2*3"), 7.0);
    EXPECT_EQ(value_of("12/2/3"), 2.0);
    EXPECT_EQ(value_of("2^3^2"), 512.0);
    EXPECT_EQ(value_of("-2^2"), -4.0);
    EXPECT_EQ(value_of("2*-3"), -6.0);
    EXPECT_EQ(value_of("2^-1"), 0.5);
    EXPECT_EQ(value_of("(1 -2)*(3+1)"), -4.0);
}

TEST(EvolverExpression, ReadsParametersConstantsAndFunctions) {
    EXPECT_EQ(value_of("2*WIDTH + e1"), 6.25);
    EXPECT_EQ(value_of("cos(pi)"), -1.0);
    EXPECT_EQ(value_of("log(e)"), 1.0);
    EXPECT_EQ(value_of("sqrt(1 + sqr(width) - 1)"), 3.0);
    EXPECT_EQ(value_of("exp(abs(-1))"), std::numbers::e);
    EXPECT_DOUBLE_EQ(value_of("asin(sin(0.3)) + acos(cos(0.4)) + atan(tan(0.5))"), 1.2);
}

TEST(EvolverExpression, ASignBehindSpaceBeginsTheNext) {
    TokenReader reader("1 -2 +3 - 1\n-4", file_name);
    EXPECT_EQ(take_expression(reader, {}), 1.0);
    EXPECT_EQ(take_expression(reader, {}), -2.0);
    EXPECT_EQ(take_expression(reader, {}), 2.0);
    EXPECT_EQ(take_expression(reader, {}), -4.0);
    EXPECT_TRUE(reader.at_end());
}

TEST(EvolverExpression, RejectsMalformedExpressions) {
    expect_rejected("depth", "a.fe:1: expected a number, a parameter or a function, found 'depth'");
    expect_rejected("(1", "a.fe:1: expected ')', found the end of the file");
    expect_rejected("sin 1", "a.fe:1: expected '(', found '1'");
    expect_rejected("2*", "a.fe:1: expected a number, found the end of the file");
}

TEST(EvolverExpression, RejectsValuesThatAreNotFinite) {
    for (const char* text : {"1/0", "1e999", "log(-1)", "1e300*1e300", "0xffffffffffffffffff"}) {
        expect_rejected(text, "a.fe:1: expected a finite number");
    }
}

TEST(EvolverExpression, DeepNestingIsAnError) {
    for (const char* opening : {"(", "-", "2^"}) {
        std::string text;
        for (int k = 0; k < 100000; ++k) {
            text += opening;
        }
        expect_rejected(text, "a.fe:1: the expression is nested more than 100 levels deep");
    }
}

}  // namespace
}  // namespace foam::evolver
