#include "texgen/raster/field_arc.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

FieldArc field_arc(const PixelArc& arc, const Vec2& tail) {
    const double chord = arc.chord.norm();
    return {tail + 0.5 * arc.chord, arc.chord / chord, chord, arc.cosine, arc.sine};
}

// With e = c/4 - |q|²/c, which is 0 on the circle around the chord, and h = q's distance to the
// left of the chord: both are 0 at the ends. Turned by the half angle they follow the arc.
Pencil pencil_at(const FieldArc& arc, const Vec2& point) {
    const Vec2 q = point - arc.middle;
    const Vec2 normal = turned_left(arc.direction);
    const double e = 0.25 * arc.chord - q.squaredNorm() / arc.chord;
    const double h = normal.dot(q);
    const Vec2 e_gradient = -2.0 / arc.chord * q;
    return {{arc.sine * e + arc.cosine * h,
             arc.sine * e_gradient + arc.cosine * normal,
             2.0 * arc.sine / arc.chord},
            {arc.cosine * e - arc.sine * h,
             arc.cosine * e_gradient - arc.sine * normal,
             2.0 * arc.cosine / arc.chord}};
}

Vec2 tail_tangent(const FieldArc& arc) {
    return arc.cosine * arc.direction - arc.sine * turned_left(arc.direction);
}

Vec2 head_tangent(const FieldArc& arc) {
    return arc.cosine * arc.direction + arc.sine * turned_left(arc.direction);
}

// The middle of the arc lies the sagitta, c/2 tan(half of the half angle), right of the chord.
std::array<FieldArc, 2> halves(const FieldArc& arc) {
    const double cosine = std::sqrt(0.5 * (1.0 + arc.cosine));
    const double sine = 0.5 * arc.sine / cosine;
    const Vec2 normal = turned_left(arc.direction);
    const double chord = 0.5 * arc.chord / cosine;
    const Vec2 quarter = 0.25 * arc.chord * arc.direction;
    const Vec2 out = -0.25 * arc.chord * sine / cosine * normal;
    return {
        {{arc.middle - quarter + out, cosine * arc.direction - sine * normal, chord, cosine, sine},
         {arc.middle + quarter + out,
          cosine * arc.direction + sine * normal,
          chord,
          cosine,
          sine}}};
}

double distance(const FieldArc& arc, const Vec2& point) {
    const Vec2 q = point - arc.middle;
    const Vec2 half_chord = 0.5 * arc.chord * arc.direction;
    if (tail_tangent(arc).dot(q + half_chord) >= 0.0 &&
        head_tangent(arc).dot(q - half_chord) <= 0.0) {
        const Quadratic across = pencil_at(arc, point).across;
        return std::abs(2.0 * across.value) / (1.0 + across.gradient.norm());
    }
    return std::sqrt(std::min((q - half_chord).squaredNorm(), (q + half_chord).squaredNorm()));
}

}  // namespace foam::texgen
