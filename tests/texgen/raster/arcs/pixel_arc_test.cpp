// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/pixel_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(MonotonePieces, LeavesAShortArcWhole) {
    const FilmArc arc{{3.0, 4.0}, 0.2};
    const auto all = monotone_pieces(pixel_arc(arc));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].head, arc.chord);
    EXPECT_EQ(all[0].sine, std::sin(0.2));
}

// Both arcs have the radius 1. The first one starts upward around (-1, 0), the second one to the
// left around (0, 1).
TEST(MonotonePieces, SplitsThreeQuartersOfACircle) {
    const double sine = std::sin(0.25 * kPi);
    const auto left = monotone_pieces(pixel_arc({{-1.0, -1.0}, 0.75 * kPi}));
    ASSERT_EQ(left.size(), 3U);
    EXPECT_NEAR((left[0].head - Vec2(-1.0, 1.0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((left[1].head - Vec2(-2.0, 0.0)).norm(), 0.0, 1e-15);
    const auto right = monotone_pieces(pixel_arc({{1.0, 1.0}, -0.75 * kPi}));
    ASSERT_EQ(right.size(), 3U);
    EXPECT_NEAR((right[0].head - Vec2(-1.0, 1.0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((right[1].head - Vec2(0.0, 2.0)).norm(), 0.0, 1e-15);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(left[k].sine, sine, 1e-15);
        EXPECT_NEAR(right[k].sine, -sine, 1e-15);
    }
}

// The pieces are consecutive parts of the arc, and each one is monotone in x and in y.
TEST(MonotonePieces, PiecesAreOfTheArc) {
    for (int k = 1; k < 1000; ++k) {
        const double direction = 0.37 * k;
        const double half_angle = 3.1 * std::sin(0.11 * k);
        const FilmArc arc{Vec2(std::cos(direction), std::sin(direction)), half_angle};
        const auto all = monotone_pieces(pixel_arc(arc));
        double turned = 0.0;
        Vec2 tail(0.0, 0.0);
        for (const MonotonePiece& piece : all) {
            turned += std::asin(piece.sine);
            const Vec2 expected = point_at(arc, turned / half_angle);
            EXPECT_NEAR((piece.head - expected).norm(), 0.0, 1e-11) << k;
            const FilmArc part{piece.head - tail, std::asin(piece.sine)};
            const Vec2 first = tangent_at_tail(part);
            const Vec2 last = tangent_at_head(part);
            EXPECT_GE(first.x() * last.x(), -1e-9) << k;
            EXPECT_GE(first.y() * last.y(), -1e-9) << k;
            tail = piece.head;
        }
        EXPECT_NEAR(turned, half_angle, 1e-11) << k;
    }
}

TEST(MonotonePieces, TwiceTheSegmentIsNearlyExact) {
    for (const double half_angle : {-0.5, 0.01, 0.1, 0.2, 0.5}) {
        const FilmArc arc{{3.0, 1.0}, half_angle};
        EXPECT_NEAR(
            twice_segment(10.0, std::sin(half_angle)) / (2.0 * segment_area(arc)), 1.0, 6e-5);
    }
    const FilmArc quarter{{1.0, 0.0}, 0.25 * kPi};
    EXPECT_NEAR(
        twice_segment(1.0, std::sin(0.25 * kPi)) / (2.0 * segment_area(quarter)), 1.0, 2.5e-3);
}

}  // namespace
}  // namespace foam::texgen
