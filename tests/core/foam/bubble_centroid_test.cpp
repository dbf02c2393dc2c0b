// SPDX-License-Identifier: Apache-2.0

#include "core/foam/bubble_centroid.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam {
namespace {

// Returns the centroid of the polygon through points on the arcs of a bubble.
Vec2 centroid_of_points(const Frame& frame, BubbleId bubble, int points_per_film) {
    Vec2 tail = frame.positions[frame.network.tail(frame.network.first(bubble))];
    Vec2 before = tail;
    Vec2 moment(0.0, 0.0);
    double area = 0.0;
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        const FilmArc arc = frame.arc(h);
        for (int k = 1; k <= points_per_film; ++k) {
            const Vec2 point = tail + point_at(arc, static_cast<double>(k) / points_per_film);
            area += 0.5 * cross(before, point);
            moment += cross(before, point) / 6.0 * (before + point);
            before = point;
        }
        tail += arc.chord;
    }
    return moment / area;
}

// The error of a polygon of n points per arc is of the order of 1 / n².
void expect_centroids_of_points(const Foam& foam) {
    const Frame frame = snapshot(foam, 1);
    for (const BubbleId bubble : frame.network.bubbles()) {
        const Vec2 coarse = centroid_of_points(frame, bubble, 1000);
        const Vec2 fine = centroid_of_points(frame, bubble, 2000);
        const Vec2 extrapolated = fine + (fine - coarse) / 3.0;
        // The points of a bubble whose area nearly cancels, as in a bent foam, are less accurate.
        const double area = std::abs(frame.bubbles[bubble].area);
        EXPECT_LT(area * (bubble_centroid(frame, bubble) - extrapolated).norm(), 1e-10)
            << index_of(bubble);
    }
}

TEST(BubbleCentroid, IsThatOfManyPointsOnTheArcs) {
    expect_centroids_of_points(test::polydisperse_foam(40, 3));
    expect_centroids_of_points(test::bent_foam(40, 2.0, 5));
}

// The outer films of a patch of two bubbles are arcs of 240 degrees.
TEST(BubbleCentroid, CountsArcsOfMoreThanHalfACircle) {
    expect_centroids_of_points(test::patch_foam(2, 1));
    expect_centroids_of_points(test::patch_foam(12, 1));
}

TEST(BubbleCentroid, OfAHexagonIsItsMiddle) {
    const Frame frame = snapshot(honeycomb(4, 4), 1);
    for (const BubbleId bubble : frame.network.bubbles()) {
        Vec2 corner = frame.positions[frame.network.tail(frame.network.first(bubble))];
        Vec2 sum(0.0, 0.0);
        for (const HalfEdgeId h : frame.network.around(bubble)) {
            sum += corner;
            corner += frame.arc(h).chord;
        }
        EXPECT_LT((bubble_centroid(frame, bubble) - sum / 6.0).norm(), 1e-14);
    }
}

}  // namespace
}  // namespace foam
