// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_tokens.h"

#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace foam::evolver {
namespace {

const std::string file_name = "a.fe";

std::vector<Token> tokens_of(std::string_view text) {
    TokenReader reader(text, file_name);
    std::vector<Token> tokens;
    while (!reader.at_end()) {
        tokens.push_back(reader.take());
    }
    return tokens;
}

TEST(EvolverTokens, ReadsFiveKindsOfTokens) {
    const std::vector<Token> tokens = tokens_of("Word_1 -2.5e-3 \"a text\" 7");
    ASSERT_EQ(tokens.size(), 5U);
    EXPECT_EQ(tokens[0].kind, TokenKind::Word);
    EXPECT_EQ(lower(tokens[0].text), "word_1");
    EXPECT_TRUE(tokens[1].is_symbol('-'));
    EXPECT_EQ(tokens[2].number, 2.5e-3);
    EXPECT_FALSE(tokens[2].is_integer);
    EXPECT_EQ(tokens[3].text, "a text");
    EXPECT_TRUE(tokens[4].is_integer);
}

TEST(EvolverTokens, ReadsEveryFormOfANumber) {
    EXPECT_EQ(tokens_of(".5")[0].number, 0.5);
    EXPECT_EQ(tokens_of("3.")[0].number, 3.0);
    EXPECT_EQ(tokens_of("1E+2")[0].number, 100.0);
    EXPECT_EQ(tokens_of("0x00001f")[0].number, 31.0);
    EXPECT_TRUE(tokens_of("0x00001f")[0].is_integer);
    EXPECT_EQ(tokens_of("-2.79344716158641e-319")[1].number, 2.79344716158641e-319);
    EXPECT_EQ(tokens_of("1e-999")[0].number, 0.0);
    EXPECT_EQ(tokens_of("1e999")[0].number, std::numeric_limits<double>::infinity());
}

TEST(EvolverTokens, SkipsAByteOrderMark) {
    const std::vector<Token> tokens = tokens_of("\xEF\xBB\xBFtorus");
    ASSERT_EQ(tokens.size(), 1U);
    EXPECT_EQ(tokens[0].text, "torus");
    EXPECT_TRUE(tokens[0].starts_line);
}

TEST(EvolverTokens, CommentsAreWhiteSpaceAndLinesAreCounted) {
    const std::vector<Token> tokens = tokens_of("a // b\n/* c\n d */ e\r\nf");
    ASSERT_EQ(tokens.size(), 3U);
    EXPECT_EQ(tokens[1].text, "e");
    EXPECT_EQ(tokens[1].line, 3);
    EXPECT_TRUE(tokens[1].starts_line);
    EXPECT_EQ(tokens[2].line, 4);
}

TEST(EvolverTokens, ABackslashContinuesALine) {
    const std::vector<Token> tokens = tokens_of("1 2 \\ \n 3\n4");
    EXPECT_FALSE(tokens[2].starts_line);
    EXPECT_EQ(tokens[2].line, 2);
    EXPECT_TRUE(tokens[3].starts_line);
    EXPECT_TRUE(tokens_of("a \\b")[1].is_symbol('\\'));
}

TEST(EvolverTokens, ReportsPrecedingWhiteSpace) {
    const std::vector<Token> tokens = tokens_of("1 -2 - 3-4");
    EXPECT_TRUE(tokens[1].follows_space && !tokens[1].precedes_space);
    EXPECT_TRUE(tokens[3].follows_space && tokens[3].precedes_space);
    EXPECT_TRUE(!tokens[5].follows_space && !tokens[5].precedes_space);
}

TEST(EvolverTokens, TakesSignedIntegers) {
    TokenReader reader("-3 +4 5 - 6", file_name);
    EXPECT_EQ(reader.take_integer("a number"), -3);
    EXPECT_EQ(reader.take_integer("a number"), 4);
    EXPECT_EQ(reader.take_integer("a number"), 5);
    EXPECT_FALSE(reader.at_integer());
}

TEST(EvolverTokens, ErrorNamesFileLineAndToken) {
    TokenReader reader("\nlength", file_name);
    test::expect_format_error([&] { reader.take_integer("a number"); },
                              "a.fe:2: expected a number, found 'length'");
    reader.take();
    test::expect_format_error([&] { reader.take_word("a word"); },
                              "a.fe:2: expected a word, found the end of the file");
    TokenReader large("2147483648", file_name);
    test::expect_format_error([&] { large.take_integer("a number"); },
                              "a.fe:1: expected a number, found '2147483648'");
}

TEST(EvolverTokens, AnErrorIsOneLine) {
    TokenReader reader("\"a\n\"", file_name);
    test::expect_format_error([&] { reader.take_integer("a number"); },
                              "a.fe:1: expected a number, found 'a?'");
}

// Evolver allows preprocessor lines everywhere, also in the middle of a line. If they were ignored,
// macros and included files would be missing.
TEST(EvolverTokens, RejectsPreprocessorLines) {
    EXPECT_EQ(tokens_of("// #define X 3\n\"#\" /* # */").size(), 1U);
    for (const char* line : {"#define X 3", "  #include \"b.fe\"", "c #define X 3"}) {
        test::expect_format_error(
            [&] { tokens_of(std::string("a b\n") + line); },
            "a.fe:2: preprocessor lines such as #define and #include are not supported");
    }
}

TEST(EvolverTokens, RejectsUnclosedCommentsAndStrings) {
    test::expect_format_error([] { tokens_of("a\n/* b\nc"); },
                              "a.fe:2: this comment has no closing */");
    test::expect_format_error([] { tokens_of("a\n\n\"b"); },
                              "a.fe:3: this string has no closing quote");
}

}  // namespace
}  // namespace foam::evolver
