// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/key_values.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

std::string text_of(const std::variant<Value, NumberRange>& part) {
    if (const auto* const value = std::get_if<Value>(&part)) {
        return to_toml(*value);
    }
    const auto& range = std::get<NumberRange>(part);
    return to_toml(number_value(range.low)) + ".." + to_toml(number_value(range.high)) +
           (range.count ? ":" + std::to_string(*range.count) : "");
}

std::string parsed(const std::string& text) {
    const KeyValues values = parse_key_values(text);
    std::string all = values.key;
    for (const auto& part : values.values) {
        all += " | " + text_of(part);
    }
    return all;
}

TEST(KeyValues, AreSeparatedByCommasOutsideOfBracketsAndQuotes) {
    EXPECT_EQ(parsed("foam.lloyd=0,1, 4"), "foam.lloyd | 0 | 1 | 4");
    EXPECT_EQ(parsed("a.b=[1, 2],[3, 4]"), "a.b | [1, 2] | [3, 4]");
    EXPECT_EQ(parsed("a.b=\"x, y\",z"), "a.b | \"x, y\" | \"z\"");
    EXPECT_EQ(parsed("a.b=\n  [\"#112233\"],\n  [\"#445566\"]\n"),
              "a.b | [\"#112233\"] | [\"#445566\"]");
}

TEST(KeyValues, MayContainEscapedQuotes) {
    EXPECT_EQ(parsed(R"(a.b="x\",y",z)"), R"(a.b | "x\",y" | "z")");
    EXPECT_EQ(parsed(R"(a.b='x\','y')"), R"(a.b | "x\\" | "y")");
    EXPECT_EQ(parsed(R"(a.b=["x\"]", 1],2)"), R"(a.b | ["x\"]", 1] | 2)");
}

TEST(KeyValues, SpacesAroundTheKeyAreIgnored) {
    EXPECT_EQ(parsed(" foam.lloyd = 0, 1"), "foam.lloyd | 0 | 1");
}

TEST(KeyValues, MayBeRanges) {
    EXPECT_EQ(parsed("loop.amplitude=0.1..0.4,0.9,1..2:5"),
              "loop.amplitude | 0.1..0.4 | 0.9 | 1..2:5");
    EXPECT_EQ(parsed("a.b=\"../x.png\",'0..1'"), "a.b | \"../x.png\" | \"0..1\"");
}

TEST(KeyValues, NumbersOfARangeAreEvenlySpacedAndShort) {
    const std::vector<Value> numbers = numbers_of({.low = 0.1, .high = 0.4, .count = 4});
    ASSERT_EQ(numbers.size(), 4U);
    EXPECT_EQ(to_toml(numbers[2]), "0.3");
    EXPECT_EQ(to_toml(numbers_of({.low = 4, .high = 0, .count = 3})[1]), "2");
}

// Seeds may have many digits. Whole numbers from 2^53 on may be rounded already.
TEST(KeyValues, LargeWholeNumbersAreExact) {
    const std::vector<Value> seeds =
        numbers_of({.low = 1'000'000'000'001.0, .high = 1'000'000'000'003.0, .count = 3});
    EXPECT_EQ(to_toml(seeds[0]), "1000000000001");
    EXPECT_EQ(to_toml(seeds[1]), "1000000000002");
    EXPECT_EQ(to_toml(number_value(999'999'999'999.7)), "1000000000000");
    EXPECT_EQ(to_toml(number_value(0x1p53 - 1.0)), "9007199254740991");
    EXPECT_FALSE(std::holds_alternative<std::int64_t>(number_value(0x1p53).data));
}

TEST(KeyValues, AMalformedTextIsRejected) {
    for (const char* text : {"foam.lloyd",
                             "=3",
                             " =3",
                             "a.b=",
                             "a.b=1,,2",
                             "a.b=1, ",
                             "a.b=0..1:1",
                             "a.b=x..1",
                             "a.b=0..1:",
                             "a.b=0..1:401",
                             "a.b=..",
                             "a.b=0..inf"}) {
        EXPECT_THROW(parse_key_values(text), std::invalid_argument) << text;
    }
}

}  // namespace
}  // namespace foam::texgen
