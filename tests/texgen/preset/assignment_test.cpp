// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/assignment.h"

#include "tests/texgen/preset/rejection.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns a line "LOCATION KEY = VALUE" for each assignment.
std::string flat(const std::vector<Assignment>& assignments) {
    std::string lines;
    for (const Assignment& a : assignments) {
        lines += a.location + " " + a.key + " = " + to_toml(a.value) + "\n";
    }
    return lines;
}

std::string failure(const std::string& toml) {
    return test::rejection_of([&] { read_assignments(toml, "a.toml"); });
}

TEST(Assignment, TablesAreFlattenedInTheOrderOfTheFile) {
    EXPECT_EQ(flat(read_assignments("[b]\nz = 1\na = [2, 3.5]\n\n[a]\nx = \"t\"\n", "f")),
              "f:1 b = {...}\n"
              "f:2 b.z = 1\n"
              "f:3 b.a = [2, 3.5]\n"
              "f:5 a = {...}\n"
              "f:6 a.x = \"t\"\n");
}

/// Returns a.a.a and so on.
std::string key_of_parts(int count) {
    std::string key = "a";
    for (int k = 1; k < count; ++k) {
        key += ".a";
    }
    return key;
}

// toml++ would need more stack than there is for longer keys.
TEST(Assignment, KeysHaveALimitedNumberOfParts) {
    const std::string long_key = key_of_parts(200'001);
    const std::string reason = "malformed TOML: a key must have at most 32 parts";
    EXPECT_EQ(failure("b = \"x.y\" # z.\n" + long_key + " = 1"), "a.toml:2: " + reason);
    EXPECT_EQ(failure("[" + long_key + "]\nb = 1"), "a.toml:1: " + reason);
    EXPECT_EQ(failure("c = \"\"\"x\\\ny\"\"\"\n" + long_key + " = 1"), "a.toml:3: " + reason);
    EXPECT_EQ(read_value("{" + long_key + " = 1}").data.index(), Value{std::string()}.data.index());
    const std::string dots(100, '.');
    EXPECT_EQ(flat(read_assignments("a = \"" + dots + "\\\"" + dots + "\" # " + dots, "f")),
              "f:1 a = \"" + dots + "\\\"" + dots + "\"\n");
}

// Periods in a string of several lines are no parts of keys. One or two quotes before the three
// that close the string belong to its content.
TEST(Assignment, StringsOfSeveralLinesMayHavePeriods) {
    std::string periods;
    for (int k = 0; k < 40; ++k) {
        periods += "a. ";
    }
    for (const char quote : {'"', '\''}) {
        const std::string quotes(3, quote);
        for (std::size_t extra = 0; extra < 3; ++extra) {
            const std::string content = periods + std::string(extra, quote);
            const std::string text = "a = " + quotes + "x\n" + content + quotes + "\n";
            const auto found = read_assignments(text + "b = 1\n", "f");
            ASSERT_EQ(found.size(), 2U) << text;
            EXPECT_EQ(std::get<std::string>(found[0].value.data), "x\n" + content);
            EXPECT_EQ(failure(text + key_of_parts(33) + " = 1"),
                      "a.toml:3: malformed TOML: a key must have at most 32 parts")
                << text;
        }
    }
    // Escaped quotes do not close a string.
    EXPECT_EQ(read_assignments("a = \"\"\"\\\"\"\"" + periods + "\"\"\"", "f").size(), 1U);
}

TEST(Assignment, KeysThatTomlWouldQuoteStayQuoted) {
    EXPECT_EQ(flat(read_assignments("\"foam.seed\" = 1\n", "f")), "f:1 \"foam.seed\" = 1\n");
}

TEST(Assignment, DatesAreCarriedAsTheyAre) {
    EXPECT_EQ(flat(read_assignments("d = 2020-01-02\n", "f")), "f:1 d = 2020-01-02\n");
}

TEST(Assignment, MalformedTomlIsOneLineWithItsLocation) {
    for (const char* toml : {"[foam]\nbubbles = \n", "[foam]\nx = 1\nx = 2\n", "a b", "\xff"}) {
        const std::string message = failure(toml);
        EXPECT_EQ(message.find("a.toml:"), 0U) << message;
        EXPECT_NE(message.find(": malformed TOML: "), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
    EXPECT_EQ(failure("[foam]\nbubbles = \n").substr(0, 9), "a.toml:2:");
}

TEST(Assignment, SetTakesTomlOrBareText) {
    const auto set = [](const std::string& argument) {
        return flat({read_set_argument(argument)});
    };
    EXPECT_EQ(set("foam.seed=3"), "--set foam.seed=3 foam.seed = 3\n");
    EXPECT_EQ(set("a.b=[5,6]"), "--set a.b=[5,6] a.b = [5, 6]\n");
    EXPECT_EQ(set("a.b=magma"), "--set a.b=magma a.b = \"magma\"\n");
    EXPECT_EQ(set("a.b=\"magma\""), "--set a.b=\"magma\" a.b = \"magma\"\n");
    EXPECT_EQ(set("a.b=#ffffff"), "--set a.b=#ffffff a.b = \"#ffffff\"\n");
    EXPECT_EQ(set("a.b=x=y"), "--set a.b=x=y a.b = \"x=y\"\n");
    EXPECT_EQ(set("a.b="), "--set a.b= a.b = \"\"\n");
}

TEST(Assignment, RejectsAValueThatContainsASecondKey) {
    const Value value = read_value("1\nother = 2");
    EXPECT_EQ(std::get<std::string>(value.data), "1\nother = 2");
}

// The entries of a table would be lost.
TEST(Assignment, SetTakesATableAsText) {
    EXPECT_EQ(to_toml(read_set_argument("a={b = 1}").value), "\"{b = 1}\"");
    EXPECT_EQ(to_toml(read_set_argument("a={}").value), "\"{}\"");
}

TEST(Assignment, SetWithoutKeyOrEqualsIsRejected) {
    EXPECT_THROW(read_set_argument("foam.seed"), PresetError);
    EXPECT_THROW(read_set_argument("=3"), PresetError);
    EXPECT_THROW(read_set_argument("preset.description=\xFF"), PresetError);
}

}  // namespace
}  // namespace foam::texgen
