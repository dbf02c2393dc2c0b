// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/foam_shape.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(FoamShape, AnAspectStretchesAnyOutline) {
    EXPECT_NEAR(outline_area(outline_of({.outline = "disc", .outline_aspect = 3.0}).front()),
                3.0 * std::numbers::pi,
                1e-2);
    EXPECT_DOUBLE_EQ(
        outline_area(outline_of({.outline = "rectangle", .outline_aspect = 2.0}).front()), 2.0);
    // A square of 4 x 4 with a hole of 2 x 1 is stretched to twice its width.
    const foam::Outline frame =
        outline_of({.outline = "POLYGON((0 0, 4 0, 4 4, 0 4), (1 1, 1 2, 3 2, 3 1))",
                    .outline_aspect = 2.0})
            .front();
    EXPECT_DOUBLE_EQ(outline_area(frame), 28.0);
    EXPECT_FALSE(is_inside(frame, {5.9, 1.5}));
    EXPECT_TRUE(is_inside(frame, {6.1, 1.5}));
}

TEST(FoamShape, RejectsInvalidOutlines) {
    EXPECT_THROW(outline_of({.outline = "circle"}), std::invalid_argument);
    EXPECT_THROW(outline_of({.outline = "POLYGON((0 0, 1 0, 2 0))"}), std::invalid_argument);
}

// The example begins with POLYGON and ends before a quote.
TEST(FoamShape, TheExampleOfAnOutlineIsAllowed) {
    const Keys<FoamShape> keys = shape_keys();
    const Key<FoamShape>* key = find_key(std::span<const Key<FoamShape>>(keys), "outline");
    ASSERT_NE(key, nullptr);
    const std::size_t begin = key->allowed.find("POLYGON");
    const std::string example = key->allowed.substr(begin, key->allowed.find('"', begin) - begin);
    FoamShape shape;
    EXPECT_TRUE(key->read({example}, shape)) << example;
    EXPECT_EQ(outline_of(shape).front().holes.size(), 1U);
}

// A drawing of two squares. The name of the file is a value of the key.
TEST(FoamShape, ReadsOutlinesFromFiles) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.svg").string();
    const std::string text =
        "<svg><rect width='2' height='2'/><rect x='3' width='1' height='1'/></svg>";
    write_file(path, std::as_bytes(std::span(text)));
    const Keys<FoamShape> keys = shape_keys();
    const Key<FoamShape>* key = find_key(std::span<const Key<FoamShape>>(keys), "outline");
    FoamShape shape;
    shape.outline_aspect = 2.0;
    ASSERT_TRUE(key->read({path}, shape));
    const std::vector<foam::Outline> parts = outline_of(shape);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_NEAR(outline_area(parts[0]) / outline_area(parts[1]), 4.0, 0.02);
    EXPECT_NEAR(bounding_aspect(parts), 2.0 * 4.0 / 2.0, 0.01);
    EXPECT_EQ(key->file(shape)->path, path);
    EXPECT_TRUE(key->names_file({path}));
    EXPECT_FALSE(key->names_file({std::string("disc")}));
    ASSERT_TRUE(key->read({std::string("disc")}, shape));
    EXPECT_EQ(outline_of(shape).size(), 1U);
    EXPECT_FALSE(key->file(shape).has_value());
    EXPECT_FALSE(key->read({std::string("missing.svg")}, shape));
    EXPECT_NE(key->fault({std::string("missing.svg")}).find("missing.svg"), std::string::npos);
}

}  // namespace
}  // namespace foam::texgen
