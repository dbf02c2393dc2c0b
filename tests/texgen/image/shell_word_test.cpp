// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/shell_word.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(ShellWord, QuotesWhatAShellWouldChange) {
    EXPECT_EQ(shell_word("out/frame.0001.png"), "out/frame.0001.png");
    EXPECT_EQ(shell_word("{map}.####.png"), "'{map}.####.png'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace foam::texgen
