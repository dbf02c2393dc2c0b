// SPDX-License-Identifier: Apache-2.0

#include "core/foam/outline.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam {
namespace {

constexpr const char* kFrame = "POLYGON((0 0, 0 4, 6 4, 6 0), (1 1, 2 1, 2 2, 1 2, 1 1))";

TEST(Outline, IsReadFromWkt) {
    const Outline frame = outline_from_wkt(kFrame);
    EXPECT_EQ(frame.outer.size(), 4U);
    ASSERT_EQ(frame.holes.size(), 1U);
    EXPECT_DOUBLE_EQ(outline_area(frame), 23.0);
    EXPECT_TRUE(is_inside(frame, {0.5, 0.5}));
    EXPECT_FALSE(is_inside(frame, {1.5, 1.5}));
    EXPECT_FALSE(is_inside(frame, {-0.5, 0.5}));
}

// Returns why a text is no outline.
std::string fault_of(const char* text) {
    try {
        outline_from_wkt(text);
        return "none";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(Outline, SaysWhatIsWrongWithAPolygon) {
    for (const char* text : {"CIRCLE(1)", "", "o.wkt", "POLYGON((0 0, x 0, 1 1))"}) {
        EXPECT_EQ(fault_of(text),
                  "this is not written as a WKT polygon; check its brackets, commas and numbers");
    }
    EXPECT_EQ(fault_of("POLYGON((0 0, 1 0, 1 1)"), "a bracket of the WKT polygon is not closed");
    const std::string two_numbers =
        "each point must have two numbers, such as '6 4', but a point has ";
    EXPECT_EQ(fault_of("POLYGON((0,0 6,0 6,4 0,4))"), two_numbers + "1");
    EXPECT_EQ(fault_of("POLYGON((0 0 0,6 0 0,6 4 0,0 4 0,0 0 0))"), two_numbers + "3");
    EXPECT_EQ(fault_of("POLYGON((0 0,6 0,6 4,0 4),)"), two_numbers + "0");
    EXPECT_EQ(fault_of("POLYGON ( ( 0 0 , 6 0 ,6 4, 0 4 ) ,\n\t( 1 1, 2 1, 2 2 ) )"), "none");
    EXPECT_EQ(fault_of("POLYGON((0 0, 1 1, 1 0, 0 1))"), "the polygon crosses or touches itself");
    EXPECT_EQ(fault_of("POLYGON((0 0, 1 0))"), "a ring has fewer than three corners");
    EXPECT_EQ(fault_of("POLYGON((0 0, 4 0, 4 4, 0 4), (5 5, 6 5, 6 6))"),
              "a hole is outside of the polygon");
    EXPECT_EQ(
        fault_of("POLYGON((0 0, 1 2, 0 66666666666666666666666666666666666666666))"),
        "the polygon is too narrow: its area is less than a billionth of the square of its length");
    EXPECT_EQ(fault_of("POLYGON((0 0, 1e200 0, 1e200 1e200, 0 1e200))"),
              "the coordinates are too large");
    EXPECT_EQ(fault_of("POLYGON((0 0, 1 0, 1 1))"), "none");
}

TEST(Outline, MakesDiscsAndRectangles) {
    EXPECT_NEAR(outline_area(disc_outline()), std::numbers::pi, 1e-3);
    EXPECT_DOUBLE_EQ(outline_area(rectangle_outline(2.5)), 2.5);
}

// The frame is a rectangle of 6 x 4 around (3, 2), without a square of 1 x 1 around (1.5, 1.5).
TEST(Outline, HasACentroid) {
    const Vec2 center = outline_centroid(outline_from_wkt(kFrame));
    EXPECT_NEAR(center.x(), (24.0 * 3.0 - 1.5) / 23.0, 1e-12);
    EXPECT_NEAR(center.y(), (24.0 * 2.0 - 1.5) / 23.0, 1e-12);
}

// Horizontal strips are clipped to the frame. A strip above the hole gives one part, a strip across
// the hole two parts, and a strip outside of the frame none.
TEST(Outline, ClipsPolygons) {
    const Outline frame = outline_from_wkt(kFrame);
    const auto strip = [](double low, double high) {
        return std::vector<Vec2>{{-1.0, low}, {7.0, low}, {7.0, high}, {-1.0, high}};
    };
    EXPECT_EQ(clipped(frame, strip(2.5, 3.0)).size(), 1U);
    EXPECT_EQ(clipped(frame, strip(1.2, 1.8)).size(), 2U);
    EXPECT_TRUE(clipped(frame, strip(5.0, 6.0)).empty());
}

TEST(Outline, HasTheAspectOfTheBoundingBoxOfAllParts) {
    const std::vector<Outline> parts = {outline_from_wkt("POLYGON((0 0, 1 0, 1 1))"),
                                        outline_from_wkt("POLYGON((5 1, 6 1, 6 2))")};
    EXPECT_DOUBLE_EQ(bounding_aspect(parts), 3.0);
}

// Far from the rings of the frame, a polygon is kept as it is or dropped.
TEST(Outline, KeepsOrDropsPolygonsApartFromItsRings) {
    const Outline frame = outline_from_wkt(kFrame);
    const std::vector<Vec2> inside = {{3.0, 1.0}, {5.0, 1.0}, {4.0, 3.0}};
    EXPECT_EQ(clipped(frame, inside), std::vector<std::vector<Vec2>>{inside});
    EXPECT_TRUE(clipped(frame, {{1.2, 1.2}, {1.8, 1.2}, {1.5, 1.8}}).empty());
    EXPECT_TRUE(clipped(frame, {{7.0, 1.0}, {8.0, 1.0}, {8.0, 2.0}}).empty());
}

}  // namespace
}  // namespace foam
