// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/inset.h"

#include "tests/texgen/raster/outline/polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

double loop_area(const ArcLoops& loops, std::size_t begin, std::size_t end) {
    double area = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
        const ArcLoops::Side& arc = loops.sides[k];
        area += 0.5 * cross(arc.tail, arc.tail + arc.arc.chord) + segment_area(film_arc(arc.arc));
    }
    return area;
}

// Returns the area of each part of the inset of a region.
std::vector<double> inset_areas(const ArcLoops& region, double distance) {
    InsetTracer tracer;
    const ArcLoops& loops = tracer.trace(region, distance);
    EXPECT_EQ(loops.unclosed_loops, 0);
    std::vector<double> areas;
    std::size_t begin = 0;
    for (const std::size_t end : loops.loop_ends) {
        areas.push_back(loop_area(loops, begin, end));
        begin = end;
    }
    return areas;
}

TEST(Inset, OfARectangleIsARectangle) {
    const auto region = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}, {0.0, 3.0}});
    const std::vector<double> areas = inset_areas(region, 1.0);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], 8.0, 1e-12);
}

TEST(Inset, IsEmptyIfFilmsCoverTheBubble) {
    const auto region = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}, {0.0, 3.0}});
    EXPECT_TRUE(inset_areas(region, 1.6).empty());
    EXPECT_TRUE(inset_areas(region, 50.0).empty());
}

TEST(Inset, OfARegularHexagonIsASmallerHexagon) {
    // The side is 1 and the apothem sqrt(3)/2. The area of a hexagon is 2 sqrt(3) times the squared
    // apothem.
    std::vector<Vec2> corners;
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3.0;
        corners.emplace_back(std::cos(angle), std::sin(angle));
    }
    const double apothem = 0.5 * std::numbers::sqrt3 - 0.2;
    const std::vector<double> areas = inset_areas(polygon(corners), 0.2);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], 2.0 * std::numbers::sqrt3 * apothem * apothem, 1e-12);
}

TEST(Inset, DropsASideThatIsTooShort) {
    // One corner of the square is cut off along x + y = 19. At the distance h, the offset of the
    // cut is x + y = 19 - h sqrt(2). It passes through the corner (10 - h, 10 - h) of the adjacent
    // offsets at h = 1 / (2 - sqrt(2)), and is not visible for larger h.
    const auto region = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 9.0}, {9.0, 10.0}, {0.0, 10.0}});
    const double leg = std::numbers::sqrt2 - 1.0;  // 9 + 9 - (19 - sqrt(2))
    EXPECT_NEAR(inset_areas(region, 1.0).at(0), 64.0 - 0.5 * leg * leg, 1e-12);
    EXPECT_NEAR(inset_areas(region, 2.0).at(0), 36.0, 1e-12);
}

TEST(Inset, OfATwoSidedBubbleIsALens) {
    // The sides are two arcs with half angles of 60 degrees. The distance between their centers is
    // their radius r. The inset is the lens of two circles of radius r - h around the same centers.
    const double chord = 10.0;
    const double half_angle = std::numbers::pi / 3.0;
    const ArcLoops region{{{{0.0, 0.0}, pixel_arc({Vec2(chord, 0.0), half_angle})},
                           {{chord, 0.0}, pixel_arc({Vec2(-chord, 0.0), half_angle})}},
                          {2}};
    const double r = 0.5 * chord / std::sin(half_angle);
    const double small = r - 1.0;
    const double lens = 2.0 * small * small * std::acos(0.5 * r / small) -
                        0.5 * r * std::sqrt(4.0 * small * small - r * r);
    const std::vector<double> areas = inset_areas(region, 1.0);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], lens, 1e-12);
    EXPECT_TRUE(inset_areas(region, 0.51 * r).empty());  // its middle is r / 2 from either side
    EXPECT_TRUE(inset_areas(region, 2.0 * r).empty());
}

TEST(Inset, FallsIntoPartsAndRoundsCornersThatTurnBack) {
    // Two squares of 10 x 10 are joined by a corridor of width 2 and length 4, which has no inset
    // at the distance 1.5. Each part of the inset is a square of 7 x 7 and a bulge toward the
    // corridor, between circles around its two corners. The area of the bulge is twice the integral
    // of 1.5 - sqrt(2.25 - t²) over t from 0 to 1.
    const auto region = polygon({{0.0, 0.0},
                                 {10.0, 0.0},
                                 {10.0, 4.0},
                                 {14.0, 4.0},
                                 {14.0, 0.0},
                                 {24.0, 0.0},
                                 {24.0, 10.0},
                                 {14.0, 10.0},
                                 {14.0, 6.0},
                                 {10.0, 6.0},
                                 {10.0, 10.0},
                                 {0.0, 10.0}});
    const double bulge = 3.0 - (std::sqrt(1.25) + 2.25 * std::asin(1.0 / 1.5));
    const std::vector<double> areas = inset_areas(region, 1.5);
    ASSERT_EQ(areas.size(), 2U);
    EXPECT_NEAR(areas[0], 49.0 + bulge, 1e-12);
    EXPECT_NEAR(areas[1], 49.0 + bulge, 1e-12);
}

TEST(Inset, OfACircleOfThreeArcsIsACircle) {
    // The boundary does not turn at its corners, so the offsets touch there instead of crossing.
    ArcLoops region;
    for (int k = 0; k < 3; ++k) {
        const double a = 2.0 * std::numbers::pi / 3.0 * k + 0.1;
        const double b = a + 2.0 * std::numbers::pi / 3.0;
        const Vec2 from(7.0 * std::cos(a), 7.0 * std::sin(a));
        const Vec2 to(7.0 * std::cos(b), 7.0 * std::sin(b));
        region.sides.push_back({from, pixel_arc({to - from, std::numbers::pi / 3.0})});
    }
    region.loop_ends = {3};
    const std::vector<double> areas = inset_areas(region, 2.0);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], 25.0 * std::numbers::pi, 1e-6);
}

TEST(Inset, OfATinyBubbleIsEmptyForAHugeWidth) {
    const auto region = polygon({{0.0, 0.0}, {1e-3, 0.0}, {0.0, 1e-3}});
    EXPECT_TRUE(inset_areas(region, 100.0).empty());
}

TEST(Inset, LeavesOutSidesWithoutALength) {
    ArcLoops region = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}, {0.0, 3.0}});
    region.sides.insert(region.sides.begin() + 1, {{10.0, 0.0}, pixel_arc({Vec2(0.0, 0.0), 0.1})});
    region.loop_ends = {5};
    EXPECT_NEAR(inset_areas(region, 1.0).at(0), 8.0, 1e-12);
}

TEST(Inset, TracesOneLoopOfSeveral) {
    ArcLoops region = polygon({{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}});
    add_polygon({{20.0, 0.0}, {30.0, 0.0}, {30.0, 3.0}, {20.0, 3.0}}, 0.0, region);
    InsetTracer tracer;
    const ArcLoops& both = tracer.trace(region, 1.0);
    EXPECT_EQ(both.loop_ends.size(), 2U);
    const ArcLoops& second = tracer.trace_loop(region, 1, 1.0);
    ASSERT_EQ(second.loop_ends.size(), 1U);
    EXPECT_NEAR(loop_area(second, 0, second.sides.size()), 8.0, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
