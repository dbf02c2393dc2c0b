// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/foam_shape.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

TEST(FoamShape, AnAspectStretchesAnyOutline) {
    EXPECT_NEAR(outline_area(outline_of({.outline = "disc", .outline_aspect = 3.0})),
                3.0 * std::numbers::pi,
                1e-2);
    EXPECT_DOUBLE_EQ(outline_area(outline_of({.outline = "rectangle", .outline_aspect = 2.0})),
                     2.0);
    // A square of 4 x 4 with a hole of 2 x 1 is stretched to twice its width.
    const foam::Outline frame = outline_of(
        {.outline = "POLYGON((0 0, 4 0, 4 4, 0 4), (1 1, 1 2, 3 2, 3 1))", .outline_aspect = 2.0});
    EXPECT_DOUBLE_EQ(outline_area(frame), 28.0);
    EXPECT_FALSE(is_inside(frame, {5.9, 1.5}));
    EXPECT_TRUE(is_inside(frame, {6.1, 1.5}));
}

TEST(FoamShape, RejectsInvalidOutlines) {
    EXPECT_THROW(outline_of({.outline = "circle"}), std::invalid_argument);
    EXPECT_THROW(outline_of({.outline = "POLYGON((0 0, 1 0, 2 0))"}), std::invalid_argument);
}

// The example is between the last two quotes.
TEST(FoamShape, TheExampleOfAnOutlineIsAllowed) {
    const Keys<FoamShape> keys = shape_keys();
    const Key<FoamShape>* key = find_key(std::span<const Key<FoamShape>>(keys), "outline");
    ASSERT_NE(key, nullptr);
    const std::size_t begin = key->allowed.find("POLYGON");
    const std::string example = key->allowed.substr(begin, key->allowed.size() - begin - 1);
    FoamShape shape;
    EXPECT_TRUE(key->read({example}, shape)) << example;
    EXPECT_EQ(outline_of(shape).holes.size(), 1U);
}

}  // namespace
}  // namespace foam::texgen
