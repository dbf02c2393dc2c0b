// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/film_arc.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRoot3 = std::numbers::sqrt3;
constexpr double kEps = std::numeric_limits<double>::epsilon();
// A few rounding errors of numbers of the order of 1.
constexpr double kRounding = 8.0 * kEps;

void expect_vec(const Vec2& actual, const Vec2& expected, double tolerance = kRounding) {
    EXPECT_NEAR(actual.x(), expected.x(), tolerance);
    EXPECT_NEAR(actual.y(), expected.y(), tolerance);
}

// Returns a random number in [-largest, largest].
double any_real(double largest) {
    return *rc::gen::inRange(-1000000, 1000001) * 1e-6 * largest;
}

// Returns an arc with a chord of any direction, 1e-6 to 3 long, and a half angle of up to nearly a
// full circle.
FilmArc any_arc() {
    FilmArc arc{Vec2(any_real(2.0), any_real(2.0)), any_real(3.1)};
    if (arc.chord.norm() < 1e-6) {
        arc.chord = {1.0, 0.0};
    }
    return arc;
}

TEST(FilmArc, AStraightFilmIsItsChord) {
    const FilmArc arc{{3.0, 4.0}, 0.0};
    EXPECT_DOUBLE_EQ(arc_length(arc), 5.0);
    EXPECT_EQ(segment_area(arc), 0.0);
    EXPECT_EQ(curvature(arc), 0.0);
    expect_vec(tangent_at_tail(arc), {0.6, 0.8});
    expect_vec(tangent_at_head(arc), {0.6, 0.8});
    expect_vec(point_at(arc, 0.25), {0.75, 1.0});
}

TEST(FilmArc, AZeroChordIsAnArcOfNoLength) {
    const FilmArc arc{{0.0, 0.0}, 1.0};
    EXPECT_EQ(arc_length(arc), 0.0);
    EXPECT_EQ(segment_area(arc), 0.0);
    EXPECT_EQ(curvature(arc), 0.0);
    expect_vec(point_at(arc, 0.5), {0.0, 0.0});
}

// The arc is the lower half of the unit circle from (-1, 0) to (1, 0), relative to its tail. It is
// below the chord, on its right, and the half disc adds to the area on the left.
TEST(FilmArc, APositiveHalfAngleBulgesToTheRight) {
    const FilmArc arc{{2.0, 0.0}, kPi / 2.0};
    EXPECT_NEAR(arc_length(arc), kPi, kRounding);
    EXPECT_NEAR(segment_area(arc), kPi / 2.0, kRounding);
    EXPECT_NEAR(curvature(arc), 1.0, kRounding);
    expect_vec(tangent_at_tail(arc), {0.0, -1.0});
    expect_vec(tangent_at_head(arc), {0.0, 1.0});
    expect_vec(point_at(arc, 0.0), {0.0, 0.0});
    expect_vec(point_at(arc, 0.5), {1.0, -1.0});
    expect_vec(point_at(arc, 1.0), {2.0, 0.0});
}

// On the unit circle, an arc that turns by t = 2 alpha has the chord 2 sin(t/2), the length t, and
// a segment of the area (t - sin t) / 2: the sector minus the triangle at the center.
TEST(FilmArc, ArcsOfTheUnitCircleHaveTheirLengthAndArea) {
    struct Case {
        double turn;
        double chord;
        double area;
    };
    for (const Case& c : {Case{kPi / 3.0, 1.0, kPi / 6.0 - kRoot3 / 4.0},
                          Case{kPi / 2.0, std::sqrt(2.0), kPi / 4.0 - 0.5},
                          Case{2.0 * kPi / 3.0, kRoot3, kPi / 3.0 - kRoot3 / 4.0},
                          Case{4.0 * kPi / 3.0, kRoot3, 2.0 * kPi / 3.0 + kRoot3 / 4.0},
                          Case{3.0 * kPi / 2.0, std::sqrt(2.0), 3.0 * kPi / 4.0 + 0.5}}) {
        const FilmArc arc{{0.0, c.chord}, 0.5 * c.turn};
        EXPECT_NEAR(arc_length(arc), c.turn, kRounding) << c.turn;
        EXPECT_NEAR(segment_area(arc), c.area, kRounding) << c.turn;
        EXPECT_NEAR(curvature(arc), 1.0, kRounding) << c.turn;
    }
}

