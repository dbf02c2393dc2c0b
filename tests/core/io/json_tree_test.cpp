// SPDX-License-Identifier: Apache-2.0

#include "core/io/json_tree.h"

#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foam {
namespace {

void expect_rejected(const std::string& text, const std::string& what) {
    test::expect_format_error([&] { parse_json(text, "a.json"); }, what);
}

TEST(JsonTree, HoldsEveryKindOfValue) {
    const JsonTree tree = parse_json(R"({"n": null, "b": true, "s": "x", "l": [1, -2.5]})", "");
    EXPECT_TRUE(std::holds_alternative<std::nullptr_t>(tree.find("n")->data));
    EXPECT_TRUE(std::get<bool>(tree.find("b")->data));
    EXPECT_EQ(std::get<std::string>(tree.find("s")->data), "x");
    const auto& list = std::get<JsonTree::Array>(tree.find("l")->data);
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(std::get<double>(list[1].data), -2.5);
    EXPECT_EQ(tree.find("none"), nullptr);
    EXPECT_EQ(list[0].find("none"), nullptr);
}

TEST(JsonTree, RecordsLines) {
    const JsonTree tree = parse_json("\n{\n\"a\": 1\n,\"b\":\n[\n2,\n\"c\"\n]\n}\n", "");
    EXPECT_EQ(tree.line, 2);
    EXPECT_EQ(tree.find("a")->line, 3);
    const JsonTree& list = *tree.find("b");
    EXPECT_EQ(list.line, 5);
    EXPECT_EQ(std::get<JsonTree::Array>(list.data)[0].line, 6);
    EXPECT_EQ(std::get<JsonTree::Array>(list.data)[1].line, 7);
}

TEST(JsonTree, KeepsEveryBitOfANumber) {
    const auto read = [](const char* text) {
        return std::get<double>(std::get<JsonTree::Array>(parse_json(text, "").data)[0].data);
    };
    EXPECT_EQ(read("[0.1]"), 0.1);
    EXPECT_EQ(read("[5e-324]"), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(read("[1.7976931348623157e+308]"), std::numeric_limits<double>::max());
    EXPECT_EQ(read("[0.3333333333333333]"), 1.0 / 3.0);
    EXPECT_TRUE(std::signbit(read("[-0.0]")));
}

TEST(JsonTree, ErrorsNameTheLine) {
    expect_rejected("{\n\"a\": 1,\n}",
                    "a.json:3: syntax error while parsing object key - unexpected '}'; expected "
                    "string literal");
    expect_rejected("[1,\n1e999]", "a.json:2: number overflow parsing '1e999'");
    expect_rejected("",
                    "a.json:1: syntax error while parsing value - unexpected end of input; "
                    "expected '[', '{', or a literal");
    expect_rejected("{\"a\": 1,\n\"a\": 2}", "a.json:2: duplicate key 'a'");
}

TEST(JsonTree, DeepNestingIsAnError) {
    expect_rejected(std::string(100000, '['), "a.json:1: nested more than 16 levels deep");
}

}  // namespace
}  // namespace foam
