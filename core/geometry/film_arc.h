// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

namespace foam {

/// A film as a circular arc from its tail to its head (E1 in core/EQUATIONS.md). An arc with a
/// positive half angle bulges to the right of the chord and adds to the area on its left. In
/// equilibrium, the pressure on its left is then the higher one. The half angle is in (-pi, pi). If
/// the chord is zero, the length of the arc is zero, too.
struct FilmArc {
    Vec2 chord{0.0, 0.0};     // head minus tail, foam units
    double half_angle = 0.0;  // radians; half of the angle by which the arc turns left
};

/// Returns the length of the arc, c alpha / sin alpha, with c the length of the chord and alpha the
/// half angle.
double arc_length(const FilmArc& arc);

/// Returns the area between the chord and the arc (E1). The area is positive if it adds to the area
/// on the left of the arc.
double segment_area(const FilmArc& arc);

/// Returns the signed curvature (1 / radius), which is positive if the arc, followed from tail to
/// head, turns left. Returns 0 if the chord is zero.
double curvature(const FilmArc& arc);

/// Returns the unit tangent at the tail, in the direction from tail to head. Precondition: the
/// chord is not zero.
Vec2 tangent_at_tail(const FilmArc& arc);
/// Returns the unit tangent at the head, in the direction from tail to head. Precondition: the
/// chord is not zero.
Vec2 tangent_at_head(const FilmArc& arc);

/// Returns the vector from the tail to the point of the arc at the given fraction of its length,
/// measured from the tail.
Vec2 point_at(const FilmArc& arc, double fraction);

/// Returns the integral of t tᵀ over the length of the arc, where t is the unit tangent (E11). The
/// trace of this tensor is the length of the arc. The reversed arc has the same tensor.
Mat2 tangent_tensor(const FilmArc& arc);

/// Moments of area of the segment between an arc and its chord. Coordinates are relative to the
/// middle of the chord: x along the chord, y to its left. As in segment_area, the integrals count
/// with a negative sign if the segment is on the left of the chord. The moments of a bubble are
/// therefore the moments of its polygon plus the moments of the segments of its films. The moments
/// of x and of xy are 0 by symmetry.
struct SegmentMoments {
    double area = 0.0;  // segment_area
    double y = 0.0;     // integral of y
    double xx = 0.0;    // integral of x²
    double yy = 0.0;    // integral of y²
};

/// Returns the moments of the segment of an arc.
SegmentMoments segment_moments(const FilmArc& arc);

/// Returns the same arc in the direction from head to tail.
inline FilmArc reversed(const FilmArc& arc) {
    return {-arc.chord, -arc.half_angle};
}

/// Returns the function g of E3, (asin s - s sqrt(1 - s²)) / s². For an arc of half angle asin s,
/// g is four times the segment area divided by the square of the chord length. Near s = 0, where
/// the two terms nearly cancel, a series is used instead. The relative error is below 1e-14.
/// Precondition: |s| <= 1.
double segment_shape(double s);

/// Returns the derivative of segment_shape, the function g' of E3. Precondition: |s| < 1.
double segment_shape_derivative(double s);

/// The shape of an arc as functions q, h and w of its half angle alpha in (-pi, pi) (E3). A prime
/// denotes the derivative with respect to alpha. With c the length of the chord:
///     length = c q(alpha),  segment area = c²/4 h(alpha),  q' = sin(alpha) w,  h' = 2 w.
struct ArcShape {
    double length = 1.0;              // q = alpha / sin alpha
    double segment = 0.0;             // h = (alpha - sin alpha cos alpha) / sin² alpha
    double bulging = 1.0 / 3.0;       // w = (sin alpha - alpha cos alpha) / sin³ alpha, positive
    double bulging_derivative = 0.0;  // w'
};

/// Returns the shape of an arc with the given half angle.
ArcShape arc_shape(double half_angle);

/// Returns the half angle, in (-pi, pi), of the arc whose ArcShape::segment is h.
double half_angle_of_segment(double h);

}  // namespace foam