TEST(FilmArc, BothSidesOfARightAngleAgree) {
    // At 90 degrees the area grows by c²/2 per radian. If it were computed from sin(alpha), which
    // has the same bits on both sides, it would not grow.
    const FilmArc below{{1.0, 0.0}, kPi / 2.0 - 1e-9};
    const FilmArc above{{1.0, 0.0}, kPi / 2.0 + 1e-9};
    EXPECT_NEAR(segment_area(above) - segment_area(below), 0.5 * 2e-9, kRounding);
}

RC_GTEST_PROP(FilmArc, PointsLieOnOneCircle, ()) {
    const FilmArc arc = any_arc();
    RC_PRE(std::abs(arc.half_angle) > 1e-3);
    const double fraction = *rc::gen::inRange(0, 1001) * 1e-3;
    // The center is on the bisector of the chord, to the left of an arc that turns left.
    const Vec2 center = 0.5 * arc.chord + 0.5 / std::tan(arc.half_angle) * turned_left(arc.chord);
    const double radius = 0.5 * arc.chord.norm() / std::abs(std::sin(arc.half_angle));
    RC_ASSERT(std::abs((point_at(arc, fraction) - center).norm() - radius) <= kRounding * radius);
    RC_ASSERT(std::abs(std::abs(curvature(arc)) * radius - 1.0) <= kRounding);
}

// A part of an arc has the same curvature, so that its length follows from its own chord.
RC_GTEST_PROP(FilmArc, PointsDivideTheLength, ()) {
    const FilmArc arc = any_arc();
    const double fraction = *rc::gen::inRange(1, 1001) * 1e-3;
    const FilmArc part{point_at(arc, fraction), fraction * arc.half_angle};
    const double expected = fraction * arc_length(arc);
    RC_ASSERT(std::abs(arc_length(part) - expected) <= kRounding * expected);
}

// The tangents turn by twice the half angle. Each makes the half angle with the chord.
RC_GTEST_PROP(FilmArc, TangentsMakeTheHalfAngleWithTheChord, ()) {
    const FilmArc arc = any_arc();
    const Vec2 u = arc.chord.normalized();
    const Vec2 tail = tangent_at_tail(arc);
    const Vec2 head = tangent_at_head(arc);
    RC_ASSERT(std::abs(tail.norm() - 1.0) <= kRounding);
    RC_ASSERT(std::abs(head.norm() - 1.0) <= kRounding);
    RC_ASSERT(std::abs(cross(tail, u) - std::sin(arc.half_angle)) <= kRounding);
    RC_ASSERT(std::abs(tail.dot(u) - std::cos(arc.half_angle)) <= kRounding);
    RC_ASSERT(std::abs(cross(u, head) - std::sin(arc.half_angle)) <= kRounding);
    RC_ASSERT(std::abs(head.dot(u) - std::cos(arc.half_angle)) <= kRounding);
}

RC_GTEST_PROP(FilmArc, ReversedWalksTheSamePointsBackwards, ()) {
    const FilmArc arc = any_arc();
    const FilmArc back = reversed(arc);
    const double fraction = *rc::gen::inRange(0, 1001) * 1e-3;
    const double length = arc_length(arc);
    RC_ASSERT(arc_length(back) == length);
    RC_ASSERT(segment_area(back) == -segment_area(arc));
    RC_ASSERT(curvature(back) == -curvature(arc));
    RC_ASSERT((tangent_at_tail(back) + tangent_at_head(arc)).norm() <= kRounding);
    const Vec2 apart = arc.chord + point_at(back, fraction) - point_at(arc, 1.0 - fraction);
    RC_ASSERT(apart.norm() <= kRounding * length);
}

