#include "texgen/raster/distance/distance_arc.h"

#include "texgen/raster/coords/fixed_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::texgen {
namespace {

PixelArc arc_of(const Vec2& chord, double half_angle) {
    return pixel_arc({chord, half_angle});
}

TEST(DistanceArc, HalvesMeetInTheMiddleOfTheArc) {
    for (const double half_angle : {-2.9, -1.0, 1e-9, 0.4, 1.57, 3.0}) {
        const FilmArc film{{3.0, -1.0}, half_angle};
        const auto [first, second] = halves(pixel_arc(film));
        EXPECT_LT((first.chord - point_at(film, 0.5)).norm(), 1e-8);
        EXPECT_LT((first.chord + second.chord - film.chord).norm(), 1e-14);
        EXPECT_NEAR(film_arc(first).half_angle, 0.5 * half_angle, 1e-12);
        EXPECT_NEAR(film_arc(second).half_angle, 0.5 * half_angle, 1e-12);
    }
}

// The tangents at the corner differ by the angle between the chords and both half angles.
TEST(DistanceArc, TurnsRightByItsTangents) {
    const PixelArc straight = arc_of({2.0, 0.0}, 0.0);
    EXPECT_TRUE(turns_right(straight, arc_of({1.0, -1.0}, 0.0)));
    EXPECT_FALSE(turns_right(straight, arc_of({1.0, 1.0}, 0.0)));
    EXPECT_TRUE(turns_right(straight, arc_of({1.0, 1.0}, 1.0)));
    EXPECT_FALSE(turns_right(straight, arc_of({1.0, -1.0}, -1.0)));
    EXPECT_FALSE(turns_right(arc_of({2.0, 0.0}, -1.0), arc_of({1.0, -1.0}, 0.0)));
}

TEST(DistanceArc, ExtentEnclosesTheBoundary) {
    for (const double half_angle : {-2.5, -0.7, 0.0, 0.6, 1.5, 3.0}) {
        const FilmArc film{{4.0, 3.0}, half_angle};
        const Vec2 tail(10.25, 20.5);
        Boundary boundary;
        boundary.sides.push_back(
            {pixel_arc(film), tail, tail * kSubpixel, (tail + film.chord) * kSubpixel});
        boundary.sides.push_back({pixel_arc(reversed(film)),
                                  tail + film.chord,
                                  (tail + film.chord) * kSubpixel,
                                  tail * kSubpixel});
        boundary.close_loop();
        const Extent extent = extent_of(boundary);
        for (int k = 0; k <= 100; ++k) {
            const Vec2 point = kSubpixel * (tail + point_at(film, 0.01 * k));
            EXPECT_TRUE((extent.lowest.array() <= point.array()).all()) << half_angle;
            EXPECT_TRUE((extent.highest.array() >= point.array()).all()) << half_angle;
        }
    }
}

TEST(DistanceArc, BoundaryKeepsItsLoopsApart) {
    Boundary boundary;
    boundary.sides.resize(2);
    boundary.close_loop();
    boundary.sides.resize(5);
    boundary.close_loop();
    EXPECT_EQ(boundary.loop(0).size(), 2U);
    EXPECT_EQ(boundary.loop(1).size(), 3U);
    EXPECT_EQ(boundary.loop(1).data(), &boundary.sides[2]);
    boundary.clear();
    EXPECT_TRUE(boundary.loop_ends.empty());
}

}  // namespace
}  // namespace foam::texgen
