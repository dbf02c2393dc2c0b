// SPDX-License-Identifier: Apache-2.0

#include "texgen/json/json_value.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>

namespace foam::texgen {
namespace {

const JsonDocument& document() {
    static const JsonDocument tree(
        R"({"format": "tea", "version": 2, "list": [1, {"name": "x"}], "none": null, "half": 0.5,
            "yes": true, "big": 18446744073709551615})",
        "a.json");
    return tree;
}

std::string error_of(const std::function<void()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(JsonValue, ReadsEveryKind) {
    const JsonValue root = document().root();
    EXPECT_EQ(root["format"].text(), "tea");
    EXPECT_EQ(root["version"].integer(1, 2), 2);
    EXPECT_EQ(root["version"].count(), 2);
    EXPECT_EQ(root["half"].number(), 0.5);
    EXPECT_TRUE(root["yes"].flag());
    EXPECT_THROW(root["yes"].object_text(), InputError);
    EXPECT_EQ(root["list"].items().size(), 2U);
    EXPECT_EQ(root["list"].items()[1]["name"].text(), "x");
    EXPECT_FALSE(root.find("none"));
    EXPECT_FALSE(root.find("missing"));
}

TEST(JsonValue, NamesArePlain) {
    const JsonDocument names(R"({"a": "sea_foam 2", "b": "../x"})", "a.json");
    EXPECT_EQ(names.root()["a"].name(), "sea_foam 2");
    EXPECT_EQ(error_of([&] { names.root()["b"].name(); }),
              "cannot read 'a.json': b = \"../x\": must be a plain name, without '/' and control "
              "characters and not beginning with '.'");
}

TEST(JsonValue, AnErrorQuotesLittleOfALongText) {
    const std::string text = "{\"a\": \"" + std::string(10'000, 'x');
    const std::string error = error_of([&] { JsonDocument(text, "a.json"); });
    EXPECT_LT(error.size(), 300U);
    EXPECT_TRUE(error.starts_with("cannot read 'a.json': parse error at line 1, column 10008: "))
        << error;
    const JsonDocument accents("{\"a\": \"" + std::string(59, 'x') + "\xC3\xA4\xC3\xA4\"}",
                               "a.json");
    EXPECT_EQ(error_of([&] { accents.root()["a"].number(); }),
              "cannot read 'a.json': a = \"" + std::string(59, 'x') + "...: must be a number");
}

// Deeper nesting would need more stack than there is.
TEST(JsonValue, NestingIsLimited) {
    const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
    EXPECT_EQ(error_of([&] { JsonDocument(deep, "a.json"); }),
              "cannot read 'a.json': nested more than 16 levels deep");
    EXPECT_NO_THROW(JsonDocument("[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]", "a.json"));
}

TEST(JsonValue, AnEmptyFileIsNamed) {
    EXPECT_EQ(error_of([] { JsonDocument("", "a.json"); }),
              "cannot read 'a.json': the file is empty; remove it");
}

TEST(JsonValue, ErrorNamesFilePathValueAndAllowedValues) {
    const JsonValue root = document().root();
    EXPECT_EQ(error_of([&] { root["list"].items()[1]["name"].number(); }),
              "cannot read 'a.json': list[1].name = \"x\": must be a number");
    EXPECT_EQ(error_of([&] { root["version"].integer(3, 5); }),
              "cannot read 'a.json': version = 2: must be an integer from 3 to 5");
    EXPECT_EQ(error_of([&] { root["half"].count(); }),
              "cannot read 'a.json': half = 0.5: must be an integer from 0 to 2147483647");
    EXPECT_NE(error_of([&] { root["big"].count(); }), "no error");
    constexpr std::array<std::string_view, 2> kWords = {"a", "b"};
    EXPECT_EQ(error_of([&] { root["format"].word(kWords); }),
              "cannot read 'a.json': format = \"tea\": must be one of \"a\", \"b\"");
    EXPECT_EQ(error_of([&] { root["half"]["x"].text(); }),
              "cannot read 'a.json': half = 0.5: must be an object");
    EXPECT_NE(
        error_of([&] { root["missing"].text(); }).find("must be an object with the key 'missing'"),
        std::string::npos);
}

TEST(JsonValue, ATextThatCannotBeParsedIsAnError) {
    const auto fail = [](const std::string&) -> int { throw std::invalid_argument("no"); };
    EXPECT_EQ(error_of([&] { document().root()["format"].parsed(fail, "a number"); }),
              "cannot read 'a.json': format = \"tea\": must be a number");
    const auto size = [](const std::string& text) { return text.size(); };
    EXPECT_EQ(document().root()["format"].parsed(size, ""), 3U);
}

TEST(JsonDocument, ChecksFormatAndVersion) {
    EXPECT_NO_THROW(document().check_format("a tea", "tea", 2));
    EXPECT_NO_THROW(document().check_format("a tea", "tea", 3));
    EXPECT_NE(error_of([] {
                  document().check_format("a cup", "cup", 2);
              }).find("must be a cup, with \"format\": \"cup\""),
              std::string::npos);
    EXPECT_EQ(error_of([] { document().check_format("a tea", "tea", 1); }),
              "cannot read 'a.json': version = 2: must be an integer from 1 to 1");
}

TEST(JsonDocument, IsReadFromAFile) {
    const TemporaryFolder folder;
    const std::string text = "[7]";
    write_file(folder.path() / "a.json", std::as_bytes(std::span(text)));
    const JsonDocument read = JsonDocument::read(folder.path() / "a.json");
    EXPECT_EQ(read.root().items()[0].count(), 7);
    EXPECT_THROW(JsonDocument::read(folder.path() / "b.json"), InputError);
    EXPECT_THROW(JsonDocument("{", "c.json"), InputError);
}

}  // namespace
}  // namespace foam::texgen