// The series of the function (asin s - s sqrt(1 - s²)) / s² (E3) and of its derivative are
//     2s/3 + s³/5 + 3s⁵/28 + ...   and   2/3 + 3s²/5 + 15s⁴/28 + ...
// At s = 1e-3 the next terms are below 1e-18.
TEST(SegmentShape, StartsAsItsSeries) {
    const double s = 1e-3;
    EXPECT_NEAR(
        segment_shape(s), 2.0 * s / 3.0 + s * s * s / 5.0 + 3.0 * std::pow(s, 5) / 28.0, kEps * s);
    EXPECT_NEAR(segment_shape_derivative(s),
                2.0 / 3.0 + 3.0 * s * s / 5.0 + 15.0 * std::pow(s, 4) / 28.0,
                kEps);
    EXPECT_EQ(segment_shape(0.0), 0.0);
    EXPECT_DOUBLE_EQ(segment_shape_derivative(0.0), 2.0 / 3.0);
}

// At s = sin(alpha) the function is (alpha - sin(2 alpha)/2) / s². The angles are 30, 45, 60 and 90
// degrees.
TEST(SegmentShape, HasItsClosedFormAtSimpleAngles) {
    EXPECT_NEAR(segment_shape(0.5), 2.0 * kPi / 3.0 - kRoot3, kRounding);
    EXPECT_NEAR(segment_shape(std::sqrt(0.5)), kPi / 2.0 - 1.0, kRounding);
    EXPECT_NEAR(segment_shape(kRoot3 / 2.0), 4.0 * kPi / 9.0 - 1.0 / kRoot3, kRounding);
    EXPECT_NEAR(segment_shape(1.0), kPi / 2.0, kRounding);
}

// The expected values are the closed form in 40 digits, for the doubles nearest to these s. They
// range from small s, where the closed form loses all digits in double precision, across the switch
// from the series at 0.25.
TEST(SegmentShape, KeepsNearlyAllDigitsEverywhere) {
    struct Case {
        double s;
        double shape;
        double slope;
    };
    for (const Case& c : {Case{0.001, 0.00066666686666677382347, 0.66666726666720238144},
                          Case{0.1, 0.066867745089780090942, 0.67272072872282240751},
                          Case{0.2499, 0.1698300992254490413, 0.70635158117565182513},
                          Case{0.25, 0.16990073606584157059, 0.7063852294505564407},
                          Case{0.2501, 0.16997137627189430195, 0.70641889438040878349},
                          Case{0.5, 0.36234429482431819878, 0.86002389746123126291},
                          Case{0.9, 0.89810939516046125137, 2.5925160214990997358}}) {
        EXPECT_NEAR(segment_shape(c.s), c.shape, 16.0 * kEps * c.shape) << c.s;
        EXPECT_NEAR(segment_shape_derivative(c.s), c.slope, 64.0 * kEps * c.slope) << c.s;
    }
}

RC_GTEST_PROP(SegmentShape, IsOddAndItsSlopeEven, ()) {
    const double s = any_real(0.999);
    RC_ASSERT(segment_shape(-s) == -segment_shape(s));
    RC_ASSERT(segment_shape_derivative(-s) == segment_shape_derivative(s));
}

TEST(SegmentShape, SlopeIsItsDerivative) {
    // With h = 1e-5, the error of the central difference, h² g'''/6, grows to 2e-9 at 0.9; rounding
    // errors are 1e-11.
    const double h = 1e-5;
    for (double s = -0.9; s < 0.95; s += 0.05) {
        const double difference = (segment_shape(s + h) - segment_shape(s - h)) / (2.0 * h);
        EXPECT_NEAR(segment_shape_derivative(s), difference, 1e-8) << s;
    }
}

