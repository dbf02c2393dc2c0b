// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <array>
#include <vector>

namespace foam::texgen {

/// A cubic Bézier curve. It starts at the end of the preceding curve or, if it is the first curve,
/// at the start of the subpath. A straight line has its control points on the line.
struct CubicCurve {
    Vec2 control_1;
    Vec2 control_2;
    Vec2 end;
};

/// A closed chain of curves. A line closes it if the last curve does not end at the start.
struct Subpath {
    Vec2 start;
    std::vector<CubicCurve> curves{};

    const Vec2& end() const { return curves.empty() ? start : curves.back().end; }
    void add_line(const Vec2& to) {
        const Vec2 from = end();
        curves.push_back({from + (to - from) / 3.0, to - (to - from) / 3.0, to});
    }
    void add_quadratic(const Vec2& control, const Vec2& to) {
        const Vec2 from = end();
        curves.push_back(
            {from + (control - from) * (2.0 / 3.0), to + (control - to) * (2.0 / 3.0), to});
    }
};

using BezierPath = std::vector<Subpath>;

/// An elliptical arc, described as in an SVG path. It starts at the end of the subpath to which it
/// is appended (add_arc).
struct EllipticalArc {
    Vec2 radii;
    double rotation = 0.0;  // angle from the x axis to the first radius, in radians
    bool is_large = false;  // true if the arc is more than half of the ellipse
    // True if angles increase along the arc. Angles increase from the x axis to the y axis.
    bool is_positive = false;
    Vec2 end;
};

/// Appends an elliptical arc as one to four curves (implementation notes of SVG 1.1, F.6). The
/// curves deviate from the arc by at most 0.03 % of the larger radius. If the radii are too small
/// for an ellipse through the start and the end, both are multiplied by the same factor. An arc
/// with a radius of 0 is a line.
void add_arc(Subpath& path, const EllipticalArc& arc);

/// An affine map: (x, y) becomes (a x + c y + e, b x + d y + f).
struct AffineMap {
    std::array<double, 6> abcdef{1.0, 0.0, 0.0, 1.0, 0.0, 0.0};

    static AffineMap translation(double x, double y) { return {{1.0, 0.0, 0.0, 1.0, x, y}}; }

    Vec2 operator()(const Vec2& point) const;
    /// Returns the map that applies `inner` first, then this map.
    AffineMap operator*(const AffineMap& inner) const;
};

/// Returns the image of the path under a map.
BezierPath mapped(BezierPath path, const AffineMap& map);

/// Returns the corners of a polygon along a closed path. Each curve is divided into so many pieces
/// that the polygon deviates from the curve by at most `tolerance`. A curve that needs more than 64
/// pieces is divided into 64, and the deviation may be larger.
std::vector<Vec2> flattened(const Subpath& path, double tolerance);

}  // namespace foam::texgen
