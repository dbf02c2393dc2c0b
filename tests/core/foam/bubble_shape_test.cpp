// SPDX-License-Identifier: Apache-2.0

#include "core/foam/bubble_shape.h"

#include "core/dynamics/shear.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;

BubbleShape shape_of(const Foam& foam, BubbleId bubble) {
    return bubble_shape(snapshot(foam, 1), bubble);
}

// The second moments of a regular polygon are isotropic.
TEST(BubbleShape, ARegularHexagonIsNotElongated) {
    const BubbleShape shape = shape_of(honeycomb(4, 4), BubbleId{5});
    EXPECT_NEAR(shape.perimeter, 6.0 * std::sqrt(2.0 / (3.0 * std::sqrt(3.0))), 1e-14);
    EXPECT_NEAR(shape.elongation, 1.0, 1e-7);  // the square root of a rounding error
}

// Stretching the plane by the factors 1.5 and 1/1.5 stretches the circle of the second moments to
// an ellipse whose axes have the ratio 2.25.
TEST(BubbleShape, AStretchedHexagonIsElongatedByTheRatioOfTheFactors) {
    Foam foam = honeycomb(4, 4);
    foam.domain.width *= 1.5;
    foam.domain.height /= 1.5;
    for (Vec2& position : foam.positions) {
        position = {1.5 * position.x(), position.y() / 1.5};
    }
    const BubbleShape shape = shape_of(foam, BubbleId{5});
    EXPECT_NEAR(shape.elongation, 2.25, 1e-13);
    EXPECT_NEAR(shape.orientation, 0.0, 1e-13);
}

// Simple shear by the strain g maps a circle to an ellipse. Its axes are the singular values of
// ((1, g), (0, 1)), whose ratio is (g/2 + sqrt(1 + g²/4))², and the longer one has the angle
// atan(2/g) / 2.
TEST(BubbleShape, AShearedHexagonHasTheEllipseOfTheShear) {
    for (const double strain : {0.4, -0.4}) {
        Foam foam = honeycomb(4, 4);
        shear(foam, strain);
        const BubbleShape shape = shape_of(foam, BubbleId{5});
        const double g = std::abs(strain);
        EXPECT_NEAR(shape.elongation, std::pow(0.5 * g + std::sqrt(1.0 + 0.25 * g * g), 2), 1e-13);
        EXPECT_NEAR(shape.orientation, 0.5 * std::atan(2.0 / strain), 1e-13);
    }
}

TEST(BubbleShape, OfALoneBubbleIsACircle) {
    const BubbleShape shape =
        bubble_shape({.identity = 1, .center = {3.0, 4.0}, .target_area = 4.0 * kPi});
    EXPECT_EQ(shape.center, Vec2(3.0, 4.0));
    EXPECT_NEAR(shape.perimeter, 4.0 * kPi, 1e-14);
    EXPECT_EQ(shape.elongation, 1.0);
    EXPECT_EQ(shape.orientation, 0.0);
}

// The longer axis of a lens is its chord.
TEST(BubbleShape, OfABubbleOfTwoSidesIsALens) {
    Foam foam = honeycomb(4, 4);
    const HalfEdgeId h = foam.network.first(BubbleId{5});
    const Vec2 direction = chord(foam, h);
    const BubbleId lens = test::insert_lens(foam, film_of(h), 0.4);
    const BubbleShape shape = shape_of(foam, lens);
    EXPECT_GT(shape.elongation, 1.5);
    const double angle = std::atan(direction.y() / direction.x());
    EXPECT_NEAR(std::remainder(shape.orientation - angle, kPi), 0.0, 1e-12);
}

/// Returns the polygon of points on the arcs of a bubble as the shape of its own, by the formulas
/// for polygons, relative to its first corner.
BubbleShape sampled_shape(const Frame& frame, BubbleId bubble) {
    constexpr int kPoints = 3000;  // per film; the error decreases with its square
    double area = 0.0;
    double length = 0.0;
    Vec2 first = Vec2::Zero();
    Mat2 second = Mat2::Zero();
    Vec2 corner = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        Vec2 a = corner;
        for (int k = 1; k <= kPoints; ++k) {
            const Vec2 b = corner + point_at(frame.arc(h), static_cast<double>(k) / kPoints);
            const double triangle = 0.5 * cross(a, b);
            area += triangle;
            length += (b - a).norm();
            first += triangle / 3.0 * (a + b);
            second += triangle / 12.0 *
                      (2.0 * a * a.transpose() + 2.0 * b * b.transpose() + a * b.transpose() +
                       b * a.transpose());
            a = b;
        }
        corner = a;
    }
    const Mat2 central = second - first * first.transpose() / area;
    const double spread = std::hypot(0.5 * (central(0, 0) - central(1, 1)), central(0, 1));
    const double mean = 0.5 * central.trace();
    return {frame.positions[frame.network.tail(frame.network.first(bubble))] + first / area,
            length,
            std::sqrt((mean + spread) / (mean - spread)),
            0.5 * std::atan2(2.0 * central(0, 1), central(0, 0) - central(1, 1))};
}

TEST(BubbleShape, AgreesWithPolygonsOfPointsOnTheArcs) {
    for (const Foam& foam : {test::polydisperse_foam(40, 3), test::patch_foam(12, 3)}) {
        const Frame frame = snapshot(foam, 1);
        for (const BubbleId bubble : frame.network.bubbles()) {
            const BubbleShape shape = bubble_shape(frame, bubble);
            const BubbleShape sampled = sampled_shape(frame, bubble);
            EXPECT_LT((shape.center - sampled.center).norm(), 1e-6);
            EXPECT_NEAR(shape.perimeter / sampled.perimeter, 1.0, 1e-6);
            EXPECT_NEAR(shape.elongation / sampled.elongation, 1.0, 1e-6);
            if (shape.elongation > 1.01) {
                EXPECT_NEAR(
                    std::remainder(shape.orientation - sampled.orientation, kPi), 0.0, 1e-5);
            }
        }
    }
}

// The bubble has the form of an eight: a left lobe of area 0.5, and a smaller right lobe, which is
// inverted. Its second moment along the x axis is negative.
TEST(BubbleShape, ABubbleThatOverlapsItselfMayHaveNoEllipse) {
    Foam foam = honeycomb(4, 4);
    const std::vector<Vec2> corners = {
        {1.0, 1.0}, {2.6, 1.8}, {2.6, 1.5}, {2.6, 1.2}, {1.0, 2.0}, {1.0, 1.5}};
    std::size_t k = 0;
    for (const HalfEdgeId h : foam.network.around(BubbleId{5})) {
        foam.positions[foam.network.tail(h)] = corners[k++];
    }
    ASSERT_NEAR(bubble_area(foam, BubbleId{5}), 0.5 - 0.18, 1e-14);
    const BubbleShape shape = shape_of(foam, BubbleId{5});
    EXPECT_TRUE(std::isnan(shape.elongation));
    EXPECT_TRUE(std::isnan(shape.orientation));
}

TEST(BubbleShape, AnInvertedBubbleHasNoEllipse) {
    Foam foam = honeycomb(4, 4);
    for (const HalfEdgeId h : foam.network.around(BubbleId{5})) {
        Vec2& corner = foam.positions[foam.network.tail(h)];
        corner.x() = 4.0 - corner.x();
    }
    EXPECT_TRUE(std::isnan(shape_of(foam, BubbleId{5}).elongation));
}

}  // namespace
}  // namespace foam
