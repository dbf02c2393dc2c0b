// SPDX-License-Identifier: Apache-2.0

#include "core/foam/patch_part.h"

#include "core/foam/clipped_cells.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace foam {
namespace {

// A square of 3 x 3 and, 2 to the right of it, a square of 1 x 1.
std::vector<Outline> two_squares() {
    return {outline_from_wkt("POLYGON((0 0, 3 0, 3 3, 0 3))"),
            outline_from_wkt("POLYGON((5 0, 6 0, 6 1, 5 1))")};
}

// 40 bubbles have an area of 1 each, so that the sides of the squares are 6 and 2.
TEST(PatchPart, IsScaledToAnAreaOfOnePerBubble) {
    const std::vector<PreparedPart> parts = prepare_parts(two_squares(), {.bubbles = 40});
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].bubbles, 36);
    EXPECT_EQ(parts[1].bubbles, 4);
    EXPECT_NEAR(outline_area(parts[0].outline), 36.0, 1e-9);
    EXPECT_NEAR(outline_area(parts[1].outline), 4.0, 1e-9);
}

// The torus is twice as wide as the square. The shift leads from the scaled outline to the middle
// of the torus: the middle of the first square from (3, 3) to (6, 6), that of the second one from
// (11, 1) to (2, 2).
TEST(PatchPart, IsInTheMiddleOfItsTorus) {
    const std::vector<PreparedPart> parts = prepare_parts(two_squares(), {.bubbles = 40});
    EXPECT_NEAR(parts[0].domain.width, 12.0, 1e-9);
    EXPECT_NEAR((parts[0].shift - Vec2(3.0, 3.0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(parts[1].domain.width, 4.0, 1e-9);
    EXPECT_NEAR((parts[1].shift - Vec2(-9.0, 1.0)).norm(), 0.0, 1e-9);
}

// Where the area of the field is 1/4, the density of bubbles is four times as high: of 52 bubbles,
// the first square gets 36 and the second one 16. The field is stretched over both squares.
TEST(PatchPart, GetsBubblesByTheAreaField) {
    const PatchOptions options{.bubbles = 52, .areas = AreaField(2, 1, {1.0, 0.25})};
    std::vector<Outline> parts = two_squares();
    const std::vector<PreparedPart> prepared = prepare_parts(parts, options);
    EXPECT_EQ(prepared[0].bubbles, 36);
    EXPECT_EQ(prepared[1].bubbles, 16);
    ASSERT_TRUE(prepared[1].areas.has_value());
    EXPECT_DOUBLE_EQ(prepared[1].areas->at(outline_centroid(prepared[1].outline)), 0.25);
    EXPECT_DOUBLE_EQ(prepared[0].areas->at(outline_centroid(prepared[0].outline)), 1.0);
}

TEST(PatchPart, IsCoveredByItsCells) {
    const PatchOptions options{.bubbles = 40};
    const std::vector<PreparedPart> parts = prepare_parts(two_squares(), options);
    Random random(1);
    const PartCells cells = draw_part(parts[0], options, random);
    double area = 0.0;
    for (const PolygonMesh::Cell& cell : cells.mesh.cells) {
        area += polygon_area(cells.mesh, cell);
    }
    EXPECT_NEAR(area, 36.0, 1e-6);
    EXPECT_TRUE(cells.field.empty());
}

TEST(PatchPart, MustNotBeSmallerThanATenthOfABubble) {
    const std::vector<Outline> parts = {outline_from_wkt("POLYGON((0 0, 100 0, 100 1, 0 1))"),
                                        outline_from_wkt("POLYGON((0 2, 1 2, 1 3, 0 3))")};
    EXPECT_NO_THROW(prepare_parts(parts, {.bubbles = 11}));  // the part is 11/101 of a bubble
    EXPECT_THROW(prepare_parts(parts, {.bubbles = 10}), std::runtime_error);
}

}  // namespace
}  // namespace foam
