// SPDX-License-Identifier: Apache-2.0

#include "core/files/content_text.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

TEST(ContentText, TrimmedTextsHaveNoSpacesAroundThem) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \n"), "");
    EXPECT_EQ(trimmed(""), "");
    EXPECT_EQ(trimmed(" \n ", " "), "\n");
}

}  // namespace
}  // namespace foam
