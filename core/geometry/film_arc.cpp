// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/film_arc.h"

#include "core/geometry/elementary.h"

#include <array>
#include <cmath>
#include <numbers>

// Most functions of an arc have closed forms (E1 and E3 in core/EQUATIONS.md) in which terms nearly
// cancel if the film is nearly straight. A film is nearly straight if its half angle alpha is near
// 0. The functions of such films are evaluated as power series in s = sin alpha. The coefficients
// of these series follow from the coefficients of the binomial series of 1/sqrt(1 - s²).

namespace foam {

namespace {

// If |s| is below this limit, series replace the closed forms, which lose accuracy by cancellation.
constexpr double kSeriesLimit = 0.25;
// Number of terms of each series. The truncation error is less than 1e-17, or less than 2e-16 for
// kShapeSecondDerivative.
constexpr int kSeriesTerms = 14;

constexpr double kHalfPi = 0.5 * std::numbers::pi;
// If h (ArcShape::segment) is at least this number, alpha = pi - sqrt(pi / h) with an error of less
// than 1e-12.
constexpr double kNearlyFullCircle = 1e8;
// Number of Newton iterations of half_angle_of_segment. After these iterations its result is
// accurate to rounding.
constexpr int kSegmentIterations = 5;

using Series = std::array<double, kSeriesTerms>;

// Returns, for each k, weight(k) times the coefficient of s^(2k) in the series of 1/sqrt(1 - s²).
template <class Weight>
constexpr Series weighted_series(Weight weight) {
    Series series{};
    double coefficient = 1.0;
    for (int k = 0; k < kSeriesTerms; ++k) {
        series[static_cast<std::size_t>(k)] = weight(k) * coefficient;
        coefficient *= (2.0 * k + 1.0) / (2.0 * k + 2.0);
    }
    return series;
}

// The series of segment_shape(s) / s.
constexpr Series kShape = weighted_series([](int k) { return 2.0 / (2 * k + 3); });
// The series of segment_shape_derivative(s).
constexpr Series kShapeDerivative =
    weighted_series([](int k) { return 2.0 * (2 * k + 1) / (2 * k + 3); });
// The series of (d/ds segment_shape_derivative(s)) / s.
constexpr Series kShapeSecondDerivative =
    weighted_series([](int k) { return 2.0 * (2 * k + 1) * (2 * k + 3) / (2 * k + 5); });
// The series of xx / s, where xx is the first result of second_moment_shape.
constexpr Series kXxShape = weighted_series([](int k) { return 2.0 / (3 * (2 * k + 5)); });
// The series of yy / s³, where yy is the second result of second_moment_shape.
constexpr Series kYyShape =
    weighted_series([](int k) { return 4.0 * (2 * k + 1) / (3.0 * (2 * k + 5) * (2 * k + 7)); });

// Returns the sum over k of series[k] s^(2k), by Horner's rule. Coefficients of even k and of odd k
// are summed separately, so that the two chains of dependent operations overlap.
double sum_of(const Series& series, double s) {
    const double square = s * s;
    const double fourth = square * square;
    double even = 0.0;
    double odd = 0.0;
    for (std::size_t k = series.size(); k > 0; k -= 2) {
        odd = odd * fourth + series[k - 1];
        even = even * fourth + series[k - 2];
    }
    return even + square * odd;
}

Vec2 rotated(const Vec2& v, double angle) {
    const auto [s, c] = ieee::sincos(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

double angle_over_sine(double angle) {
    return angle == 0.0 ? 1.0 : angle / ieee::sin(angle);
}

// Returns (alpha - sin alpha cos alpha) / sin² alpha, for alpha = `half_angle` in (-pi, pi).
double segment_shape_of_angle(double half_angle) {
    const auto [s, c] = ieee::sincos(half_angle);
    if (c > 0.0 && std::abs(s) < kSeriesLimit) {
        return segment_shape(s);
    }
    // segment_shape(s) is not used here: asin(s) is ill-conditioned at 90 degrees, and is not the
    // half angle beyond 90 degrees.
    return (half_angle - s * c) / (s * s);
}

// Returns xx and yy of segment_moments, both divided by (chord length)⁴ / 16.
Vec2 second_moment_shape(double half_angle) {
    const auto [s, c] = ieee::sincos(half_angle);
    if (c > 0.0 && std::abs(s) < kSeriesLimit) {
        return {s * sum_of(kXxShape, s), s * s * s * sum_of(kYyShape, s)};
    }
    const double square = s * s;
    const double turn = half_angle - s * c;
    return {(turn / 4.0 - square * s * c / 6.0) / (square * square),
            (1.25 * turn - square * (half_angle - s * c / 6.0)) / (square * square)};
}

}  // namespace

double segment_shape(double s) {
    if (std::abs(s) < kSeriesLimit) {
        return s * sum_of(kShape, s);
    }
    return (ieee::asin(s) - s * std::sqrt((1.0 - s) * (1.0 + s))) / (s * s);
}

double segment_shape_derivative(double s) {
    if (std::abs(s) < kSeriesLimit) {
        return sum_of(kShapeDerivative, s);
    }
    return 2.0 / std::sqrt((1.0 - s) * (1.0 + s)) - 2.0 * segment_shape(s) / s;
}

// If the film is nearly straight, w = cos(alpha) segment_shape_derivative(sin alpha) / 2 is
// computed from a series. This formula follows from 2 w = h' and h = segment_shape(sin alpha). The
// derivative of this formula with respect to alpha is w'.
ArcShape arc_shape(double half_angle) {
    const auto [s, c] = ieee::sincos(half_angle);
    ArcShape shape{
        s == 0.0 ? 1.0 : half_angle / s, segment_shape_of_angle(half_angle), 1.0 / 3.0, 0.0};
    if (c > 0.0 && std::abs(s) < kSeriesLimit) {
        const double derivative = sum_of(kShapeDerivative, s);
        shape.bulging = 0.5 * c * derivative;
        shape.bulging_derivative =
            0.5 * s * (c * c * sum_of(kShapeSecondDerivative, s) - derivative);
        return shape;
    }
    const double excess = s - half_angle * c;
    shape.bulging = excess / (s * s * s);
    shape.bulging_derivative = (half_angle * s * s - 3.0 * c * excess) / (s * s * s * s);
    return shape;
}

// Uses Newton's method. Up to 90 degrees it is applied to h, whose slope grows only from 2/3 to 2
// there. Beyond 90 degrees it is applied to h^(-1/2), which is nearly linear in alpha up to 180
// degrees. Near 180 degrees, h^(-1/2) approaches sin(alpha) / sqrt(pi).
double half_angle_of_segment(double h) {
    const double size = std::abs(h);
    const bool is_low = size < kHalfPi;  // kHalfPi is h at 90 degrees
    double angle = is_low ? size * (1.5 - 0.5 * size / kHalfPi)
                          : 2.0 * kHalfPi - std::sqrt(2.0 * kHalfPi / size);
    for (int k = 0; k < kSegmentIterations && size < kNearlyFullCircle; ++k) {
        const ArcShape shape = arc_shape(angle);
        const double root = std::sqrt(shape.segment);
        angle += is_low
                     ? 0.5 * (size - shape.segment) / shape.bulging
                     : (1.0 / root - 1.0 / std::sqrt(size)) * root * shape.segment / shape.bulging;
    }
    return std::copysign(angle, h);
}

double arc_length(const FilmArc& arc) {
    return arc.chord.norm() * angle_over_sine(arc.half_angle);
}

double segment_area(const FilmArc& arc) {
    return 0.25 * arc.chord.squaredNorm() * segment_shape_of_angle(arc.half_angle);
}

// The tangent has the angle of the chord plus an angle from -alpha to alpha. The integral is the
// length times the mean of t tᵀ over these angles.
Mat2 tangent_tensor(const FilmArc& arc) {
    const double c = arc.chord.norm();
    if (c == 0.0) {
        return Mat2::Zero();
    }
    const double cosine = ieee::cos(arc.half_angle);
    return 0.5 * (arc_length(arc) - c * cosine) * Mat2::Identity() +
           cosine / c * arc.chord * arc.chord.transpose();
}

SegmentMoments segment_moments(const FilmArc& arc) {
    const double square = arc.chord.squaredNorm();
    const Vec2 second = square * square / 16.0 * second_moment_shape(arc.half_angle);
    const double bulging = arc_shape(arc.half_angle).bulging;
    return {segment_area(arc),
            -0.125 * square * std::sqrt(square) * (bulging - 1.0 / 3.0),
            second.x(),
            second.y()};
}

double curvature(const FilmArc& arc) {
    const double c = arc.chord.norm();
    return c == 0.0 ? 0.0 : 2.0 * ieee::sin(arc.half_angle) / c;
}

Vec2 tangent_at_tail(const FilmArc& arc) {
    return rotated(arc.chord.normalized(), -arc.half_angle);
}

Vec2 tangent_at_head(const FilmArc& arc) {
    return rotated(arc.chord.normalized(), arc.half_angle);
}

Vec2 point_at(const FilmArc& arc, double fraction) {
    // The vector from the tail to the point is the chord, rotated by (fraction - 1) times the half
    // angle and scaled.
    const double scale =
        fraction * angle_over_sine(arc.half_angle) / angle_over_sine(fraction * arc.half_angle);
    return scale * rotated(arc.chord, (fraction - 1.0) * arc.half_angle);
}

}  // namespace foam
