// SPDX-License-Identifier: Apache-2.0

#include "core/io/json_item.h"

#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace foam {
namespace {

constexpr const char* kText = R"({
"time": 1.5,
"torus": [3.0, -2.0],
"films": [
[0, 4, 7],
[1, "x", 2.5]
],
"bubbles": []
})";

void expect_rejected(const std::function<void(const JsonItem&)>& read, const std::string& what) {
    const std::string file = "a.json";
    const JsonTree tree = parse_json(kText, file);
    test::expect_format_error([&] { read(JsonItem(tree, file)); }, what);
}

TEST(JsonItem, ReadsNumbers) {
    const std::string file = "a.json";
    const JsonTree tree = parse_json(kText, file);
    const JsonItem root(tree, file);
    EXPECT_EQ(root.member("time").positive(), 1.5);
    EXPECT_EQ(root.member("torus").value(1).number(), -2.0);
    EXPECT_EQ(root.member("films").size(), 2U);
    EXPECT_EQ(root.member("films").element(0).value(1).integer(4.0, 4.0), 4.0);
    EXPECT_EQ(root.member("films").element(0).value(2).index(8, "junction"), 7U);
    EXPECT_TRUE(root.member("films").element(1).value(1).is_text("x"));
    EXPECT_FALSE(root.member("films").element(1).value(0).is_text("x"));
    EXPECT_EQ(root.member("bubbles").size(), 0U);
}

TEST(JsonItem, NamesTheValueInItsMessages) {
    expect_rejected([](const JsonItem& root) { root.member("none"); },
                    "a.json:1: 'none' is missing");
    expect_rejected([](const JsonItem& root) { root.member("time").size(); },
                    "a.json:2: 'time': expected an array");
    expect_rejected([](const JsonItem& root) { root.member("torus").expect_size(3); },
                    "a.json:3: 'torus': expected an array of 3 numbers, found 2");
    expect_rejected([](const JsonItem& root) { root.member("torus").value(1).positive(); },
                    "a.json:3: 'torus', value 2: expected a positive number, found -2");
    const auto film = [](const JsonItem& root, std::size_t k) {
        return root.member("films").element(k);
    };
    expect_rejected([&](const JsonItem& root) { film(root, 1).value(1).number(); },
                    "a.json:6: 'films'[1], value 2: expected a finite number");
    expect_rejected([&](const JsonItem& root) { film(root, 1).value(2).integer(0.0, 9.0); },
                    "a.json:6: 'films'[1], value 3: expected an integer from 0 to 9, found 2.5");
    expect_rejected([&](const JsonItem& root) { film(root, 0).value(1).index(4, "bubble"); },
                    "a.json:5: 'films'[0], value 2: expected an integer from 0 to 3, found 4");
    expect_rejected(
        [&](const JsonItem& root) { film(root, 0).value(1).index(0, "bubble"); },
        "a.json:5: 'films'[0], value 2: refers to bubble 4, but the file has no bubble");
    expect_rejected([&](const JsonItem& root) { film(root, 0).fail("is wrong"); },
                    "a.json:5: 'films'[0]: is wrong");
}

}  // namespace
}  // namespace foam
