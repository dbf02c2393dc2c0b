// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/region.h"

#include "texgen/raster/coords/fixed_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::texgen {
namespace {

PixelArc arc_of(const Vec2& chord, double half_angle) {
    return pixel_arc({chord, half_angle});
}

TEST(Boundary, HalvesMeetInTheMiddleOfTheArc) {
    for (const double half_angle : {-2.9, -1.0, 1e-9, 0.4, 1.57, 3.0}) {
        const FilmArc film{{3.0, -1.0}, half_angle};
        const auto [first, second] = halves(pixel_arc(film));
        EXPECT_LT((first.chord - point_at(film, 0.5)).norm(), 1e-8);
        EXPECT_LT((first.chord + second.chord - film.chord).norm(), 1e-14);
        EXPECT_NEAR(film_arc(first).half_angle, 0.5 * half_angle, 1e-12);
        EXPECT_NEAR(film_arc(second).half_angle, 0.5 * half_angle, 1e-12);
    }
}

// The tangents at a corner determine whether a boundary turns right. They depend on the chords and
// on the half angles.
TEST(Boundary, TurnsRightByItsTangents) {
    const PixelArc straight = arc_of({2.0, 0.0}, 0.0);
    EXPECT_TRUE(turns_right(straight, arc_of({1.0, -1.0}, 0.0)));
    EXPECT_FALSE(turns_right(straight, arc_of({1.0, 1.0}, 0.0)));
    EXPECT_TRUE(turns_right(straight, arc_of({1.0, 1.0}, 1.0)));
    EXPECT_FALSE(turns_right(straight, arc_of({1.0, -1.0}, -1.0)));
    EXPECT_FALSE(turns_right(arc_of({2.0, 0.0}, -1.0), arc_of({1.0, -1.0}, 0.0)));
}

TEST(Boundary, ExtentEnclosesTheBoundary) {
    for (const double half_angle : {-2.5, -0.7, 0.0, 0.6, 1.5, 3.0}) {
        const FilmArc film{{4.0, 3.0}, half_angle};
        const Vec2 tail(10.25, 20.5);
        const Vec2 from = tail * kSubpixel;
        const Vec2 to = (tail + film.chord) * kSubpixel;
        const PixelArc arc = pixel_arc(film);
        Boundary boundary;
        boundary.add_edge({from, to, arc.cosine, arc.sine});
        boundary.add_edge({to, from, arc.cosine, -arc.sine});
        const Extent extent = boundary.extent();
        for (int k = 0; k <= 100; ++k) {
            const Vec2 point = kSubpixel * (tail + point_at(film, 0.01 * k));
            EXPECT_TRUE((extent.lowest.array() <= point.array()).all()) << half_angle;
            EXPECT_TRUE((extent.highest.array() >= point.array()).all()) << half_angle;
        }
    }
}

// The region is a square with a square hole. It has angles of more than 180 degrees only at the
// corners of the hole.
TEST(Boundary, FindsTheCornersOfEachLoop) {
    const auto add_square = [](double side, double turn, Boundary& boundary) {
        Vec2 tail(1.0, 1.0);
        Vec2 chord(side, 0.0);
        for (int k = 0; k < 4; ++k) {
            boundary.add_arc({chord, 1.0, 0.0}, tail);
            tail += chord;
            chord = turn * turned_left(chord);
        }
        boundary.close_loop();
    };
    Boundary boundary;
    add_square(5.0, 1.0, boundary);
    add_square(3.0, -1.0, boundary);
    ASSERT_EQ(boundary.arcs().size(), 8U);
    for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_EQ(boundary.arcs()[k].corner, k >= 4) << k;
    }
    boundary.clear();
    EXPECT_EQ(boundary.arcs().size(), 0U);
    EXPECT_TRUE(boundary.outline().empty());
}

TEST(Boundary, HalvesWideArcsAndLeavesOutThoseOfNoLength) {
    Boundary boundary;
    boundary.add_arc(arc_of({2.0, 0.0}, 0.3), {1.0, 1.0});
    EXPECT_EQ(boundary.films().size(), boundary.arcs().size());
    boundary.add_arc(arc_of({0.0, 0.0}, 0.3), {3.0, 1.0});
    boundary.add_arc(arc_of({0.0, 2.0}, 1.2), {3.0, 1.0});
    boundary.add_arc(arc_of({-2.0, -2.0}, 0.0), {3.0, 3.0});
    boundary.close_loop();
    ASSERT_EQ(boundary.arcs().size(), 4U);
    ASSERT_EQ(boundary.films().size(), 3U);
    EXPECT_LT((boundary.arcs()[1].head() - boundary.arcs()[2].tail).norm(), 1e-14);
    EXPECT_LT((boundary.arcs()[2].head() - Vec2(3.0, 3.0)).norm(), 1e-14);
    EXPECT_EQ(boundary.films()[1].shape.chord, Vec2(0.0, 2.0));
}

}  // namespace
}  // namespace foam::texgen