// Two equal bubbles of area 1, T = 1. The films meet at 120 degrees in both junctions. The film
// between the bubbles is straight and is the chord of the outer films. Each outer film therefore
// makes 120 degrees with its chord: the half angle is 120 degrees. With sin² = 3/4 and
// sin cos = -sqrt(3)/4 the area of each bubble is
//     c²/4 (2 pi/3 + sqrt(3)/4) / (3/4) = c²/3 (2 pi/3 + sqrt(3)/4) = 1,
// and the energy is c + 2 c (2 pi/3) / (sqrt(3)/2).
TEST(FilmArc, AClusterOfTwoBubblesIsInEquilibrium) {
    const double c = std::sqrt(3.0 / (2.0 * kPi / 3.0 + kRoot3 / 4.0));
    const FilmArc wall{{0.0, c}, 0.0};
    const FilmArc right{{0.0, c}, 2.0 * kPi / 3.0};
    const FilmArc left{{0.0, c}, -2.0 * kPi / 3.0};
    const double pressure = curvature(right);
    const double energy = arc_length(wall) + arc_length(right) + arc_length(left);
    expect_vec(tangent_at_tail(wall) + tangent_at_tail(right) + tangent_at_tail(left), {0.0, 0.0});
    EXPECT_NEAR(segment_area(right), 1.0, kRounding);
    EXPECT_NEAR(segment_area(left), -1.0, kRounding);
    EXPECT_NEAR(energy, 6.359129253960, 1e-12);    // known to 13 digits
    EXPECT_NEAR(pressure, 1.589782313490, 1e-12);  // known to 13 digits
    EXPECT_NEAR(energy, 2.0 * pressure * 2.0, 4.0 * kRounding);
}

// Three equal bubbles of area 1, T = 1, around one junction O. Three straight films of length L
// separate them. An outer film connects the outer ends V and V' of two of these films. The triangle
// O V V' has an angle of 120 degrees at O, hence 30 degrees at V, and the sides L, L and sqrt(3) L.
// At V, the chord makes 150 degrees with the outward direction of the straight film, and the outer
// film makes 60 degrees with it. The half angle is the difference, 90 degrees: the outer film is a
// half circle of radius R = sqrt(3) L / 2. The area is
//     sqrt(3)/4 L² + pi R²/2 = L² (sqrt(3)/4 + 3 pi/8) = 1,
// the pressure is p = T/R, and the energy is 3 L + 3 pi R = 2 * 3 p.
TEST(FilmArc, AClusterOfThreeBubblesIsInEquilibrium) {
    const double length = 1.0 / std::sqrt(kRoot3 / 4.0 + 3.0 * kPi / 8.0);
    std::array<Vec2, 3> ends;
    for (std::size_t k = 0; k < 3; ++k) {
        const double angle = 2.0 * kPi / 3.0 * static_cast<double>(k);
        ends[k] = length * Vec2(std::cos(angle), std::sin(angle));
    }
    double energy = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const FilmArc wall{ends[k], 0.0};
        const FilmArc outer{ends[(k + 1) % 3] - ends[k], kPi / 2.0};
        const FilmArc before{ends[k] - ends[(k + 2) % 3], kPi / 2.0};
        expect_vec(tangent_at_tail(outer) - tangent_at_head(before) - tangent_at_head(wall),
                   {0.0, 0.0});
        const double triangle = 0.5 * cross(ends[k], ends[(k + 1) % 3]);
        EXPECT_NEAR(triangle + segment_area(outer), 1.0, kRounding);
        EXPECT_NEAR(curvature(outer), 2.0 / (kRoot3 * length), kRounding);
        energy += arc_length(wall) + arc_length(outer);
    }
    const double pressure = 2.0 / (kRoot3 * length);
    EXPECT_NEAR(energy, 2.0 * 3.0 * pressure, 8.0 * kRounding);
}

