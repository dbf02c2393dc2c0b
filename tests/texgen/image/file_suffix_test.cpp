// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/file_suffix.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(FileSuffix, IsFoundInLettersOfEitherCase) {
    for (const char* name : {"a.png", "a.PNG", "b/a.0001.Png", ".png"}) {
        EXPECT_TRUE(has_suffix(name, ".png")) << name;
    }
    for (const char* name : {"", "png", "PNG", "a.png/b", "a.png ", "a.pn"}) {
        EXPECT_FALSE(has_suffix(name, ".png")) << name;
    }
    EXPECT_TRUE(has_suffix("A.KTX2", ".ktx2"));
}

}  // namespace
}  // namespace foam::texgen
