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

// 59 letters and a letter of two bytes: cut before it, since 60 bytes would halve it. The first of
// the 60 is the quote.
TEST(Rejection, CutsALongValueAtAWholeCharacter) {
    const Assignment longest{"a", "k", {fmt::format("{:x<58}\u00e4{:y<40}", "", "")}};
    EXPECT_EQ(test::rejection_of([&] { reject(longest, "r"); }),
              fmt::format("a: key 'k' = \"{:x<58}...: r", ""));
}

TEST(Rejection, BlamesTheLastAssignmentThatMatters) {
    const std::vector<Assignment> all{
        assignment("1", "a"), assignment("2", "b"), assignment("3", "a"), assignment("4", "c")};
    EXPECT_EQ(test::rejection_of([&] { reject_last(all, {"a", "b"}, "r"); }).front(), '3');
    EXPECT_EQ(test::rejection_of([&] { reject_last(all, {"d"}, "r"); }).front(), '4');
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