// The angles range from the series at 0, across 90 degrees, to nearly a full circle.
TEST(ArcShape, HasItsDerivativesByCentralDifferences) {
    constexpr double kStep = 1e-5;
    for (double angle = -2.9; angle < 2.95; angle += 0.01) {
        const ArcShape shape = arc_shape(angle);
        const ArcShape before = arc_shape(angle - kStep);
        const ArcShape after = arc_shape(angle + kStep);
        const auto slope = [](double a, double b) { return (b - a) / (2.0 * kStep); };
        const double length_slope = std::sin(angle) * shape.bulging;
        EXPECT_NEAR(slope(before.length, after.length), length_slope, 1e-6 * shape.bulging);
        EXPECT_NEAR(
            slope(before.segment, after.segment), 2.0 * shape.bulging, 1e-6 * shape.bulging);
        EXPECT_NEAR(slope(before.bulging, after.bulging),
                    shape.bulging_derivative,
                    1e-6 * (shape.bulging + std::abs(shape.bulging_derivative)));
    }
}

// The series w = 1/3 + 2/15 a² + ... follows from sin a - a cos a = a³/3 - a^5/30 and
// sin³ a = a³ (1 - a²/2).
TEST(ArcShape, AStraightFilmHasTheLimitsOfTheSeries) {
    const ArcShape shape = arc_shape(0.0);
    EXPECT_EQ(shape.length, 1.0);
    EXPECT_EQ(shape.segment, 0.0);
    EXPECT_DOUBLE_EQ(shape.bulging, 1.0 / 3.0);
    EXPECT_EQ(shape.bulging_derivative, 0.0);
    EXPECT_NEAR(arc_shape(1e-4).bulging_derivative, 4.0 / 15.0 * 1e-4, 1e-11);
}

// Compares the values on both sides of the switch between the series and the closed form.
TEST(ArcShape, IsContinuousWhereItsSeriesEnds) {
    const double at = std::asin(0.25);
    const ArcShape below = arc_shape(at - 1e-12);
    const ArcShape above = arc_shape(at + 1e-12);
    EXPECT_NEAR(below.bulging, above.bulging, 1e-12);
    EXPECT_NEAR(below.bulging_derivative, above.bulging_derivative, 1e-11);
}

// The result is exact up to rounding errors of the half angle and of h, whose derivative is 2 w.
TEST(FilmArc, HalfAngleOfSegmentIsTheInverseOfTheShape) {
    for (int k = -31; k <= 31; ++k) {
        const double angle = 0.1 * k;
        EXPECT_NEAR(half_angle_of_segment(arc_shape(angle).segment), angle, 1e-14);
    }
    for (const double distance_from_pi : {1e-2, 1e-4, 1e-6}) {
        const double angle = std::numbers::pi - distance_from_pi;
        EXPECT_NEAR(
            half_angle_of_segment(arc_shape(angle).segment), angle, 1e-8 * distance_from_pi);
    }
    EXPECT_EQ(half_angle_of_segment(0.0), 0.0);
}

/// Returns the integral of a function of the fraction of the arc from 0 to 1, by the composite
/// Gauss-Legendre rule of two points on 2000 intervals. Its error is of the order of 1e-14.
template <class Value>
auto integral(const Value& value) {
    constexpr int kIntervals = 2000;
    const double offset = 0.5 / std::sqrt(3.0);
    auto sum = value(0.0);
    sum *= 0.0;
    for (int k = 0; k < kIntervals; ++k) {
        sum += value((k + 0.5 - offset) / kIntervals) + value((k + 0.5 + offset) / kIntervals);
    }
    sum *= 0.5 / kIntervals;
    return sum;
}

Mat2 integrated_tangents(const FilmArc& arc) {
    const double angle = std::atan2(arc.chord.y(), arc.chord.x());
    return integral([&](double fraction) {
        const Vec2 t = unit_vector(angle + (2.0 * fraction - 1.0) * arc.half_angle);
        return Mat2(arc_length(arc) * t * t.transpose());
    });
}

