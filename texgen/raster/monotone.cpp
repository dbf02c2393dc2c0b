#include "texgen/raster/monotone.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

// Whether an arc of less than half a turn goes back neither in x nor in y: all its tangents lie
// between those at its ends.
bool is_monotone(const Vec2& chord, double cosine, double sine) {
    const Vec2 along = cosine * chord;
    const Vec2 across = sine * turned_left(chord);
    const Vec2 first = along - across;
    const Vec2 last = along + across;
    return cosine > 0.0 && first.x() * last.x() >= 0.0 && first.y() * last.y() >= 0.0;
}

}  // namespace

MonotonePieces::MonotonePieces(const FilmArc& arc) {
    const double sine = std::sin(arc.half_angle);
    if (is_monotone(arc.chord, std::cos(arc.half_angle), sine)) {
        append(arc.chord, sine);
    } else {
        split(arc, sine);
    }
}

// Where the tangent is parallel to an axis. The chord from the tail to where it has turned by an
// angle t is, with r the radius, 2 r sin(t / 2) long and turned by t / 2 from the tangent there.
void MonotonePieces::split(const FilmArc& arc, double sine) {
    const double direction = std::atan2(arc.chord.y(), arc.chord.x());
    const double first = direction - arc.half_angle;
    const double last = direction + arc.half_angle;
    const double sign = arc.half_angle < 0.0 ? -1.0 : 1.0;
    const double diameter = arc.chord.norm() / std::abs(sine);
    double from = first;
    double quarter = sign * (std::floor(sign * first / kQuarter) + 1.0);
    for (; sign * (quarter * kQuarter - last) < 0.0; quarter += sign) {
        const double to = quarter * kQuarter;
        const double turn = to - first;
        const double length = diameter * std::sin(0.5 * std::abs(turn));
        const double angle = first + 0.5 * turn;
        append(length * Vec2(std::cos(angle), std::sin(angle)), std::sin(0.5 * (to - from)));
        from = to;
    }
    append(arc.chord, std::sin(0.5 * (last - from)));
}

}  // namespace foam::texgen
