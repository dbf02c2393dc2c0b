// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/image_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(ImageOptions, LimitsHoldOnBothSides) {
    test::expect_limits(image_keys(),
                        {{"size", "[0, 4]", "[1, 1]", "[16384, 16384]", "[4, 16385]"}});
}

TEST(ImageOptions, ASizeIsWidthAndHeight) {
    const Key<ImageOptions> size = image_keys()[0];
    ImageOptions image;
    EXPECT_TRUE(size.read(read_value("[7, 9]"), image));
    EXPECT_EQ(image.width, 7);
    EXPECT_EQ(image.height, 9);
    EXPECT_FALSE(size.read(read_value("[5, 0]"), image));
    EXPECT_EQ(image.width, 7);
    EXPECT_EQ(to_toml(*size.write(image)), "[7, 9]");
}

TEST(ImageOptions, MapsAreTheOnesThatExist) {
    const Key<ImageOptions> maps = image_keys()[1];
    ImageOptions image;
    EXPECT_TRUE(maps.read(read_value("height"), image));
    EXPECT_EQ(image.maps, std::vector<std::string>{"height"});
    EXPECT_FALSE(maps.read(read_value("depth"), image));
}

}  // namespace
}  // namespace foam::texgen
