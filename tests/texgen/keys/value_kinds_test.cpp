// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/value_kinds.h"

#include "texgen/keys/key.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Value integer(std::int64_t value) {
    return {value};
}

TEST(ValueKinds, IntegersLieInTheirRange) {
    const Integers kind{-3, 5};
    int member = 1;
    EXPECT_EQ(kind.allowed(), "an integer from -3 to 5");
    EXPECT_TRUE(kind.read(integer(-3), member));
    EXPECT_EQ(member, -3);
    EXPECT_FALSE(kind.read(integer(6), member));
    EXPECT_FALSE(kind.read({2.0}, member));
    EXPECT_EQ(member, -3);
    EXPECT_EQ(kind.write(member), integer(-3));
}

TEST(ValueKinds, RealsTakeIntegersAndMayBeZero) {
    const Reals kind{1.0, 2.0, true};
    double member = 1.5;
    EXPECT_EQ(kind.allowed(), "0 or a number from 1 to 2");
    EXPECT_TRUE(kind.read(integer(2), member));
    EXPECT_EQ(member, 2.0);
    EXPECT_TRUE(kind.read({0.0}, member));
    EXPECT_EQ(member, 0.0);
    EXPECT_FALSE(kind.read({0.5}, member));
    EXPECT_FALSE(kind.read({std::numeric_limits<double>::quiet_NaN()}, member));
    EXPECT_FALSE((Reals{1.0, 2.0}.read({0.0}, member)));
}

TEST(ValueKinds, RealsOrAutoTakeTheWordAuto) {
    const RealsOrAuto kind{1.0, 2.0, {1.75, true}};
    AutoReal member{1.5};
    EXPECT_EQ(kind.allowed(), "\"auto\" or a number from 1 to 2");
    EXPECT_TRUE(kind.read({std::string("auto")}, member));
    EXPECT_EQ(member, (AutoReal{1.75, true}));
    EXPECT_EQ(kind.write(member), Value{std::string("auto")});
    EXPECT_FALSE(kind.read({2.5}, member));
    EXPECT_FALSE(kind.read({std::string("automatic")}, member));
    EXPECT_EQ(member, (AutoReal{1.75, true}));
    EXPECT_TRUE(kind.read({1.25}, member));
    EXPECT_EQ(member, AutoReal{1.25});
    EXPECT_EQ(kind.write(member), Value{1.25});
}

TEST(ValueKinds, TextIsEmptyOnlyWhereAllowed) {
    std::string member = "old";
    EXPECT_FALSE(Text{}.read({std::string()}, member));
    EXPECT_EQ(member, "old");
    EXPECT_TRUE(Text{.or_empty = true}.read({std::string()}, member));
    EXPECT_EQ(member, "");
}

TEST(ValueKinds, ColorsHaveSixDigits) {
    std::string member;
    EXPECT_TRUE(Colors{}.read({std::string("#01aBff")}, member));
    EXPECT_EQ(member, "#01aBff");
    EXPECT_FALSE(Colors{}.read({std::string("#fff")}, member));
    std::vector<std::string> list{"#000000"};
    EXPECT_TRUE(ColorLists{}.read({Value::List{}}, list));
    EXPECT_TRUE(list.empty());
    EXPECT_EQ(ColorLists{}.write(list), Value{Value::List{}});
}

TEST(ValueKinds, WordListsHaveEachWordOnce) {
    constexpr std::array<std::string_view, 3> kWords{"a", "b", "c"};
    const WordLists kind{kWords};
    std::vector<std::string> member;
    EXPECT_TRUE(kind.read({std::string("b")}, member));
    EXPECT_EQ(member, std::vector<std::string>{"b"});
    EXPECT_TRUE(kind.read({Value::List{{std::string("c")}, {std::string("a")}}}, member));
    EXPECT_EQ(member, (std::vector<std::string>{"c", "a"}));
    EXPECT_FALSE(kind.read({Value::List{{std::string("a")}, {std::string("a")}}}, member));
    EXPECT_FALSE(kind.read({Value::List{}}, member));
}

TEST(ValueKinds, WordsAreListed) {
    enum class Way { Up, Down };
    constexpr std::array<std::string_view, 2> kWords{"a", "b"};
    using Views = std::vector<std::string_view>;
    EXPECT_EQ(words_of(Words{kWords}), (Views{"a", "b"}));
    EXPECT_EQ(words_of(WordLists{kWords}), (Views{"a", "b"}));
    EXPECT_EQ(words_of(Choices<Way>{{{{"up", Way::Up}, {"down", Way::Down}}}}),
              (Views{"up", "down"}));
    EXPECT_EQ(words_of(Integers{1, 2}), Views{});
}

TEST(ValueKinds, IntegerListsAreUnsetWhileTheyAreEmpty) {
    const IntegerLists kind{{0, 9}};
    std::vector<int> member;
    EXPECT_FALSE(kind.write(member).has_value());
    EXPECT_TRUE(kind.read(integer(4), member));
    EXPECT_EQ(member, std::vector<int>{4});
    EXPECT_EQ(kind.write(member), (Value{Value::List{integer(4)}}));
    EXPECT_FALSE(kind.read({Value::List{integer(4), integer(10)}}, member));
    EXPECT_EQ(member, std::vector<int>{4});
}

TEST(ValueKinds, PairsHaveTwoNumbers) {
    const Points kind{{0.0, 1.0}};
    std::array<double, 2> member{0.5, 0.5};
    EXPECT_TRUE(kind.read({Value::List{{0.25}, integer(1)}}, member));
    EXPECT_EQ(member, (std::array{0.25, 1.0}));
    EXPECT_FALSE(kind.read({Value::List{{0.75}, {1.5}}}, member));
    EXPECT_FALSE(kind.read({Value::List{{0.75}}}, member));
    EXPECT_EQ(member, (std::array{0.25, 1.0}));
}

TEST(ValueKinds, AnOptionalValueMayBeUnset) {
    const Maybe<Integers> kind{{1, 3}};
    std::optional<int> member;
    EXPECT_FALSE(kind.write(member).has_value());
    EXPECT_FALSE(kind.read(integer(4), member));
    EXPECT_FALSE(member.has_value());
    EXPECT_TRUE(kind.read(integer(3), member));
    EXPECT_EQ(member, 3);
    EXPECT_EQ(kind.write(member), integer(3));
}

TEST(ValueKinds, ChoicesHaveAWordForEachValue) {
    enum class Way { Up, Down };
    const Choices<Way> kind{{{{"up", Way::Up}, {"down", Way::Down}}}};
    Way member = Way::Up;
    EXPECT_EQ(kind.allowed(), R"(one of "up", "down")");
    EXPECT_TRUE(kind.read({std::string("down")}, member));
    EXPECT_EQ(member, Way::Down);
    EXPECT_EQ(kind.write(member), Value{std::string("down")});
    EXPECT_FALSE(kind.read({std::string("left")}, member));
}

}  // namespace
}  // namespace foam::texgen
