// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/parsed_texts.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

// Accepts texts that begin with 'a'.
bool parse_a(std::string_view text) {
    if (!text.starts_with('a')) {
        throw std::invalid_argument("no a: " + std::string(text));
    }
    return true;
}

TEST(ParsedTexts, AreCheckedByTheFunction) {
    const ParsedTexts<parse_a> kind{"texts with a"};
    std::vector<std::string> member = {"old"};
    EXPECT_EQ(kind.allowed(), "texts with a");
    EXPECT_FALSE(kind.read({Value::List{{"ab"}, {"b"}}}, member));
    EXPECT_EQ(member, std::vector<std::string>{"old"});
    EXPECT_EQ(kind.fault({Value::List{{"ab"}, {"b"}}}), "no a: b");
    EXPECT_EQ(kind.fault({"ab"}), "");
    EXPECT_TRUE(kind.read({"ab"}, member));
    EXPECT_EQ(member, std::vector<std::string>{"ab"});
    EXPECT_EQ(to_toml(kind.write(member)), "[\"ab\"]");
    EXPECT_TRUE(kind.read({Value::List{}}, member));
    EXPECT_TRUE(member.empty());
    EXPECT_FALSE(kind.read({true}, member));
}

}  // namespace
}  // namespace foam::texgen