RC_GTEST_PROP(FilmArc, TangentTensorIsTheIntegralOverTheArc, ()) {
    const FilmArc arc = any_arc();
    const double tolerance = 1e-12 * arc_length(arc);
    const Mat2 tensor = tangent_tensor(arc);
    RC_ASSERT((tensor - integrated_tangents(arc)).norm() < tolerance);
    RC_ASSERT(std::abs(tensor.trace() - arc_length(arc)) < tolerance);
    RC_ASSERT((tensor - tangent_tensor(reversed(arc))).norm() < tolerance);
}

TEST(FilmArc, TangentTensorIsAccurateNearAStraightFilmAndAFullCircle) {
    for (const double angle : {0.0, 1e-9, 1e-4, -1e-2, 0.2499, 0.2501, 1.5707, 1.5709, 3.141}) {
        const FilmArc arc{{0.6, -0.8}, angle};
        EXPECT_LT((tangent_tensor(arc) - integrated_tangents(arc)).norm(), 1e-12 * arc_length(arc))
            << angle;
    }
    EXPECT_EQ(tangent_tensor({{0.0, 0.0}, 1.0}).norm(), 0.0);
}

// By the divergence theorem, the integral of a polynomial over the segment is an integral along its
// border. On the chord y = 0, and the arc runs from tail to head on the right of the chord. With
// the normal n = (dy, -dx) the integral of y^k over the area is that of -y^(k+1) / (k+1) dx, and
// the integral of x² that of -x² y dx.
void expect_integrated_moments(double half_angle) {
    const FilmArc arc{{1.5, 0.0}, half_angle};
    const auto along_arc = [&](const auto& value) {
        return integral([&](double fraction) {
            const Vec2 at = point_at(arc, fraction) - 0.5 * arc.chord;
            const double dx = arc_length(arc) * std::cos((2.0 * fraction - 1.0) * half_angle);
            return value(at.x(), at.y()) * dx;
        });
    };
    const SegmentMoments moments = segment_moments(arc);
    const double size = std::pow(std::max(1.5, 1.5 / std::sin(std::abs(half_angle))), 4);
    const double tolerance = 1e-13 * size;
    EXPECT_EQ(moments.area, segment_area(arc));
    const double y = along_arc([](double, double v) { return -v * v / 2.0; });
    EXPECT_NEAR(moments.y, y, tolerance) << half_angle;
    const double xx = along_arc([](double u, double v) { return -u * u * v; });
    EXPECT_NEAR(moments.xx, xx, tolerance) << half_angle;
    const double yy = along_arc([](double, double v) { return -v * v * v / 3.0; });
    EXPECT_NEAR(moments.yy, yy, tolerance) << half_angle;
}

TEST(FilmArc, SegmentMomentsAreTheIntegralsOverTheSegment) {
    for (const double angle : {1e-7, 1e-3, 0.1, 0.2526, 0.2528, 1.0, 1.57, 1.58, 2.5, 3.1}) {
        expect_integrated_moments(angle);
        expect_integrated_moments(-angle);
    }
}

// The half disc below the chord has the moments -2/3 r³, pi/8 r^4 and pi/8 r^4.
TEST(FilmArc, SegmentMomentsAreKnownForAHalfDisc) {
    const SegmentMoments moments = segment_moments({{2.0, 0.0}, kPi / 2.0});
    EXPECT_NEAR(moments.area, kPi / 2.0, kRounding);
    EXPECT_NEAR(moments.y, -2.0 / 3.0, kRounding);
    EXPECT_NEAR(moments.xx, kPi / 8.0, kRounding);
    EXPECT_NEAR(moments.yy, kPi / 8.0, kRounding);
}

}  // namespace
}  // namespace foam
