// SPDX-License-Identifier: Apache-2.0

#include "core/files/shown_text.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace foam {
namespace {

TEST(ShownText, KeepsOrdinaryText) {
    const std::string text = "größe 日本 \xF0\x9F\xAB\xA7 'a' = 1";
    EXPECT_EQ(shown_text(text), text);
    EXPECT_TRUE(is_utf8(text));
    EXPECT_TRUE(is_harmless(text));
}

TEST(ShownText, ReplacesCharactersThatControlATerminal) {
    EXPECT_EQ(shown_text("a\033[31mb\007\x7f"), "a?[31mb??");
    EXPECT_EQ(shown_text("a\nb\r\tc"), "a b  c");
    EXPECT_EQ(shown_text("\xC2\x9B"
                         "31m"),
              "?31m");                                       // U+009B, an escape sequence
    EXPECT_EQ(shown_text("gp.\xE2\x80\xAEgnp"), "gp.?gnp");  // U+202E, right to left
    EXPECT_FALSE(is_harmless("a\nb"));
    EXPECT_FALSE(is_harmless("\xE2\x80\xAE"));
}

TEST(ShownText, ReplacesBytesThatAreNotUtf8) {
    for (const char* bytes : {"\xFF",     // never occurs
                              "\xC3",     // ends too early
                              "\x80",     // a continuation alone
                              "\xF5"}) {  // beyond Unicode
        EXPECT_EQ(shown_text(fmt::format("a{}b", bytes)),
                  "a\xEF\xBF\xBD"
                  "b");
        EXPECT_FALSE(is_utf8(bytes));
        EXPECT_FALSE(is_harmless(bytes));
    }
    EXPECT_FALSE(is_utf8("\xC0\xAF"));          // too long for '/'
    EXPECT_FALSE(is_utf8("\xE0\x80\xAF"));      // too long for '/'
    EXPECT_FALSE(is_utf8("\xED\xA0\x80"));      // a surrogate
    EXPECT_FALSE(is_utf8("\xF4\x90\x80\x80"));  // U+110000
}

TEST(ShownText, ValidTextIsUnchanged) {
    EXPECT_EQ(valid_utf8("a\033\nä"), "a\033\nä");
    EXPECT_EQ(valid_utf8("a\xFF\n"), "a\xEF\xBF\xBD\n");
}

TEST(ShownText, LeavesOutTheMiddleOfALongText) {
    EXPECT_EQ(shown_text("0123456789", 10), "0123456789");
    EXPECT_EQ(shown_text("0123456789a", 10), "01 ... 9a");
    EXPECT_EQ(shown_text("ääbbbbbbbbbbbbää", 9), "ää ... ää");
}

TEST(ShownText, ShowsSeveralLines) {
    EXPECT_EQ(shown_lines("a\nb\033\n"), "a\nb?\n");
}

TEST(ShownText, CutsBetweenCharacters) {
    EXPECT_EQ(cut_text("äöü", 3), "äöü");
    EXPECT_EQ(cut_text("äöü", 2), "äö...");
    EXPECT_EQ(cut_text(std::string(61, 'a')), fmt::format("{}...", std::string(60, 'a')));
}

RC_GTEST_PROP(ShownText, AnyBytesBecomeHarmless, (const std::string& bytes)) {
    RC_ASSERT(is_harmless(shown_text(bytes)));
    RC_ASSERT(is_utf8(shown_lines(bytes)));
}

}  // namespace
}  // namespace foam
