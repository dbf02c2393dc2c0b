// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/value.h"

#include "texgen/preset/assignment.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

namespace foam::texgen {
namespace {

TEST(Value, IsWrittenAsToml) {
    EXPECT_EQ(to_toml({std::int64_t{-3}}), "-3");
    EXPECT_EQ(to_toml({true}), "true");
    EXPECT_EQ(to_toml({0.1}), "0.1");
    EXPECT_EQ(to_toml({std::string("a \"b\"\\\n\x01")}), R"("a \"b\"\\\n\u0001")");
    EXPECT_EQ(to_toml({std::string("\xFF")}), "\"\xEF\xBF\xBD\"");
    EXPECT_EQ(to_toml({Value::List{{std::int64_t{1}}, {std::string("a")}}}), R"([1, "a"])");
}

TEST(Value, ARealNeverLooksLikeAnInteger) {
    EXPECT_EQ(to_toml({1.0}), "1.0");
    EXPECT_EQ(to_toml({-0.0}), "-0.0");
    EXPECT_EQ(to_toml({1e300}), "1e+300");
}

RC_GTEST_PROP(Value, RealsRoundTripBitForBit, (double real)) {
    const Value back = read_value(to_toml({real}));
    RC_ASSERT(std::get<double>(back.data) == real);
}

// Tests all ASCII characters except NUL, which no command-line argument and no file name can
// contain.
RC_GTEST_PROP(Value, TextsRoundTrip, ()) {
    const auto text = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
    const Value back = read_value(to_toml({text}));
    RC_ASSERT(std::get<std::string>(back.data) == text);
}

}  // namespace
}  // namespace foam::texgen
