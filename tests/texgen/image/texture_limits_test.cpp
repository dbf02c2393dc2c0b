// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/texture_limits.h"

#include "core/files/file_io.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

// An image of 9 x 4 pixels has the mip levels 9 x 4, 4 x 2, 2 x 1 and 1 x 1.
TEST(TextureLimits, HoldOnBothSides) {
    EXPECT_NO_THROW(check_texture_size("DDS", 9, 4, 4, 1));
    EXPECT_NO_THROW(check_texture_size("DDS", 9, 4, 1, kMaxLayers));
    EXPECT_NO_THROW(check_texture_size("DDS", 1'000'000, 1, 1, 1));
    EXPECT_THROW(check_texture_size("DDS", 0, 4, 1, 1), InputError);
    EXPECT_THROW(check_texture_size("DDS", 9, 0, 1, 1), InputError);
    EXPECT_THROW(check_texture_size("DDS", 9, 4, 5, 1), InputError);
    EXPECT_THROW(check_texture_size("DDS", 9, 4, 0, 1), InputError);
    EXPECT_THROW(check_texture_size("DDS", 9, 4, 1, 0), InputError);
    EXPECT_THROW(check_texture_size("DDS", 9, 4, 1, kMaxLayers + 1), InputError);
    EXPECT_THROW(check_texture_size("DDS", 1'000'001, 1, 1, 1), InputError);
    EXPECT_THROW(check_texture_size("DDS", 40'000, 40'000, 1, 1), InputError);
}

}  // namespace
}  // namespace foam::texgen
