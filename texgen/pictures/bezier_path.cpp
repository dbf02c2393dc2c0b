// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/bezier_path.h"

#include "core/geometry/trigonometric.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace foam::texgen {

namespace {

constexpr double kMaxPieces = 64.0;  // largest number of lines that replace a curve
constexpr double kQuarterTurn = std::numbers::pi / 2.0;

// The center parameterization of an elliptical arc. The point at an angle is
// center + turned(radii * (cos angle, sin angle), rotation).
struct CenteredArc {
    Vec2 center;
    Vec2 radii;
    double rotation;
    double first;  // the angle at the start
    double sweep;  // the angle at the end minus `first`
};

Vec2 turned(const Vec2& v, double angle) {
    const Vec2 axis = unit_vector(angle);
    return {axis.x() * v.x() - axis.y() * v.y(), axis.y() * v.x() + axis.x() * v.y()};
}

double angle_of(const Vec2& v) {
    return ieee::atan2(v.y(), v.x());
}

// Returns the angle from the direction `first` to the direction `last`: from 0 to 2 pi if
// `is_positive`, otherwise from -2 pi to 0.
double sweep_between(double first, double last, bool is_positive) {
    const double sweep = last - first;
    if (is_positive) {
        return sweep < 0.0 ? sweep + 2.0 * std::numbers::pi : sweep;
    }
    return sweep > 0.0 ? sweep - 2.0 * std::numbers::pi : sweep;
}

// Precondition: the radii are positive.
CenteredArc centered(const Vec2& start, const EllipticalArc& arc) {
    const Vec2 half = turned(0.5 * (start - arc.end), -arc.rotation);
    const double excess = half.cwiseQuotient(arc.radii).squaredNorm();
    const Vec2 radii = arc.radii * std::sqrt(std::max(1.0, excess));
    // The ellipse is mapped to the unit circle, and the midpoint of the chord to the origin. There,
    // `to_start` is the vector from the origin to the start of the arc. The vector from the origin
    // to the center of the circle is at a right angle to `to_start`.
    const Vec2 to_start = half.cwiseQuotient(radii);
    const double square = to_start.squaredNorm();
    const double distance = square > 0.0 ? std::sqrt(std::max(0.0, 1.0 / square - 1.0)) : 0.0;
    const double side = arc.is_large != arc.is_positive ? 1.0 : -1.0;
    const Vec2 center = side * distance * Vec2(to_start.y(), -to_start.x());
    const double first = angle_of(to_start - center);
    const double last = angle_of(-to_start - center);
    return {turned(center.cwiseProduct(radii), arc.rotation) + 0.5 * (start + arc.end),
            radii,
            arc.rotation,
            first,
            sweep_between(first, last, arc.is_positive)};
}

}  // namespace

void add_arc(Subpath& path, const EllipticalArc& arc) {
    const Vec2 start = path.end();
    if (!(arc.radii.minCoeff() > 0.0) || start == arc.end) {
        path.add_line(arc.end);
        return;
    }
    const CenteredArc centered_arc = centered(start, arc);
    const int pieces =
        std::clamp(static_cast<int>(std::ceil(std::abs(centered_arc.sweep) / kQuarterTurn)), 1, 4);
    const double step = centered_arc.sweep / pieces;
    // The distance of a control point from its end of the curve, on the unit circle.
    const double handle_length = 4.0 / 3.0 * ieee::tan(0.25 * step);
    const auto point = [&](const Vec2& on_circle) {
        return Vec2(centered_arc.center +
                    turned(on_circle.cwiseProduct(centered_arc.radii), centered_arc.rotation));
    };
    for (int k = 0; k < pieces; ++k) {
        const Vec2 a = unit_vector(centered_arc.first + k * step);
        const Vec2 b = unit_vector(centered_arc.first + (k + 1) * step);
        path.curves.push_back({point(a + handle_length * turned_left(a)),
                               point(b - handle_length * turned_left(b)),
                               k + 1 == pieces ? arc.end : point(b)});
    }
}

Vec2 AffineMap::operator()(const Vec2& point) const {
    const auto& [a, b, c, d, e, f] = abcdef;
    return {a * point.x() + c * point.y() + e, b * point.x() + d * point.y() + f};
}

AffineMap AffineMap::operator*(const AffineMap& inner) const {
    const auto& [a, b, c, d, e, f] = inner.abcdef;
    const Vec2 origin = (*this)({e, f});
    const Vec2 x = (*this)({a, b}) - (*this)({0.0, 0.0});
    const Vec2 y = (*this)({c, d}) - (*this)({0.0, 0.0});
    return {{x.x(), x.y(), y.x(), y.y(), origin.x(), origin.y()}};
}

BezierPath mapped(BezierPath path, const AffineMap& map) {
    for (Subpath& part : path) {
        part.start = map(part.start);
        for (CubicCurve& curve : part.curves) {
            curve = {map(curve.control_1), map(curve.control_2), map(curve.end)};
        }
    }
    return path;
}

std::vector<Vec2> flattened(const Subpath& path, double tolerance) {
    std::vector<Vec2> corners{path.start};
    for (const CubicCurve& curve : path.curves) {
        const Vec2 from = corners.back();
        // Let n lines replace a curve B, one for each of n equal ranges of its parameter. They
        // deviate from the curve by at most |B''| / (8 n²). The length of the second derivative B''
        // is at most six times the length of the larger second difference of the control points.
        const double bend = std::max((from - 2.0 * curve.control_1 + curve.control_2).norm(),
                                     (curve.control_1 - 2.0 * curve.control_2 + curve.end).norm());
        const auto pieces = static_cast<int>(
            std::clamp(std::ceil(std::sqrt(0.75 * bend / tolerance)), 1.0, kMaxPieces));
        for (int k = 1; k < pieces; ++k) {
            const double t = static_cast<double>(k) / pieces;
            const double s = 1.0 - t;
            corners.push_back(s * s * s * from + 3.0 * s * s * t * curve.control_1 +
                              3.0 * s * t * t * curve.control_2 + t * t * t * curve.end);
        }
        corners.push_back(curve.end);
    }
    return corners;
}

}  // namespace foam::texgen
