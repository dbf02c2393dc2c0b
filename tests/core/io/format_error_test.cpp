// SPDX-License-Identifier: Apache-2.0

#include "core/io/format_error.h"

#include <gtest/gtest.h>

#include <string>

namespace foam {
namespace {

TEST(FormatError, NamesFileAndLine) {
    const FormatError error("foam.fe", 12, "expected a number");
    EXPECT_STREQ(error.what(), "foam.fe:12: expected a number");
    EXPECT_EQ(error.line(), 12);
}

// A message may quote the file. Control characters in it could fake further lines or change the
// state of the terminal.
TEST(FormatError, ReplacesUnprintableCharacters) {
    EXPECT_STREQ(FormatError("a", 1, "got '\n\x1b[31m\xff'").what(), "a:1: got '??[31m?'");
}

}  // namespace
}  // namespace foam
