// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/offset_arc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;

double brute_distance(const FilmArc& arc, const Vec2& tail, const Vec2& point) {
    double min_distance = 1e300;
    for (int k = 0; k <= 5000; ++k) {
        min_distance =
            std::min(min_distance, (tail + foam::point_at(arc, k / 5000.0) - point).norm());
    }
    return min_distance;
}

TEST(OffsetArc, PlacesAQuarterCircle) {
    // The arc goes counter-clockwise around the origin, from (1, 0) to (0, 1).
    const OffsetArc side = offset_arc_from(pixel_arc({Vec2(-1.0, 1.0), kPi / 4.0}), {1.0, 0.0});
    EXPECT_NEAR(side.curvature, 1.0, 1e-15);
    EXPECT_NEAR((tail_tangent(side) - Vec2(0.0, 1.0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((head_tangent(side) - Vec2(-1.0, 0.0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((side.middle - Vec2(std::sqrt(0.5), std::sqrt(0.5))).norm(), 0.0, 1e-15);
    EXPECT_NEAR((point_at(side, -side.reach) - Vec2(1.0, 0.0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((point_at(side, side.reach) - Vec2(0.0, 1.0)).norm(), 0.0, 1e-15);
}

TEST(OffsetArc, DistanceIsThatToTheNearestPoint) {
    for (const double half_angle : {-2.5, -1.0, -0.1, 0.0, 1e-9, 0.2, 1.2, 2.0}) {
        const FilmArc arc{Vec2(3.0, 1.0), half_angle};
        const OffsetArc side = offset_arc_from(pixel_arc(arc), {1.0, 2.0});
        for (const double x : {-1.7, -0.4, 0.9, 1.6, 2.5, 3.3, 4.2, 5.9}) {
            for (const double y : {-1.1, 0.3, 1.4, 2.2, 3.1, 4.6}) {
                const Vec2 point(x, y);
                EXPECT_NEAR(distance(side, point), brute_distance(arc, {1.0, 2.0}, point), 1e-3)
                    << half_angle << " at " << x << ", " << y;
            }
        }
    }
}

TEST(OffsetArc, OffsetKeepsItsDistanceAndItsNormals) {
    for (const double half_angle : {-1.3, -0.2, 0.0, 0.4, 1.3}) {
        const OffsetArc side =
            offset_arc_from(pixel_arc({Vec2(10.0, -4.0), half_angle}), {2.0, 3.0});
        const OffsetArc offset = offset_left(side, 1.5);
        for (int k = 0; k <= 10; ++k) {
            const double along = (0.2 * k - 1.0);
            const Vec2 on_side = point_at(side, along * side.reach);
            const Vec2 on_offset = point_at(offset, along * offset.reach);
            EXPECT_NEAR((on_offset - on_side).norm(), 1.5, 1e-12);
            EXPECT_NEAR(distance(side, on_offset), 1.5, 1e-12);
        }
    }
}

TEST(OffsetArc, ShrinksToNothingAtTheCenter) {
    const OffsetArc side =
        offset_arc_from(pixel_arc({Vec2(-1.0, 1.0), kPi / 4.0}), {1.0, 0.0});  // of radius 1
    EXPECT_NEAR(shrinkage(side, 0.25), 0.75, 1e-15);
    EXPECT_NEAR(shrinkage(side, 1.0), 0.0, 1e-15);
    EXPECT_NEAR(shrinkage(side, 2.0), -1.0, 1e-15);
    EXPECT_NEAR(offset_left(side, 0.25).curvature, 1.0 / 0.75, 1e-14);
}

TEST(OffsetArc, LinesCrossOnce) {
    // The first line goes to the right along y = 0. The other one goes down along x = 3, so that
    // its left is at x > 3.
    const OffsetArc arc = offset_arc_from(pixel_arc({Vec2(2.0, 0.0), 0.0}), {0.0, 0.0});
    const OffsetArc other = offset_arc_from(pixel_arc({Vec2(0.0, -2.0), 0.0}), {3.0, 1.0});
    const Crossings found = crossings(arc, other);
    EXPECT_NEAR(found.entering, 2.0, 1e-15);  // from the middle of the arc, x = 1
    EXPECT_FALSE(std::isfinite(found.leaving));
}

TEST(OffsetArc, ALineEntersAndLeavesACircle) {
    // The unit circle is counter-clockwise, so that its left is its inside.
    const OffsetArc line = offset_arc_from(pixel_arc({Vec2(6.0, 0.0), 0.0}), {-3.0, 0.6});
    const OffsetArc circle = offset_arc_from(pixel_arc({Vec2(-1.0, 1.0), kPi / 4.0}), {1.0, 0.0});
    const Crossings found = crossings(line, circle);
    EXPECT_NEAR(found.entering, -0.8, 1e-14);
    EXPECT_NEAR(found.leaving, 0.8, 1e-14);
}

TEST(OffsetArc, CrossingsLieOnBothArcs) {
    for (const double a : {-1.2, -0.3, 0.0, 1e-12, 0.5, 1.4}) {
        for (const double b : {-0.9, 0.0, 1e-9, 0.7}) {
            const OffsetArc arc = offset_arc_from(pixel_arc({Vec2(4.0, 1.0), a}), {0.0, 0.0});
            const OffsetArc other = offset_arc_from(pixel_arc({Vec2(-1.0, 5.0), b}), {2.5, -2.0});
            const Crossings found = crossings(arc, other);
            const double within =
                std::abs(found.entering) < arc.reach ? found.entering : found.leaving;
            ASSERT_LT(std::abs(within), arc.reach);
            EXPECT_NEAR(distance(other, point_at(arc, within)), 0.0, 1e-12) << a << " " << b;
        }
    }
}

TEST(OffsetArc, APieceTurnsByItsShareOfTheArc) {
    const OffsetArc side = offset_arc_from(pixel_arc({Vec2(4.0, 1.0), 1.1}), {2.0, 2.0});
    const HalfAngle turn = half_angle_between(side.curvature, -0.5, 1.0);
    const FilmArc part =
        film_arc({point_at(side, 1.0) - point_at(side, -0.5), turn.cosine, turn.sine});
    EXPECT_NEAR(foam::curvature(part), side.curvature, 1e-14);
    const HalfAngle whole = half_angle_between(side.curvature, -side.reach, side.reach);
    EXPECT_NEAR(std::atan2(whole.sine, whole.cosine), 1.1, 1e-14);
}

// At the origin, a side along the x axis meets a side that turns right by 60 degrees.
TEST(OffsetArc, ACornerIsRoundedFromOffsetToOffset) {
    const OffsetArc before = offset_arc_from(pixel_arc({Vec2(4.0, 0.0), 0.0}), {-4.0, 0.0});
    const Vec2 ahead(std::cos(kPi / 3.0), -std::sin(kPi / 3.0));
    const OffsetArc after = offset_arc_from(pixel_arc({3.0 * ahead, 0.0}), {0.0, 0.0});
    const OffsetArc corner = corner_arc(before, after, 2.0);
    const OffsetArc first = offset_left(before, 2.0);
    const OffsetArc second = offset_left(after, 2.0);
    EXPECT_NEAR(
        (point_at(corner, -corner.reach) - point_at(first, first.reach)).norm(), 0.0, 1e-14);
    EXPECT_NEAR(
        (point_at(corner, corner.reach) - point_at(second, -second.reach)).norm(), 0.0, 1e-14);
    EXPECT_NEAR(point_at(corner, 0.3).norm(), 2.0, 1e-14);
}

// The ends of the arc are on the border of the disc, and no point of the arc is outside.
TEST(OffsetArc, ExtentIsTheRadiusOfTheDiscThatHoldsIt) {
    for (const double half_angle : {-2.8, -1.0, 0.0, 0.4, 2.0}) {
        const OffsetArc arc = offset_arc_from(pixel_arc({Vec2(3.0, 1.0), half_angle}), {1.0, 2.0});
        EXPECT_NEAR((point_at(arc, arc.reach) - arc.middle).norm(), extent(arc), 1e-12);
        EXPECT_NEAR((point_at(arc, -arc.reach) - arc.middle).norm(), extent(arc), 1e-12);
        for (const double part : {-0.9, -0.5, 0.3, 0.8}) {
            EXPECT_LE((point_at(arc, part * arc.reach) - arc.middle).norm(), extent(arc) + 1e-12);
        }
    }
}

// The arc turns left for the sign 1, and right for the sign -1.
TEST(OffsetArc, DistanceLeftIsSigned) {
    for (const double sign : {1.0, -1.0}) {
        const OffsetArc arc =
            offset_arc_from(pixel_arc({Vec2(0.0, sign * 2.0), sign * 1.2}), {0.0, 0.0});
        const Vec2 center = arc.middle + turned_left(arc.direction) / arc.curvature;
        for (const double x : {-2.0, 0.1, 1.5}) {
            for (const double y : {-1.0, 0.7, 3.0}) {
                const double expected =
                    (1.0 / std::abs(arc.curvature)) - (Vec2(x, y) - center).norm();
                EXPECT_NEAR(distance_left(arc, {x, y}), sign * expected, 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace foam::texgen
