// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/full_inset.h"

#include "tests/support/sample_foams.h"
#include "tests/support/simd_levels.h"
#include "tests/texgen/raster/outline/polygons.h"
#include "texgen/raster/outline/inset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foam::texgen {
namespace {

std::vector<Vec2> regular(int count, double radius) {
    std::vector<Vec2> corners;
    for (int k = 0; k < count; ++k) {
        const double angle = k * 6.283185307179586 / count;
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return corners;
}

bool shows_every_side(const ArcLoops& outline, double distance) {
    return FullInset().trace(outline.sides, distance) != nullptr;
}

TEST(FullInset, OfARectangleIsARectangle) {
    at_every_simd_level([] {
        FullInset full;
        const ArcLoops* inset = full.trace(polygon({{0, 0}, {9, 0}, {9, 5}, {0, 5}}).sides, 1.0);
        ASSERT_NE(inset, nullptr);
        const ArcLoops& loops = *inset;
        ASSERT_EQ(loops.loop_ends, std::vector<std::size_t>{4});
        const std::vector<Vec2> tails{{1, 1}, {8, 1}, {8, 4}, {1, 4}};
        for (std::size_t k = 0; k < tails.size(); ++k) {
            EXPECT_LT((loops.sides[k].tail - tails[k]).norm(), 1e-12);
            EXPECT_NEAR(loops.sides[k].arc.sine, 0.0, 1e-15);
        }
    });
}

// The offset of an arc has the same center as the arc. The hexagon is symmetric, so the corners of
// the inset are on its bisectors.
TEST(FullInset, KeepTheCurvatureCentersOfASymmetricBubble) {
    const std::vector<Vec2> corners = regular(6, 10.0);
    FullInset full;
    const ArcLoops* inset = full.trace(polygon(corners, 0.2).sides, 1.0);
    ASSERT_NE(inset, nullptr);
    const ArcLoops& loops = *inset;
    ASSERT_EQ(loops.sides.size(), 6U);
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(cross(loops.sides[k].tail, corners[k]), 0.0, 1e-9);
        EXPECT_LT(loops.sides[k].tail.norm(), 10.0);
    }
}

TEST(FullInset, AreNotProvenWhereASideDropsOut) {
    const auto cut_corner = polygon({{0, 0}, {10, 0}, {10, 9.5}, {9.5, 10}, {0, 10}});
    EXPECT_TRUE(shows_every_side(cut_corner, 0.5));
    EXPECT_FALSE(shows_every_side(cut_corner, 3.0));
    EXPECT_FALSE(shows_every_side(polygon({{0, 0}, {9, 0}, {9, 2}, {0, 2}}), 1.5));
    EXPECT_FALSE(shows_every_side(polygon({{0, 0}, {9, 0}}), 0.1));                  // two sides
    EXPECT_FALSE(shows_every_side(polygon({{0, 0}, {9, 0}, {9, 0}, {9, 5}}), 0.1));  // no length
}

// The inner corner of an L turns right, so a circular arc around this corner is part of the
// boundary of the inset.
TEST(FullInset, AreNotProvenAtACornerThatTurnsRight) {
    EXPECT_FALSE(
        shows_every_side(polygon({{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}), 1.0));
}

// The long sides bend inward. The second bubble has a waist of 0.6, less than twice the distance.
// Its inset consists of two parts, one at either end.
TEST(FullInset, AreNotProvenWhereOppositeSidesAreTooNear) {
    at_every_simd_level([] {
        const std::vector<Vec2> corners{{0, 0}, {10, 0}, {10, 2}, {0, 2}};
        EXPECT_TRUE(shows_every_side(polygon(corners, -0.05), 0.35));
        EXPECT_FALSE(shows_every_side(polygon(corners, -0.28), 0.35));
    });
}

TEST(FullInset, AreNotProvenForLoopsOfFewerThanThreeSides) {
    EXPECT_FALSE(shows_every_side({}, 1.0));
    EXPECT_FALSE(shows_every_side(polygon({{0, 0}, {9, 0}}, 0.5), 1.0));
    EXPECT_TRUE(shows_every_side(polygon(regular(4, 20.0)), 1.0));
}

TEST(FullInset, AreFoundForLoopsOfAnyLength) {
    EXPECT_TRUE(shows_every_side(polygon(regular(12, 40.0)), 1.0));
    EXPECT_TRUE(shows_every_side(polygon(regular(600, 1000.0)), 1.0));
}

// Returns the outlines of all bubbles, in foam units.
ArcLoops outlines_of(const Foam& foam) {
    const Frame frame = snapshot(foam, 1);
    ArcLoops outlines;
    for (const BubbleId bubble : frame.network.bubbles()) {
        Vec2 tail = Vec2::Zero();
        for (const HalfEdgeId h : frame.network.around(bubble)) {
            outlines.sides.push_back({tail, pixel_arc(frame.arc(h))});
            tail += outlines.sides.back().arc.chord;
        }
        outlines.loop_ends.push_back(outlines.sides.size());
    }
    return outlines;
}

void expect_same(const ArcLoops& found, const ArcLoops& expected) {
    ASSERT_EQ(found.loop_ends, expected.loop_ends);
    for (std::size_t k = 0; k < found.sides.size(); ++k) {
        const ArcLoops::Side& a = found.sides[k];
        const ArcLoops::Side& b = expected.sides[k];
        EXPECT_EQ(a.tail, b.tail);
        EXPECT_EQ(a.arc.chord, b.arc.chord);
        EXPECT_EQ(a.arc.cosine, b.arc.cosine);
        EXPECT_EQ(a.arc.sine, b.arc.sine);
    }
}

// Expects that FullInset and InsetTracer find the same insets. Returns the number of bubbles for
// which FullInset proves that every side is visible.
int compare_with_all_cuts(const Foam& foam, double distance) {
    const ArcLoops outlines = outlines_of(foam);
    FullInset full;
    InsetTracer tracer;
    int proven = 0;
    for (std::size_t loop = 0; loop < outlines.loop_ends.size(); ++loop) {
        if (const ArcLoops* found = full.trace(outlines.loop(loop), distance)) {
            ++proven;
            expect_same(*found, tracer.trace_loop(outlines, loop, distance));
        }
    }
    return proven;
}

TEST(FullInset, AreThoseOfTheTracerToTheLastBit) {
    at_every_simd_level([] {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            for (const double distance : {0.01, 0.04, 0.1, 0.2, 0.35}) {
                compare_with_all_cuts(test::bent_foam(200, 0.3, seed), distance);
                compare_with_all_cuts(test::bent_foam(60, 1.5, seed), distance);
                compare_with_all_cuts(test::polydisperse_foam(60, seed), distance);
            }
        }
        EXPECT_GT(compare_with_all_cuts(test::polydisperse_foam(300, 1), 0.05), 200);
    });
}

}  // namespace
}  // namespace foam::texgen
