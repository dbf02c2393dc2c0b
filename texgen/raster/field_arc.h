#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>

namespace foam::texgen {

/// A function of the plane: at p + d it is value + gradient d - curvature / 2 d², seen from p. If
/// it is 0 on a line or circle, and has a slope of 1 there, its distance left of that is
/// 2 value / (1 + |gradient|), whatever the curvature, and grows along the gradient.
struct Quadratic {
    double value = 0.0;
    Vec2 gradient{0.0, 0.0};
    double curvature = 0.0;
};

/// An arc placed in the plane, for distances from it. It is given by its chord, so that no centre
/// is far away; pixels.
struct FieldArc {
    Vec2 middle{0.0, 0.0};     // of the chord
    Vec2 direction{0.0, 0.0};  // of the chord, a unit vector
    double chord = 0.0;
    double cosine = 1.0;  // of the half angle
    double sine = 0.0;
};

/// Precondition: the chord is not zero.
FieldArc field_arc(const PixelArc& arc, const Vec2& tail);

/// The two of the pencil of circles through both ends that are, at these, normal to each other,
/// each with a slope of 1: `across` is 0 on the arc's own circle, positive on the left, `along` on
/// the circle that cuts the arc off there, positive on the arc.
struct Pencil {
    Quadratic across;
    Quadratic along;
};
Pencil pencil_at(const FieldArc& arc, const Vec2& point);

/// The tangents at the ends.
Vec2 tail_tangent(const FieldArc& arc);
Vec2 head_tangent(const FieldArc& arc);

/// Its two halves, of equal length; the first begins at the tail.
std::array<FieldArc, 2> halves(const FieldArc& arc);

/// From a point to the nearest point of an arc that turns by no more than 180 degrees.
double distance(const FieldArc& arc, const Vec2& point);

}  // namespace foam::texgen
