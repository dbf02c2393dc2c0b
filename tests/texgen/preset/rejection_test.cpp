// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/rejection.h"

#include "tests/texgen/preset/rejection.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Assignment assignment(const std::string& location, const std::string& key) {
    return {location, key, {std::int64_t{3}}};
}

TEST(Rejection, NamesLocationKeyValueAndReason) {
    EXPECT_EQ(test::rejection_of([] { reject(assignment("a.toml:4", "foam.seed"), "too odd"); }),
              "a.toml:4: key 'foam.seed' = 3: too odd");
}

// In TOML the value begins with a quote and 58 letters. The 60th character is a letter of two
// bytes, which a cut after 60 bytes would split.
TEST(Rejection, CutsALongValueAtAWholeCharacter) {
    const Assignment longest{"a", "k", {fmt::format("{:x<58}\u00e4{:y<40}", "", "")}};
    EXPECT_EQ(test::rejection_of([&] { reject(longest, "r"); }),
              fmt::format("a: key 'k' = \"{:x<58}\u00e4...: r", ""));
}

TEST(Rejection, BlamesTheLastAssignmentThatMatters) {
    const std::vector<Assignment> all{
        assignment("1", "a"), assignment("2", "b"), assignment("3", "a"), assignment("4", "c")};
    EXPECT_EQ(test::rejection_of([&] { reject_last(all, {"a", "b"}, "r"); }).front(), '3');
    EXPECT_EQ(test::rejection_of([&] { reject_last(all, {"d"}, "r"); }).front(), '4');
}

TEST(Rejection, OfAValueSuggestsTheWordThatWasMeant) {
    KeyInfo key;
    key.allowed = "a lamp";
    key.words = {"red", "green"};
    const auto message = [&](const Value& value) {
        return test::rejection_of([&] { reject_value({"a", "lamp.color", value}, key); });
    };
    EXPECT_EQ(message({std::string("gren")}),
              "a: key 'lamp.color' = \"gren\": must be a lamp; did you mean 'green'?");
    EXPECT_EQ(message({Value::List{{std::string("red")}, {std::string("gren")}}}),
              "a: key 'lamp.color' = [\"red\", \"gren\"]: must be a lamp; did you mean 'green'?");
    EXPECT_EQ(message({std::string("blue")}), "a: key 'lamp.color' = \"blue\": must be a lamp");
    EXPECT_EQ(message({std::int64_t{3}}), "a: key 'lamp.color' = 3: must be a lamp");
}

TEST(Rejection, SuggestsTheKeyThatWasMeant) {
    EXPECT_EQ(test::rejection_of([] { reject_unknown(assignment("a", "sed"), "foam.seed"); }),
              "a: key 'sed' = 3: unknown key; did you mean 'foam.seed'?");
    EXPECT_EQ(test::rejection_of([] {
                  reject_unknown({"a", "beer", {Value::Table{}}}, "");
              }),
              "a: key 'beer' = {...}: unknown table; 'foamtex presets keys' lists all keys");
}

}  // namespace
}  // namespace foam::texgen
