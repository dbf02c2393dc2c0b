// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/identifier.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Identifier, HasOnlyLettersDigitsAndUnderscores) {
    EXPECT_EQ(identifier("sea_foam2"), "sea_foam2");
    EXPECT_EQ(identifier("my foam-v1.2"), "my_foam_v1_2");
    EXPECT_EQ(identifier("caf\xc3\xa9"), "caf__");
    EXPECT_EQ(identifier("2nd"), "_2nd");
    EXPECT_EQ(identifier(""), "_");
}

TEST(Identifiers, DifferFromEachOther) {
    Identifiers identifiers;
    EXPECT_EQ(identifiers.unique("a-b"), "a_b");
    EXPECT_EQ(identifiers.unique("a_b"), "a_b_2");
    EXPECT_EQ(identifiers.unique("a.b"), "a_b_3");
    EXPECT_EQ(identifiers.unique("c"), "c");
}

}  // namespace
}  // namespace foam::texgen
