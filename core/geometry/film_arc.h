#pragma once

#include "core/geometry/vec2.h"

namespace foam {

/// A film as a circular arc from its tail to its head (E1).
/// A positive half angle bulges to the right of the chord and adds to the area on its left, as a
/// higher pressure on the left does. |half_angle| < pi; a zero chord is an arc of no length.
struct FilmArc {
    Vec2 chord{0.0, 0.0};     // head minus tail, foam units
    double half_angle = 0.0;  // radians; half the angle by which the tangent turns left
};

/// c alpha / sin alpha.
double arc_length(const FilmArc& arc);

/// Area between the chord and the arc, counted for the left side (E1).
double segment_area(const FilmArc& arc);

/// Signed curvature, positive where the arc turns left; 0 for a zero chord.
double curvature(const FilmArc& arc);

/// Unit tangents in the sense from tail to head. Precondition: the chord is not zero.
Vec2 tangent_at_tail(const FilmArc& arc);
Vec2 tangent_at_head(const FilmArc& arc);

/// The point of the arc at a fraction of its length, relative to the tail.
Vec2 point_at(const FilmArc& arc, double fraction);

/// The same arc walked from head to tail.
inline FilmArc reversed(const FilmArc& arc) {
    return {-arc.chord, -arc.half_angle};
}

/// (asin s - s sqrt(1 - s²)) / s² for s = sin alpha: four times the segment area over the chord
/// squared (E1). Accurate to a few units of the last place for |s| <= 1, by a series where the
/// terms cancel.
double segment_shape(double s);

/// Derivative of segment_shape, the function g' of E3. Precondition: |s| < 1.
double segment_shape_slope(double s);

/// The shape of an arc as functions of its half angle alpha, on the whole range (-pi, pi):
///     length = c q(alpha),  segment area = c²/4 h(alpha),  q' = sin(alpha) w,  h' = 2 w.
struct ArcShape {
    double length = 1.0;              // q = alpha / sin alpha
    double segment = 0.0;             // h = (alpha - sin alpha cos alpha) / sin² alpha
    double bulging = 1.0 / 3.0;       // w = (sin alpha - alpha cos alpha) / sin³ alpha, positive
    double bulging_derivative = 0.0;  // w'
};

ArcShape arc_shape(double half_angle);

/// The half angle of an arc whose ArcShape::segment is h, within (-pi, pi).
double half_angle_of_segment(double h);

}  // namespace foam
