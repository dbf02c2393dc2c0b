#include "texgen/raster/side_arc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;

double brute_distance(const FilmArc& arc, const Vec2& tail, const Vec2& point) {
    double least = 1e300;
    for (int k = 0; k <= 5000; ++k) {
        least = std::min(least, (tail + foam::point_at(arc, k / 5000.0) - point).norm());
    }
    return least;
}

TEST(SideArc, PlacesAQuarterCircle) {
    // Counter-clockwise around the origin, from (1, 0) to (0, 1).
    const SideArc side = place(pixel_arc({Vec2(-1.0, 1.0), kPi / 4.0}), {1.0, 0.0});
    EXPECT_NEAR(side.curvature, 1.0, 1e-15);
    EXPECT_NEAR((side.tail_tangent - Vec2(0.0, 1.0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((side.head_tangent - Vec2(-1.0, 0.0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((side.middle - Vec2(std::sqrt(0.5), std::sqrt(0.5))).norm(), 0.0, 1e-15);
    EXPECT_NEAR((point_at(side, -side.reach) - side.tail).norm(), 0.0, 1e-15);
    EXPECT_NEAR((point_at(side, side.reach) - side.head).norm(), 0.0, 1e-15);
}

TEST(SideArc, DistanceIsThatToTheNearestPoint) {
    for (const double half_angle : {-2.5, -1.0, -0.1, 0.0, 1e-9, 0.2, 1.2, 2.0}) {
        const FilmArc arc{Vec2(3.0, 1.0), half_angle};
        const SideArc side = place(pixel_arc(arc), {1.0, 2.0});
        for (const double x : {-1.7, -0.4, 0.9, 1.6, 2.5, 3.3, 4.2, 5.9}) {
            for (const double y : {-1.1, 0.3, 1.4, 2.2, 3.1, 4.6}) {
                const Vec2 point(x, y);
                EXPECT_NEAR(distance(side, point), brute_distance(arc, {1.0, 2.0}, point), 1e-3)
                    << half_angle << " at " << point.transpose();
            }
        }
    }
}

TEST(SideArc, OffsetKeepsItsDistanceAndItsNormals) {
    for (const double half_angle : {-1.3, -0.2, 0.0, 0.4, 1.3}) {
        const SideArc side = place(pixel_arc({Vec2(10.0, -4.0), half_angle}), {2.0, 3.0});
        const std::optional<SideArc> offset = offset_left(side, 1.5);
        ASSERT_TRUE(offset.has_value());
        for (int k = 0; k <= 10; ++k) {
            const double along = (0.2 * k - 1.0);
            const Vec2 here = point_at(side, along * side.reach);
            const Vec2 there = point_at(*offset, along * offset->reach);
            EXPECT_NEAR((there - here).norm(), 1.5, 1e-12);
            EXPECT_NEAR(distance(side, there), 1.5, 1e-12);
        }
    }
}

TEST(SideArc, OffsetEndsAtTheCentre) {
    const SideArc side = place(pixel_arc({Vec2(-1.0, 1.0), kPi / 4.0}), {1.0, 0.0});  // of radius 1
    EXPECT_TRUE(offset_left(side, 0.999).has_value());
    EXPECT_FALSE(offset_left(side, 1.0).has_value());
    EXPECT_FALSE(offset_left(side, 2.0).has_value());
}

TEST(SideArc, LinesCrossOnce) {
    // Along y = 0 to the right; the other comes down x = 3, so that its left is at x > 3.
    const SideArc arc = place(pixel_arc({Vec2(2.0, 0.0), 0.0}), {0.0, 0.0});
    const SideArc other = place(pixel_arc({Vec2(0.0, -2.0), 0.0}), {3.0, 1.0});
    const Crossings found = crossings(arc, other);
    EXPECT_NEAR(found.entering, 2.0, 1e-15);  // from the middle, x = 1
    EXPECT_FALSE(std::isfinite(found.leaving));
}

TEST(SideArc, ALineEntersAndLeavesACircle) {
    // The unit circle, counter-clockwise: its left is its inside.
    const SideArc line = place(pixel_arc({Vec2(6.0, 0.0), 0.0}), {-3.0, 0.6});
    const SideArc circle = place(pixel_arc({Vec2(-1.0, 1.0), kPi / 4.0}), {1.0, 0.0});
    const Crossings found = crossings(line, circle);
    EXPECT_NEAR(found.entering, -0.8, 1e-14);
    EXPECT_NEAR(found.leaving, 0.8, 1e-14);
}

TEST(SideArc, CrossingsLieOnBothArcs) {
    for (const double a : {-1.2, -0.3, 0.0, 1e-12, 0.5, 1.4}) {
        for (const double b : {-0.9, 0.0, 1e-9, 0.7}) {
            const SideArc arc = place(pixel_arc({Vec2(4.0, 1.0), a}), {0.0, 0.0});
            const SideArc other = place(pixel_arc({Vec2(-1.0, 5.0), b}), {2.5, -2.0});
            const Crossings found = crossings(arc, other);
            const double within =
                std::abs(found.entering) < arc.reach ? found.entering : found.leaving;
            ASSERT_LT(std::abs(within), arc.reach);
            EXPECT_NEAR(distance(other, point_at(arc, within)), 0.0, 1e-12) << a << " " << b;
        }
    }
}

TEST(SideArc, PieceGoesFromPointToPoint) {
    const SideArc side = place(pixel_arc({Vec2(4.0, 1.0), 1.1}), {2.0, 2.0});
    const FilmArc part = film_arc(piece(side, -0.5, 1.0));
    EXPECT_NEAR(foam::curvature(part), side.curvature, 1e-14);
    EXPECT_NEAR((part.chord - (point_at(side, 1.0) - point_at(side, -0.5))).norm(), 0.0, 1e-15);
    const FilmArc whole = film_arc(piece(side, -side.reach, side.reach));
    EXPECT_NEAR(whole.half_angle, 1.1, 1e-14);
}

}  // namespace
}  // namespace foam::texgen
